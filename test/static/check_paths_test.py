#!/usr/bin/python3
"""What check_paths.py must find, and what it must let pass."""
import tempfile
import unittest
from pathlib import Path

from check_paths import violations


def violations_of(text):
    """violations() of a tree with one source file, src/collision_forge/base/map/lane.h, and a README with this text."""
    with tempfile.TemporaryDirectory() as source_dir:
        folder = Path(source_dir, 'src', 'collision_forge', 'base', 'map')
        folder.mkdir(parents=True)
        (folder / 'lane.h').touch()
        Path(source_dir, 'README.md').write_text(text)
        return list(violations(source_dir))


class CheckPaths(unittest.TestCase):
    def test_files_that_are_there_pass(self):
        self.assertEqual([], violations_of('`src/collision_forge/base/map/lane.h`, `base/map/lane.h`'))

    def test_files_that_are_not_there_are_found(self):
        self.assertEqual(['README.md:2: map/way.h is not there', 'README.md:2: src/map/lane.h is not there'],
                         violations_of('first\n`map/way.h` `src/map/lane.h`'))


if __name__ == '__main__':
    unittest.main()
