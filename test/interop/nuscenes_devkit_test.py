#!/usr/bin/python3
"""The embedded data is valid in the nuScenes devkit, whose lanes equal those of `forge convert`."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import rosbag

from pages import LOGS, forge
from virtual_environments import nuscenes_python

DATAROOT, VERSION = Path('data', 'embedded'), 'v1.0-embedded'


def rows_of(table):
    return json.loads((DATAROOT / VERSION / (table + '.json')).read_text(encoding='utf-8'))


def lanes_in(folder):
    """Return {location: {id: lane}} of all bags; each bag has the lanes near its scene and the links among them."""
    towns = {}
    for path in sorted(Path(folder).glob('*.bag')):
        with rosbag.Bag(str(path)) as bag:
            _, roads, _ = next(bag.read_messages('/lane_map'))
        lanes = towns.setdefault(roads.location, {})
        for lane in roads.lanes:
            line = [(pose.x, pose.y) for pose in lane.centerline]
            told = lanes.setdefault(lane.id, {'line': line, 'incoming': [], 'outgoing': []})
            for links, ids in ((told['incoming'], lane.incoming), (told['outgoing'], lane.outgoing)):
                links.extend(name for name in ids if name not in links)
    return towns


class NuScenesDevkitTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        python = nuscenes_python()
        with tempfile.TemporaryDirectory() as folder:
            forge('convert', *LOGS, '--out', folder)
            cls.lanes = lanes_in(folder)
            lanes = Path(folder, 'lanes.json')
            lanes.write_text(json.dumps(cls.lanes), encoding='utf-8')
            script = Path(__file__).with_name('nuscenes_devkit_checks.py')
            done = subprocess.run([python, script, DATAROOT, VERSION, lanes], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True, check=False)
        if done.returncode:
            raise RuntimeError(done.stderr)
        cls.found = json.loads(done.stdout)

    def test_all_scenes_and_boxes_are_found(self):
        self.assertEqual(self.found['scenes'], len(rows_of('scene')))
        self.assertEqual(self.found['boxes'], len(rows_of('sample_annotation')))

    def test_the_ego_is_on_the_road_of_the_map_mask(self):
        self.assertEqual(self.found['off_the_road'], [])

    def test_the_lanes_of_both_towns_are_known_and_linked_alike(self):
        self.assertEqual(sorted(self.found['towns']), ['embedded-left', 'embedded-right'])
        for location, town in self.found['towns'].items():
            self.assertGreater(len(self.lanes[location]), 50)
            self.assertEqual(town['unknown'], [])
            self.assertEqual(town['linked_otherwise'], [])

    def test_centrelines_agree_to_a_centimetre(self):
        for town in self.found['towns'].values():
            self.assertLess(town['farthest'], 0.01)


if __name__ == '__main__':
    os.chdir(Path(__file__).parents[2])
    unittest.main()
