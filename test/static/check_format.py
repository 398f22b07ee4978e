#!/usr/bin/python3
"""usage: check_format.py SOURCE_DIR: check that all C++ files are formatted by clang-format 14.

Other versions format some lines otherwise; with them the check is skipped.
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

SKIPPED = 77
VERSION = '14'  # of Debian 12


def main(source_dir):
    if shutil.which('clang-format') is None:
        print('clang-format is not installed')
        return SKIPPED
    named = subprocess.run(['clang-format', '--version'], check=True, stdout=subprocess.PIPE, universal_newlines=True)
    version = re.search(r'version (\d+)', named.stdout)
    if version is None or version.group(1) != VERSION:
        print('clang-format is not of version {}: {}'.format(VERSION, named.stdout.strip()))
        return SKIPPED
    files = sorted(str(path) for folder in ('src', 'test') for path in Path(source_dir, folder).rglob('*')
                   if path.suffix in ('.cpp', '.h'))
    if not files:
        print('no C++ file in {}'.format(source_dir))
        return 1
    checked = subprocess.run(['clang-format', '--style=file', '--dry-run', '--Werror', *files], check=False,
                             stderr=subprocess.PIPE, universal_newlines=True)
    for file in sorted({line.split(':')[0] for line in checked.stderr.splitlines() if '-Wclang-format' in line}):
        print('clang-format -i {}'.format(Path(file).relative_to(source_dir)))
    return checked.returncode


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
