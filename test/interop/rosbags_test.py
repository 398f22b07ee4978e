#!/usr/bin/python3
"""A bag with an attack is readable without this package's message types: PyPI's rosbags finds the attack that rosbag
reads from the package's own messages."""
import json
import os
import subprocess
import tempfile
import unittest
import zlib
from pathlib import Path

import rosbag

from pages import LOGS, forge
from virtual_environments import python_with

SCENE = 'scene-0005'
ATTACK = ['--type', 'opposite_direction', '--now', '5', '--tta', '4', '--mode', 'replay']


class RosbagsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        python = python_with('rosbags', 'rosbags==0.11.9')
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        recorded, cls.attacked = Path(folder.name, SCENE + '.bag'), Path(folder.name, 'head_on.bag')
        forge('convert', *LOGS, '--scene', SCENE, '--out', folder.name)
        forge('inject', '--bag', str(recorded), *ATTACK, '--out', str(cls.attacked))
        reader = Path(__file__).parent / 'rosbags_checks.py'
        cls.read = json.loads(subprocess.run([python, reader, cls.attacked], stdout=subprocess.PIPE, check=True).stdout)

    def own(self, topic):
        """Return the contents as read by rosbag."""
        with rosbag.Bag(str(self.attacked)) as bag:
            return [message for _, message, _ in bag.read_messages(topic)]

    def found(self, topic):
        return [message for _, message in self.read['found'][topic]]

    def test_one_type_alone_is_learned_from_the_bag(self):
        self.assertEqual(self.read['learned'], ['derived_object_msgs/msg/ObjectArray'])

    def test_the_egos_path_meets_the_attackers_at_the_contact(self):
        report = self.own('/tested_report')[0]
        self.assertTrue(report.contact)
        ego, = self.found('/attack_ego_path')
        at = report.contact_time.to_nsec()
        before, after = next((one, other) for one, other in zip(ego['poses'], ego['poses'][1:]) if other[0] >= at)
        share = (at - before[0]) / (after[0] - before[0])
        for axis, expected in enumerate((report.ego_at_contact.x, report.ego_at_contact.y)):
            here = before[1][axis] + share * (after[1][axis] - before[1][axis])
            self.assertAlmostEqual(here, expected, delta=0.01)
        self.assertEqual(ego['poses'][0][0], report.header.stamp.to_nsec())

    def test_objects_are_the_agents_the_attacker_among_them(self):
        frames, read = self.own('/agents'), self.found('/agent_objects')
        self.assertEqual([one['stamp'] for one in read], [frame.header.stamp.to_nsec() for frame in frames])
        for one, frame in zip(read, frames):
            self.assertEqual([entry[:2] + entry[3:] for entry in one['objects']],
                             [[zlib.crc32(agent.id.encode()),
                               [agent.pose.position.x, agent.pose.position.y, agent.pose.position.z],
                               [agent.size.x, agent.size.y, agent.size.z]] for agent in frame.agents])
        attacker = self.own('/attack')[0].trajectory.attacker_id
        self.assertIn(zlib.crc32(attacker.encode()), [entry[0] for entry in read[-1]['objects']])
        self.assertEqual({entry[2] for one in read for entry in one['objects']} & {4, 6}, {4, 6})  # pedestrians, cars

    def test_markers_and_odometry_need_nothing_else(self):
        self.assertTrue(any(name == 'attacker' for message in self.found('/attack_markers')
                            for name, _ in message['markers']))
        self.assertGreater(len(self.found('/annotation_markers')), 40)
        self.assertGreater(len(self.found('/odom')), 100)


if __name__ == '__main__':
    os.chdir(Path(__file__).parents[2])
    unittest.main()
