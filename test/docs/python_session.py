#!/usr/bin/python3
"""usage: python_session.py OUTPUT: runs Python as a reader types it into one interpreter.

Reads names of files from the standard input, one a line. Runs each file, writes what it prints to the file OUTPUT, and
prints 0, or 1 if the file raised an exception.
"""
import contextlib
import sys
import traceback


def run(path, names):
    with open(path) as source:
        code = compile(source.read(), 'python', 'exec')
    try:
        exec(code, names)
        return 0
    except Exception:
        traceback.print_exc()
        return 1


def main():
    names = {'__name__': '__main__'}
    for line in sys.stdin:
        with open(sys.argv[1], 'w') as output, contextlib.redirect_stdout(output), contextlib.redirect_stderr(output):
            result = run(line.rstrip('\n'), names)
        print(result, flush=True)


if __name__ == '__main__':
    main()
