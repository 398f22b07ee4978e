#!/usr/bin/python3
"""usage: check_options.py SOURCE_DIR: check that options of config/ are read into members of the same name, and used.

1. Each options.cpp reads a key into the member of the same name.
2. Every member of a struct *Options in a header is used outside the files options.cpp.
"""
import re
import sys
from pathlib import Path

READ = re.compile(r'\.(\w+) =\s+section\.\w+(?:<\w+>)?\(\s*"(\w+)"')
STRUCT = re.compile(r'^struct (\w+)[^;{]*\{\n(.*?)^\};', re.MULTILINE | re.DOTALL)
MEMBER = re.compile(r'^  [\w:<>, ]+ (\w+)(?: = [^;]+)?;', re.MULTILINE)


def misread(options_cpp):
    """Return the pairs (member, key) with different names."""
    return [pair for pair in READ.findall(options_cpp) if pair[0] != pair[1]]


def members(header):
    """Return (struct, member) of the structs *Options in a header."""
    return [(struct, member) for struct, body in STRUCT.findall(header) if struct.endswith('Options')
            for member in MEMBER.findall(body)]


def violations(root):
    sources = {path: path.read_text(encoding='utf-8') for path in sorted(root.rglob('*')) if path.suffix in ('.h', '.cpp')}
    readers = [path for path in sources if path.name == 'options.cpp']
    if not readers:
        yield 'no options.cpp in {}'.format(root)
    for path in readers:
        for member, key in misread(sources[path]):
            yield '{}: {} is read from the key {}'.format(path.relative_to(root), member, key)
    users = '\n'.join(text for path, text in sources.items() if path not in readers)
    for path, text in sources.items():
        for struct, member in members(text) if path.suffix == '.h' else ():
            if not re.search(r'(\.|->){}\b'.format(member), users):
                yield '{}: {}::{} is not used'.format(path.relative_to(root), struct, member)


def main(source_dir):
    found = list(violations(Path(source_dir, 'src')))
    print('\n'.join(found) or 'all options are read and used')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
