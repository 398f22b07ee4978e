#!/usr/bin/python3
"""Exports to OpenSCENARIO: ASAM's checkers, roads in SUMO's netconvert and CommonRoad's designer, played by esmini."""
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

from esmini_player import Play, Scenario, player
from pages import LOGS, attacks_of, forge, make_scenarios
from sumo_roads import Lines, farthest, middle_lines, python_with_netconvert
from virtual_environments import ASAM_CHECKS, python_with, python_with_asams_rules

LATE = 0.15  # s from our contact, found within a tolerance, to the first step at which esmini's boxes overlap
DESIGNER = Path(__file__).with_name('commonroad_designer.py')


class OpenScenarioTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.scenarios = make_scenarios(folder.name, 11)
        cls.out = cls.exported('out')
        cls.index = [json.loads(line) for line in (cls.out / 'index.jsonl').read_text(encoding='utf-8').splitlines()]

    @classmethod
    def exported(cls, name, *words):
        out = cls.folder / name
        forge('export', '--to', 'openscenario', '--scenarios', cls.scenarios, *LOGS, '--out', str(out), *words)
        return out

    def check(self, out):
        return subprocess.run([python_with_asams_rules(), ASAM_CHECKS, out], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, check=False)

    def test_all_attacks_are_exported(self):
        self.assertEqual(len(self.index), len(attacks_of(self.scenarios)))
        self.assertGreater(len(self.index), 20)
        for entry in self.index:
            for file in entry['files']:
                self.assertTrue((self.out / file).exists(), file)

    def test_asams_rules_find_no_error(self):
        for out in (self.out, self.exported('free', '--ego', 'free'), self.exported('carla', '--flavour', 'carla'),
                    self.exported('free_carla', '--flavour', 'carla', '--ego', 'free')):
            result = self.check(out)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertIn('{} files checked'.format(2 * len(self.index)), result.stdout)

    def test_asams_rules_find_errors(self):
        broken = self.folder / 'broken'
        broken.mkdir()
        road, scenario = (self.out / name for name in self.index[0]['files'])
        (broken / road.name).write_text(road.read_text().replace('<planView', '<plan').replace('</planView', '</plan'))
        (broken / scenario.name).write_text(scenario.read_text().replace('entityRef="attacker"', 'entityRef="nobody"'))
        result = self.check(broken)
        self.assertEqual(result.returncode, 1)
        for path in (road, scenario):
            self.assertIn(path.name + ': ', result.stdout)

    def test_netconvert_has_the_lanes_where_they_are(self):
        python = python_with_netconvert()
        net = self.folder / 'map.net.xml'
        for entry in self.index[::5]:
            self.assertLess(farthest(python, self.out / entry['files'][0], net), 0.2, entry['name'])
        road = self.out / self.index[0]['files'][0]
        moved = self.folder / 'moved.xodr'
        moved.write_text(road.read_text().replace('<laneOffset s="0" a="', '<laneOffset s="0" a="1'))
        self.assertGreater(farthest(python, moved, net, road), 0.5)

    def test_commonroads_designer_has_the_lanes_where_they_are(self):
        python = python_with('commonroad-designer', 'commonroad-scenario-designer==0.8.5')
        some = self.folder / 'some_roads'
        some.mkdir()
        for entry in self.index[::5]:
            shutil.copy(self.out / entry['files'][0], some)
        lines = subprocess.run([python, DESIGNER, some], stdout=subprocess.PIPE, check=True, text=True,
                               env=dict(os.environ, QT_QPA_PLATFORM='offscreen')).stdout.splitlines()
        self.assertEqual(len(lines), len(self.index[::5]))
        for found in map(json.loads, lines):
            roads = ElementTree.parse(some / found['file']).getroot().iter('road')
            lanes = Lines(line for road in roads for line in middle_lines(road, ('driving', 'biking')))
            self.assertGreater(len(found['centres']), 0)
            for centre in found['centres']:
                self.assertLess(max(lanes.distance_to(*point) for point in centre), 0.05, found['file'])

    def test_esmini_plays_every_attack_as_written(self):
        program = player()
        for entry in self.index:
            with self.subTest(entry['name']):
                path = self.out / entry['files'][1]
                scenario, play = Scenario(path), Play(program, path, self.folder)
                self.assertEqual(play.complaints, [])
                self.assertLess(play.farthest(scenario), 0.01)
                self.assertEqual(play.off_stage(scenario), [])
                if entry['contact_t'] is not None:
                    self.assertAlmostEqual(play.contact(), entry['contact_t'], delta=LATE)

    def test_in_esmini_the_attacker_meets_a_free_ego_of_another_speed(self):
        program, out = player(), self.exported('free_speeds', '--ego', 'free')
        for share in (0.8, 1.0):
            met = 0
            for entry in self.index:
                path = out / entry['files'][1]
                path.write_text(slowed(path.read_text(), share))
                met += Play(program, path, self.folder).contact() is not None
            self.assertGreater(met, 0.3 * len(self.index), share)


def slowed(text, share):
    """The text of a file with another speed of the ego."""
    return re.sub('AbsoluteTargetSpeed value="(.*?)"',
                  lambda match: 'AbsoluteTargetSpeed value="{}"'.format(share * float(match[1])), text)


if __name__ == '__main__':
    unittest.main()
