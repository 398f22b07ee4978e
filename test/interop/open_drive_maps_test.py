#!/usr/bin/python3
"""Lanes that forge convert --map reads from OpenDRIVE files equal those of CARLA's reader."""
import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import rosbag

from open_drive_sample import sample
from pages import LOGS, forge
from sumo_roads import python_with_netconvert
from virtual_environments import python_with

SCENE = 'scene-0008'
CHECKS = Path(__file__).with_name('carla_checks.py')


class OpenDriveMapsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.python = python_with('carla', 'carla==0.9.16')
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.config = cls.folder / 'config'
        shutil.copytree('config', cls.config)
        conversion = cls.config / 'conversion.yaml'
        conversion.write_text(conversion.read_text().replace('map_radius: 500.0', 'map_radius: 100000.0'))
        topics = (cls.config / 'topics_derived_object.yaml').read_text()
        (cls.folder / 'topics.yaml').write_text(topics.replace('topic: /objects', 'topic: /agent_objects'))
        forge('convert', *LOGS, '--scene', SCENE, '--out', str(cls.folder / 'recorded'))

    def compared(self, path):
        """Return the output of carla_checks.py for a file."""
        out = self.folder / ('bag_' + path.stem)
        forge('convert', '--source', str(self.folder / 'recorded'), '--topics', str(self.folder / 'topics.yaml'),
              '--map', str(path), '--config', str(self.config), '--out', str(out))
        with rosbag.Bag(str(out / (SCENE + '.bag'))) as bag:
            lanes = next(message for _, message, _ in bag.read_messages('/lane_map')).lanes
        named = path.with_suffix('.json')
        named.write_text(json.dumps({lane.id: {'line': [(pose.x, pose.y) for pose in lane.centerline],
                                               'next': lane.outgoing} for lane in lanes}))
        result = subprocess.run([self.python, CHECKS, path, named], stdout=subprocess.PIPE, check=True)
        return json.loads(result.stdout)

    def check(self, path, waypoints):
        found = self.compared(path)
        self.assertGreater(found['waypoints'], waypoints)
        self.assertLess(found['worst'], 0.05)
        self.assertEqual(found['elsewhere'], [])

    def test_every_geometry_and_polynomial_is_where_carla_has_it(self):
        for rule in ('RHT', 'LHT'):
            with self.subTest(rule):
                path = self.folder / (rule + '.xodr')
                path.write_text(sample(rule))
                self.check(path, 1000)

    def test_lanes_lead_through_junctions_as_in_carla(self):
        tools = python_with_netconvert().parent
        home = next(tools.parent.glob('lib/python*/site-packages/sumo'))
        net, path = self.folder / 'grid.net.xml', self.folder / 'grid.xodr'
        for words in (['netgenerate', '--grid', '--grid.number', '3', '--grid.length', '120', '-L', '2', '--turn-lanes',
                       '1', '-o', net],
                      ['netconvert', '-s', net, '--opendrive-output', path]):
            subprocess.run([tools / words[0], *words[1:]], check=True, stdout=subprocess.DEVNULL,
                           env=dict(os.environ, SUMO_HOME=str(home)))
        self.check(path, 10000)


if __name__ == '__main__':
    os.chdir(Path(__file__).parents[2])
    unittest.main()
