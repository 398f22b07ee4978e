#!/usr/bin/python3
"""Test that check_paths.py finds names of missing source files."""
import tempfile
import unittest
from pathlib import Path

from check_paths import violations


def violations_of(text):
    """Return violations() of a tree with src/collision_forge/base/map/lane.h and a README with this text."""
    with tempfile.TemporaryDirectory() as source_dir:
        folder = Path(source_dir, 'src', 'collision_forge', 'base', 'map')
        folder.mkdir(parents=True)
        (folder / 'lane.h').touch()
        Path(source_dir, 'README.md').write_text(text)
        return list(violations(source_dir))


class CheckPaths(unittest.TestCase):
    def test_existing_files_pass(self):
        self.assertEqual([], violations_of('`src/collision_forge/base/map/lane.h`, `base/map/lane.h`'))

    def test_missing_files_are_found(self):
        self.assertEqual(['README.md:2: map/way.h does not exist', 'README.md:2: src/map/lane.h does not exist'],
                         violations_of('first\n`map/way.h` `src/map/lane.h`'))


if __name__ == '__main__':
    unittest.main()
