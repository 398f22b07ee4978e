#!/usr/bin/python3
"""usage: check_type_names.py SOURCE_DIR: check that each type name in namespace forge is defined once.

Two definitions of one type name in a program violate the one-definition rule, and neither compiler nor linker reports it.
Types in unnamed namespaces and in functions are local to their file and may share names.
"""
import json
import shutil
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

SKIPPED = 77
FOLDERS = ('src', 'test')
KINDS = 'cgsu'  # class, enumeration, struct, union
UNNAMED = '__anon'


def read_definitions(source_dir):
    """Yield (qualified name, file, line) of every type that ctags finds in C++ files."""
    files = [str(path.relative_to(source_dir)) for folder in FOLDERS for path in sorted(Path(source_dir, folder).rglob('*'))
             if path.suffix in ('.cpp', '.h')]
    listed = subprocess.run(
        ['ctags', '--options=NONE', '--languages=C++', '--langmap=C++:+.h', '--kinds-C++=' + KINDS + 'f',
         '--fields=+snK', '--output-format=json', '--sort=no', '-f', '-', '-L', '-'],
        cwd=source_dir, input='\n'.join(files), check=True, text=True, stdout=subprocess.PIPE).stdout
    for line in listed.splitlines():
        tag = json.loads(line)
        if tag['kind'] != 'function' and tag.get('scopeKind') != 'function':
            scope = tag.get('scope', '')
            yield (scope + '::' if scope else '') + tag['name'], tag['path'], tag['line']


def violations(source_dir):
    places = defaultdict(list)
    for name, file, line in read_definitions(source_dir):
        if name.startswith('forge::') and UNNAMED not in name:
            places[name].append('{}:{}'.format(file, line))
    if not places:
        return ['no type in {}'.format(source_dir)]
    return ['{} is defined {} times: {}'.format(name, len(found), ', '.join(found))
            for name, found in sorted(places.items()) if len(found) > 1]


def main(source_dir):
    if shutil.which('ctags') is None:
        print('ctags is not installed')
        return SKIPPED
    found = violations(source_dir)
    print('\n'.join(found) or 'every name of a type stands for one type')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
