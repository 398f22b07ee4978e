#!/usr/bin/python3
"""usage: run_document.py [--rewrite] SOURCE_DIR DOCUMENT...: runs documents as a reader does, and checks what they show.

The commands of a document run in order in one bash, in a temporary folder with links to all of the repository and an
`out` of its own, after `source scripts/env.bash`. Blocks of Python run in one interpreter. A block whose first line is
a comment with a path is saved there instead. `roscore` and `roslaunch` go on in the background, without RViz, until the
next one or the end: a reader has them in a terminal of their own. arrangements.py lists what else differs.

A command must end with exit code 0, or with N where a comment `# exit code N` is at its end. A block ```text after a
block of commands or of Python is all that the block before prints (shown.py says what `...` stands for), without lines
that vary from run to run (UNCOUNTED). --rewrite puts the printed output into the document where it shows another one.
"""
import argparse
import json
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from xmlrpc.client import ServerProxy

from arrangements import DATAROOT, EARLIER, INSTEAD, LEFT_OUT, NOT_RUN, SCENES, VERSIONS
from blocks import blocks, commands, with_outputs
from shown import difference, matches, rewritten

TIMEOUT = 300.0       # s that a command may take
READY_TIMEOUT = 60.0  # s until a launched suite responds
SHOWN = 3000          # characters of output in an error
OWN = ('.git', '.pytest_cache', 'out')  # entries of the repository that are not linked
SERVICES = {'planner_test.launch': ['/test_planner']}
ALL_SERVICES = ['/generate_collision', '/list_collisions', '/test_planner', '/reset']
PYTHON_SESSION = Path(__file__).resolve().parent / 'python_session.py'
# Progress lines, which a terminal overwrites; bash's message on a program that the document has ended; rospy's warnings
# about connections that come too early or too late.
UNCOUNTED = re.compile(r'^(\S[\w /.-]* \d+ %.* (left|in \d+ \w+)|\S+: line \d+: +\d+ (Terminated|Killed) .*|'
                       r'\[WARN\] \[[\d.]+\]: .*)\n', re.MULTILINE)


class Failed(Exception):
    pass


