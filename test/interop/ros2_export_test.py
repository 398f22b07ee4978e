#!/usr/bin/python3
"""Bags exported to ROS 2 have the messages of their source, as readers of PyPI find."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from pages import LOGS, forge
from virtual_environments import python_with

SCENE = 'scene-0005'
ATTACK = ['--type', 'opposite_direction', '--now', '5', '--tta', '4', '--mode', 'replay']


class Ros2ExportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.python = python_with('ros2_export', 'mcap==1.6.0', 'mcap-ros2-support==0.6.0', 'rosbags==0.11.9')
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        forge('convert', *LOGS, '--scene', SCENE, '--out', folder.name)
        cls.bags = [cls.folder / (SCENE + '.bag'), cls.folder / 'head_on.bag']
        forge('inject', '--bag', str(cls.bags[0]), *ATTACK, '--out', str(cls.bags[1]))
        bags = list(map(str, cls.bags))
        forge('export', '--to', 'mcap', '--profile', 'ros2', '--bag', *bags, '--out', str(cls.folder / 'mcap'))
        forge('export', '--to', 'rosbag2', '--bag', *bags, '--out', str(cls.folder / 'rosbag2'))

    def test_every_message_is_equal(self):
        checks = Path(__file__).parent / 'ros2_export_checks.py'
        for bag in self.bags:
            with self.subTest(bag=bag.stem):
                found = subprocess.run([self.python, checks, bag, self.folder / 'mcap' / (bag.stem + '.mcap'),
                                        self.folder / 'rosbag2' / bag.stem], stdout=subprocess.PIPE, check=True).stdout
                for reader, (count, read, equal) in json.loads(found).items():
                    self.assertGreater(count, 300, reader)
                    self.assertEqual((read, equal), (count, count), reader)


if __name__ == '__main__':
    os.chdir(Path(__file__).parents[2])
    unittest.main()
