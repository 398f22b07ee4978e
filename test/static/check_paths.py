#!/usr/bin/python3
"""usage: check_paths.py SOURCE_DIR: check that source files named in documents and comments exist.

A name is a path from the root (src/collision_forge/MODULE/FOLDER/NAME.h) or from the modules (MODULE/FOLDER/NAME.h).
"""
import re
import sys
from pathlib import Path

MODULES = Path('src', 'collision_forge')
NAMED = re.compile(r'(?<![\w/.-])(?:[a-z_]+/)+[a-z_0-9]+\.(?:h|cpp)\b')


def violations(source_dir):
    root = Path(source_dir)
    folders = {folder.name for folder in (root / MODULES).rglob('*') if folder.is_dir()}
    patterns = ['*.md', 'docs/*.md', 'config/*.yaml', 'src/**/*.h', 'src/**/*.cpp']
    for document in [path for pattern in patterns for path in sorted(root.glob(pattern))]:
        for number, line in enumerate(document.read_text().splitlines(), 1):
            for name in [] if line.startswith('#include') else NAMED.findall(line):
                is_ours = name.startswith(('src/', 'test/')) or name.split('/')[0] in folders
                if is_ours and not (root / name).exists() and not (root / MODULES / name).exists():
                    yield '{}:{}: {} does not exist'.format(document.relative_to(root), number, name)


def main(source_dir):
    found = list(violations(source_dir))
    print('\n'.join(found) or 'every named source file exists')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