class Shell:
    """One bash for all commands of a document."""

    def __init__(self, folder):
        self.folder, self.launched, self.has_python = folder, None, False
        with socket.socket() as free:
            free.bind(('localhost', 0))
            port = free.getsockname()[1]
        self.master = 'http://localhost:{}'.format(port)
        environment = dict(os.environ, ROS_MASTER_URI=self.master, ROS_HOSTNAME='localhost',
                           ROS_HOME=str(folder / '.ros'), PYTHONDONTWRITEBYTECODE='1')
        for name in ('ROS_IP', 'ROS_LOG_DIR', 'ROS_NAMESPACE'):
            environment.pop(name, None)
        self.bash = subprocess.Popen(['bash', '--noprofile', '--norc'], cwd=str(folder), env=environment, text=True,
                                     stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, start_new_session=True)

    def run(self, text, timeout=TIMEOUT):
        """Run a command as if it was typed; return (exit code, output)."""
        source, log, code = (self.folder / name for name in ('.command', '.output', '.code'))
        source.write_text(text + '\n')
        log.unlink(missing_ok=True)  # background programs keep their own file
        self.bash.stdin.write('source {0}/.command < /dev/null > {0}/.output 2>&1; echo $? > {0}/.coding; '
                              'mv {0}/.coding {0}/.code\n'.format(self.folder))
        self.bash.stdin.flush()
        deadline = time.monotonic() + timeout
        while not code.exists():
            if self.bash.poll() is not None or time.monotonic() > deadline:
                raise Failed('does not end within {} s\n{}'.format(
                    timeout, log.read_text(errors='replace')[-SHOWN:] if log.exists() else ''))
            time.sleep(0.02)
        result = int(code.read_text())
        code.unlink()
        return result, log.read_text(errors='replace')

    def check(self, text, expected=0):
        """Run a command; return its output. Fail unless it ends with the expected exit code."""
        code, output = self.run(text)
        if code != expected:
            raise Failed('exit code {}, not {}\n{}'.format(code, expected, output[-SHOWN:]))
        return output

    def run_python(self, text):
        """Run a block of Python in the document's interpreter; return its output."""
        if not self.has_python:
            self.check('coproc PYTHON {{ exec python3 {} {}/.printed; }}'.format(PYTHON_SESSION, self.folder))
            self.has_python = True
        (self.folder / '.block.py').write_text(text + '\n')
        return self.check('echo {0}/.block.py >&"${{PYTHON[1]}}"; read -r python_code <&"${{PYTHON[0]}}"; '
                          'cat {0}/.printed; (exit "$python_code")'.format(self.folder))

    def launch(self, text):
        """End the previous launch, start this one in the background and wait until it responds."""
        self.end_launched()
        file = next((word for word in text.split() if word.endswith('.launch')), '')
        if file and 'name="rviz"' in (self.folder / 'launch' / file).read_text():
            text += ' rviz:=false'
        text = re.sub(r':=({})\b'.format('|'.join(DATAROOT)), r':=$PWD/\1', text)
        if text.startswith('roscore'):
            text += ' -p ' + self.master.rsplit(':', 1)[1]
        self.launched = int(self.check('{} > {}/.launched 2>&1 & echo $!'.format(text, self.folder)))
        self.wait_for(SERVICES.get(file, ALL_SERVICES) if file else [])

    def wait_for(self, services):
        deadline = time.monotonic() + READY_TIMEOUT
        while not self.answers(services):
            if time.monotonic() > deadline:
                raise Failed('not ready within {} s\n{}'.format(
                    READY_TIMEOUT, (self.folder / '.launched').read_text(errors='replace')[-SHOWN:]))
            time.sleep(0.1)

    def answers(self, services):
        try:
            master = ServerProxy(self.master)
            return all(master.lookupService('/docs_test', name)[0] == 1 for name in services or ['/rosout/get_loggers'])
        except OSError:
            return False

    def call(self, text):
        """Run a service call; return its output. While the service has no scene, repeat the call, as a reader would."""
        deadline = time.monotonic() + READY_TIMEOUT
        while True:
            output = self.check(text)
            if re.search(r'\bcode: 0\b|success: True', output):
                return output
            if time.monotonic() > deadline:
                raise Failed('declined\n' + output[-SHOWN:])
            time.sleep(1.0)

    def end_launched(self):
        if self.launched is None:
            return
        deadline = time.monotonic() + READY_TIMEOUT
        try:
            os.kill(self.launched, signal.SIGINT)
            while Path('/proc/{}/exe'.format(self.launched)).exists() and time.monotonic() < deadline:
                time.sleep(0.05)
        except ProcessLookupError:
            pass  # it has ended by itself
        self.launched = None

    def close(self):
        self.end_launched()
        for sign in (signal.SIGTERM, signal.SIGKILL):  # background programs of the document
            try:
                os.killpg(self.bash.pid, sign)
            except ProcessLookupError:
                pass
        self.bash.wait()


def make_folder(source, folder):
    """A reader's copy of the repository, and a nuScenes root of their own with two scenes."""
    for entry in source.iterdir():
        if entry.name not in OWN:
            (folder / entry.name).symlink_to(entry)
    (folder / 'out').mkdir()
    embedded = source / 'data' / 'embedded'
    root = folder / DATAROOT[0]
    root.mkdir()
    (root / 'maps').symlink_to(embedded / 'maps')
    for version in VERSIONS:
        (root / version).mkdir()
        for name, rows in two_scenes(embedded / 'v1.0-embedded').items():
            (root / version / name).write_text(json.dumps(rows))
    for name in DATAROOT[1:]:
        (folder / name).symlink_to(root)


def two_scenes(folder):
    """Copy the tables of nuScenes with only SCENES, renamed."""
    tables = {path.name: json.loads(path.read_text()) for path in folder.iterdir()}
    tables['scene.json'] = [dict(row, name=SCENES[row['name']]) for row in tables['scene.json'] if row['name'] in SCENES]
    for name, key, other in (('sample', 'scene_token', 'scene'), ('sample_data', 'sample_token', 'sample'),
                             ('sample_annotation', 'sample_token', 'sample')):
        kept = {row['token'] for row in tables[other + '.json']}
        tables[name + '.json'] = [row for row in tables[name + '.json'] if row[key] in kept]
    for name, key, other in (('ego_pose', 'ego_pose_token', 'sample_data'),
                             ('instance', 'instance_token', 'sample_annotation')):
        kept = {row[key] for row in tables[other + '.json']}
        tables[name + '.json'] = [row for row in tables[name + '.json'] if row['token'] in kept]
    return tables


def is_run(text):
    return not any(re.search(pattern, text, re.DOTALL) for pattern, _ in NOT_RUN)


