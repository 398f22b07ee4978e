#!/usr/bin/python3
"""Exports to CommonRoad: read by commonroad-io, CommonRoad's collision checker, driven by its reactive planner."""
import json
import math
import subprocess
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

from pages import LOGS, attacks_of, forge, make_scenarios
from virtual_environments import python_with

CHECKS = Path(__file__).with_name('commonroad_checks.py')
DRIVES = Path(__file__).with_name('commonroad_drives.py')
DRIVEN = 10  # problems that the planner must drive to the end
EGO = '1'


def python_with_reader():
    return python_with('commonroad', 'commonroad-io==2026.1')


def python_with_checker():
    """The checker's newest release needs modules that commonroad-io no longer has."""
    return python_with('commonroad-checker', 'commonroad-io==2024.3', 'commonroad-drivability-checker==2025.4.0')


def findings(python, folder):
    """Return the results by the name of the crash."""
    lines = subprocess.run([python, CHECKS, folder], stdout=subprocess.PIPE, check=True, text=True).stdout.splitlines()
    return {Path(found['file']).stem: found for found in map(json.loads, lines)}


def values_of(source):
    return dict(part.split('=', 1) for part in source.split('; '))


class CommonRoadTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.scenarios = make_scenarios(folder.name, 29)
        cls.recorded, cls.index = cls.exported('recorded')
        cls.free, cls.free_index = cls.exported('free', '--ego', 'free')

    @classmethod
    def exported(cls, name, *words):
        """Export; return the folder and the lines of its index."""
        out = cls.folder / name
        forge('export', '--to', 'commonroad', '--scenarios', cls.scenarios, *LOGS, '--out', str(out), *words)
        lines = (out / 'index.jsonl').read_text(encoding='utf-8').splitlines()
        return out, [json.loads(line) for line in lines]

    def test_all_attacks_are_exported(self):
        self.assertEqual(len(self.index), len(attacks_of(self.scenarios)))
        self.assertGreater(len(self.index), 20)
        self.assertEqual({entry['location'] for entry in self.index}, {'embedded-left', 'embedded-right'})
        for entry in self.index:
            self.assertEqual(entry['files'], [entry['name'] + '.xml'])

    def test_commonroad_io_reads_every_file_and_writes_it_again(self):
        for folder, index in ((self.recorded, self.index), (self.free, self.free_index)):
            found = findings(python_with_reader(), folder)
            self.assertEqual(set(found), {entry['name'] for entry in index})
            for entry in index:
                with self.subTest(folder=folder.name, crash=entry['name']):
                    root = ElementTree.parse(str(folder / entry['files'][0])).getroot()
                    self.check_contents(found[entry['name']], root)
                    self.check_clock(found[entry['name']], values_of(root.get('source')), entry, folder == self.free)

    def check_contents(self, found, root):
        for kind, count in (('lanelet', found['lanelets']), ('staticObstacle', found['static']),
                            ('dynamicObstacle', len(found['dynamic']))):
            self.assertEqual(count, len(root.findall(kind)), kind)
        self.assertGreater(found['lanelets'], 0)
        self.assertEqual(found['benchmark'], root.get('benchmarkID'))
        self.assertTrue(found['rewritten'])
        self.assertEqual(found['schema'], [])
        self.assertIn('critical', found['tags'])

    def check_clock(self, found, values, entry, is_free):
        steps = list(range(entry['states']))
        self.assertEqual(found['dt'], 0.1)
        self.assertEqual(found['begin'], round(float(values['now']) / found['dt']))
        self.assertEqual(found['begin'] == 0, is_free)
        self.assertEqual(found['end'], steps[-1])
        self.assertEqual(found['dynamic'].get(EGO), None if is_free else steps)
        self.assertEqual(found['reached'], None if is_free else True)
        for stretch in found['dynamic'].values():
            self.assertEqual(stretch, steps[stretch[0]:stretch[-1] + 1])
        self.assertEqual('contact' in values, entry['contact_t'] is not None)
        if entry['contact_t'] is not None:
            self.assertAlmostEqual(float(values['contact']), entry['contact_t'], delta=1e-6)

    def test_ego_and_attacker_touch_first_at_the_contact(self):
        found = findings(python_with_checker(), self.recorded)
        self.assertEqual(set(found), {entry['name'] for entry in self.index})
        for entry in self.index:
            with self.subTest(crash=entry['name']):
                crash = found[entry['name']]
                contact, steps = entry['contact_t'], crash['dynamic'][EGO]
                first = None if contact is None else math.ceil(round(contact / crash['dt'], 6))
                self.assertEqual(crash['touching'][:1], [] if first is None else [steps[first]])
        self.assertGreater(sum(1 for entry in self.index if entry['contact_t'] is not None), 20)

    def test_commonroads_planner_drives_the_problems(self):
        python = python_with('commonroad-planner', 'commonroad-reactive-planner==2025.1')
        files = [self.recorded / entry['files'][0] for entry in self.index]
        lines = subprocess.run([python, DRIVES, str(DRIVEN), *files], stdout=subprocess.PIPE, check=True, text=True,
                               stderr=subprocess.DEVNULL).stdout.splitlines()
        driven = [found for found in map(json.loads, lines) if found['driven'] == found['wanted']]
        self.assertGreaterEqual(len(driven), min(DRIVEN, len(files)))


if __name__ == '__main__':
    unittest.main()
