#!/usr/bin/python3
"""A ROS 2 bag of Autoware's types in both storages, written by PyPI's rosbags, through scripts/ros2_bag and
forge convert --topics to a bag with an attack."""
import sqlite3
import subprocess
import tempfile
import unittest
from pathlib import Path

import rosbag

from pages import LOGS, forge
from virtual_environments import python_with

SCENE = 'scene-0005'
MAP = 'data/embedded/maps/expansion/embedded-right.json'
MAPPING = 'config/topics_autoware.yaml'


class Ros2BagTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.python = python_with('rosbags', 'rosbags==0.11.9')
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        forge('convert', *LOGS, '--scene', SCENE, '--out', folder.name)
        cls.mapping = cls.folder / 'topics.yaml'
        agents = Path(MAPPING).read_text().split('agents:')[1].replace('frame_id: map', 'frame_id: base_link')
        cls.mapping.write_text('ego: {topic: /tf, type: tf2_msgs/TFMessage, child_frame_id: base_link, reference: base_link}'
                               '\nagents:' + agents)

    def converted(self, storage):
        """The ROS 2 bag and the bag of this project that is made of it."""
        theirs, ours = self.folder / storage, self.folder / (storage + '_ours')
        writer = Path(__file__).parent / 'ros2_bag_writer.py'
        subprocess.run([self.python, writer, self.folder / (SCENE + '.bag'), theirs, storage], check=True)
        if storage == 'sqlite3':
            self.drop_definitions(theirs / (storage + '.db3'))
        between = self.folder / (storage + '.bag')
        subprocess.run(['scripts/ros2_bag', theirs, self.mapping, between], check=True)
        forge('convert', '--source', str(between), '--topics', str(self.mapping), '--map', MAP, '--out', str(ours))
        return ours / (storage + '.bag')

    @staticmethod
    def drop_definitions(database):
        """As Humble and older versions record."""
        with sqlite3.connect(database) as connection:
            connection.execute('DELETE FROM message_definitions')

    @staticmethod
    def poses(path, topic):
        with rosbag.Bag(str(path)) as bag:
            return [message for _, message, _ in bag.read_messages(topic)]

    def assert_same_scene(self, path):
        original = self.folder / (SCENE + '.bag')
        for one, other in zip(self.poses(original, '/tf'), self.poses(path, '/tf'), strict=True):
            before, after = one.transforms[0], other.transforms[0]
            self.assertEqual(after.header.stamp, before.header.stamp)
            self.assertAlmostEqual(after.transform.translation.x, before.transform.translation.x, delta=1e-6)
            self.assertAlmostEqual(after.transform.translation.y, before.transform.translation.y, delta=1e-6)
        for one, other in zip(self.poses(original, '/agents'), self.poses(path, '/agents'), strict=True):
            self.assertEqual(other.header.stamp, one.header.stamp)
            self.assertEqual(len(other.agents), len(one.agents))
            for before, after in zip(one.agents, other.agents):
                self.assertAlmostEqual(after.pose.position.x, before.pose.position.x, delta=1e-6)
                self.assertAlmostEqual(after.pose.position.y, before.pose.position.y, delta=1e-6)

    def test_both_storages_give_the_scene_and_an_attack(self):
        for storage in ('sqlite3', 'mcap'):
            with self.subTest(storage=storage):
                path = self.converted(storage)
                self.assert_same_scene(path)
                out = self.folder / (storage + '_attacked.bag')
                forge('inject', '--bag', str(path), '--type', 'opposite_direction', '--now', '5', '--tta', '4', '--out', str(out))
                self.assertTrue(self.poses(out, '/tested_report')[0].verified)

    def test_a_topic_that_the_bag_lacks_is_named(self):
        theirs = self.folder / 'lacking'
        writer = Path(__file__).parent / 'ros2_bag_writer.py'
        subprocess.run([self.python, writer, self.folder / (SCENE + '.bag'), theirs, 'mcap'], check=True)
        result = subprocess.run(['scripts/ros2_bag', theirs, MAPPING, self.folder / 'none.bag'], stderr=subprocess.PIPE,
                                text=True, check=False)
        self.assertEqual(result.returncode, 1)
        self.assertIn('no topic /localization/kinematic_state but /perception', result.stderr)
        self.assertFalse((self.folder / 'none.bag').exists())


if __name__ == '__main__':
    unittest.main()
