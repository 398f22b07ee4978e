#!/usr/bin/python3
"""Lanes that forge convert reads from maps equal the centrelines of lanelet2 and commonroad-io."""
import json
import math
import subprocess
import tempfile
import unittest
from pathlib import Path

import rosbag
from commonroad_test import python_with_reader
from pages import LOGS, forge, make_scenarios
from virtual_environments import python_with

LANELET2_CHECKS = Path(__file__).with_name('lanelet2_checks.py')
COMMONROAD_CENTRES = Path(__file__).with_name('commonroad_centres.py')
ORIGIN = ['49.0', '8.4']
CLOSE = 0.05  # m


def printed(*command):
    return json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True, text=True).stdout)


def lanes_in(bag):
    """{id: centreline}"""
    with rosbag.Bag(str(bag)) as opened:
        message = next(message for _, message, _ in opened.read_messages('/lane_map'))
    return {lane.id: [(pose.x, pose.y) for pose in lane.centerline] for lane in message.lanes}


def distance(point, line):
    """Return the distance of a point from a line."""
    nearest = math.inf
    for (x, y), (to_x, to_y) in zip(line, line[1:]):
        along = (to_x - x, to_y - y)
        squared = along[0] ** 2 + along[1] ** 2
        share = 0 if squared == 0 else ((point[0] - x) * along[0] + (point[1] - y) * along[1]) / squared
        share = min(max(share, 0), 1)
        nearest = min(nearest, math.dist(point, (x + share * along[0], y + share * along[1])))
    return nearest


def farthest(one, other):
    """Return the largest distance of a point of either line from the other line."""
    return max(max(distance(point, other) for point in one), max(distance(point, one) for point in other))


class MapsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding='utf-8')
        return str(path)

    def test_centrelines_are_within_5_cm_of_those_of_lanelet2(self):
        python = python_with('lanelet2', 'lanelet2==1.2.3')
        osm = str(self.folder / 'lanelets.osm')
        expected = printed(python, LANELET2_CHECKS, osm, *ORIGIN)
        self.write('config/export.yaml', 'origins:\n  lanelets: [{}, {}]\n'.format(*ORIGIN))
        self.write('config/conversion.yaml', 'conversion:\n  map_radius: 100000.0\n')
        topics = Path('config/topics_derived_object.yaml').read_text(encoding='utf-8')
        mapping = self.write('topics.yaml', topics.replace('topic: /objects', 'topic: /agent_objects'))
        theirs, ours = str(self.folder / 'theirs'), str(self.folder / 'ours')
        forge('convert', *LOGS, '--scene', 'scene-0008', '--out', theirs)
        forge('convert', '--source', theirs, '--topics', mapping, '--map', osm, '--out', ours,
              '--config', str(self.folder / 'config'))
        self.compare(lanes_in(self.folder / 'ours' / 'scene-0008.bag'), expected)

    def test_centrelines_are_within_5_cm_of_those_of_commonroad_io(self):
        exported, bags = str(self.folder / 'exported'), str(self.folder / 'bags')
        scenarios = make_scenarios(str(self.folder), 97)
        forge('export', '--to', 'commonroad', '--scenarios', scenarios, *LOGS, '--out', exported)
        expected = printed(python_with_reader(), COMMONROAD_CENTRES, exported)
        forge('convert', '--source', exported, '--out', bags)
        self.assertGreater(len(expected), 3)
        for name, lanes in expected.items():
            with self.subTest(crash=name):
                self.compare(lanes_in(Path(bags, name + '.bag')), lanes)

    def compare(self, found, expected):
        self.assertEqual(set(found), set(expected))
        for lane, line in expected.items():
            self.assertLess(farthest(found[lane], line), CLOSE, lane)


if __name__ == '__main__':
    unittest.main()
