#!/usr/bin/python3
"""Test that check_launch.py finds nodes without respawn."""
import tempfile
import unittest
from pathlib import Path

from check_launch import violations

NODE = '<node pkg="collision_forge" type="scene_encoder" name="encoder"{}/>'


def violations_of(content):
    """Return violations() of a folder with one launch file with this content."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, 'some.launch').write_text('<launch>{}</launch>'.format(content))
        return list(violations(Path(folder)))


class CheckLaunchTest(unittest.TestCase):
    def test_a_node_without_respawn_is_found(self):
        for attributes in ('', ' respawn="false"', ' respawn_delay="1"', ' required="true"'):
            self.assertEqual(violations_of(NODE.format(attributes)),
                             ['some.launch: the node encoder has no respawn="true"'])

    def test_a_node_with_respawn_passes(self):
        self.assertEqual(violations_of(NODE.format(' respawn="true"')), [])


if __name__ == '__main__':
    unittest.main()