def as_it_is_run(text):
    for pattern, replacement in INSTEAD:
        text = re.sub(pattern, replacement, text, flags=re.DOTALL)
    return text


def make_earlier(shell, text):
    """Create the files that a command reads and that earlier pages made."""
    for path, how in EARLIER.items():
        written = re.search(r'--out\s+{}(\s|$)'.format(re.escape(path)), text)
        read = re.search(r'(\s|PWD/|=){}(\s|$)'.format(re.escape(path)), text)
        if read and not written and text != how and not (shell.folder / path).exists():
            make_earlier(shell, how)
            shell.check(how)


def run_command(shell, command):
    """Run a command; return its output."""
    text = as_it_is_run(command.text)
    make_earlier(shell, text)
    if re.match(r'(roscore|roslaunch)\b', text):
        shell.launch(text)
        return ''
    if re.match(r'rosservice call\b', text):
        return shell.call(text)
    return shell.check(text, command.exit_code)


class Document:
    """Runs a document and collects the outputs that differ from the shown ones."""

    def __init__(self, path):
        self.path, self.text = path, path.read_text()
        self.count, self.outputs = 0, []  # commands that ran; (block, printed) of shown outputs that differ

    def parts(self):
        try:
            return with_outputs(blocks(self.text))
        except ValueError as error:
            raise Failed('{}: {}'.format(self.path, error))

    def run(self, shell):
        for block, shown in self.parts():
            printed = ''
            if block.path:
                (shell.folder / block.path).parent.mkdir(parents=True, exist_ok=True)
                (shell.folder / block.path).write_text(block.text + '\n')
            elif block.language == 'python':
                printed = self.timed(block, lambda: shell.run_python(block.text))
            elif not block.language:
                printed = ''.join(self.timed(command, lambda: run_command(shell, command))
                                  for command in self.commands_of(block, shown))
            printed = UNCOUNTED.sub('', printed)
            if shown and not matches(shown.text, printed):
                self.outputs.append((shown, printed))

    def commands_of(self, block, shown):
        for command in commands(block):
            if shown and not (is_run(command.text) and as_it_is_run(command.text) == command.text):
                raise Failed('{}:{}: its output is shown, so arrangements.py must leave it as it is: {}'.format(
                    self.path, command.line, command.text))
            if is_run(command.text):
                yield command

    def timed(self, part, run):
        begin = time.monotonic()
        try:
            printed = run()
        except Failed as failed:
            raise Failed('{}:{}: {}\n{}'.format(self.path, part.line, part.text, failed))
        print('{:5.1f} s  line {}: {}'.format(time.monotonic() - begin, part.line, part.text), flush=True)
        self.count += 1
        return printed

    def rewrite(self):
        lines = self.text.split('\n')
        for shown, printed in reversed(self.outputs):
            begin = shown.line - 1
            lines[begin:begin + len(shown.text.split('\n'))] = rewritten(shown.text, printed).split('\n')
        self.path.write_text('\n'.join(lines))

    def report(self):
        return ['{}:{}: shows another output than is printed\n{}'.format(
            self.path, shown.line, difference(shown.text, printed)) for shown, printed in self.outputs]


def run_document(source, path, rewrite):
    """Run a document; return True if all commands and outputs are as shown."""
    document = Document(path)
    with tempfile.TemporaryDirectory(prefix='collision_forge_docs_') as name:
        folder = Path(name).resolve()
        make_folder(source, folder)
        shell = Shell(folder)
        try:
            shell.check('source scripts/env.bash')
            document.run(shell)
        except Failed as failed:
            print(failed)
            return False
        finally:
            shell.close()
    if rewrite and document.outputs:
        document.rewrite()
    print(*document.report(), '{}: {} commands, {} outputs {}'.format(
        path.name, document.count, len(document.outputs), 'rewritten' if rewrite else 'differ'), sep='\n')
    return rewrite or not document.outputs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--rewrite', action='store_true', help='put the printed outputs into the documents')
    parser.add_argument('source', type=Path, help='folder of the repository')
    parser.add_argument('documents', type=Path, nargs='+')
    arguments = parser.parse_args()
    results = [run_document(arguments.source.resolve(), path.resolve(), arguments.rewrite)
               for path in arguments.documents if path.name not in LEFT_OUT]
    return 0 if all(results) else 1


if __name__ == '__main__':
    sys.exit(main())
