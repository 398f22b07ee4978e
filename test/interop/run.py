#!/usr/bin/python3
"""usage: run.py SOURCE_DIR: runs the tests of this folder; the last line is `N passed, N failed, N skipped`."""
import os
import sys
import unittest
from pathlib import Path


def main(source_dir):
    os.chdir(source_dir)
    folder = str(Path(__file__).parent)
    suite = unittest.defaultTestLoader.discover(folder, '*_test.py', folder)
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    failed = len(result.failures) + len(result.errors)
    passed = result.testsRun - failed - len(result.skipped)
    print('{} passed, {} failed, {} skipped'.format(passed, failed, len(result.skipped)))
    return 1 if failed or not result.testsRun else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
