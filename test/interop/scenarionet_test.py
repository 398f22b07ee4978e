#!/usr/bin/python3
"""Exports to ScenarioNet are read by MetaDrive and with Debian's NumPy."""
import json
import math
import os
import pickle
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy

from pages import LOGS, forge, make_scenarios
from virtual_environments import python_with

STEP = 0.1  # s, of config/export.yaml


def python_with_metadrive():
    return python_with('metadrive', 'metadrive-simulator==0.4.3')


def read_pickle(path):
    return pickle.loads(path.read_bytes())


def gap_between(boxes):
    """Return the gap (m) of two boxes (x, y, heading, length, width), the largest over all axes; < 0: overlap."""
    axes = [heading + turn for _, _, heading, _, _ in boxes for turn in (0.0, math.pi / 2)]
    distance = [boxes[1][i] - boxes[0][i] for i in (0, 1)]

    def reach(box, axis):
        _, _, heading, length, width = box
        return (abs(length * math.cos(heading - axis)) + abs(width * math.sin(heading - axis))) / 2

    return max(abs(distance[0] * math.cos(axis) + distance[1] * math.sin(axis)) - sum(reach(box, axis) for box in boxes)
               for axis in axes)


def first_touch(scenario):
    """Return the time (s) of the first step at which ego and attacker touch, or None."""
    metadata = scenario['metadata']
    states = [scenario['tracks'][track]['state']
              for track in (metadata['sdc_id'], metadata['collision_forge']['attacker'])]
    for step in numpy.flatnonzero(states[0]['valid'] & states[1]['valid']):
        boxes = [(*state['position'][step, :2], *(state[name][step] for name in ('heading', 'length', 'width')))
                 for state in states]
        if gap_between(boxes) < 0.0:
            return metadata['ts'][step]
    return None


class ScenarioNetTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.metadrive = python_with_metadrive()
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.scenarios = make_scenarios(cls.folder.name, 9)
        cls.out = cls.exported('out')
        cls.index = [json.loads(line) for line in (cls.out / 'index.jsonl').read_text(encoding='utf-8').splitlines()]

    @classmethod
    def exported(cls, name):
        out = Path(cls.folder.name, name)
        forge('export', '--to', 'scenarionet', '--scenarios', cls.scenarios, *LOGS, '--out', str(out))
        return out

    def read(self, name):
        return read_pickle(self.out / name)

    def sound_files(self, folder):
        """Return the files of a folder that MetaDrive lists, all of them valid."""
        script = Path(__file__).with_name('metadrive_checks.py')
        words = [self.metadrive, '-W', 'error:numpy.core:DeprecationWarning', script, folder]
        done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return [line for line in done.stdout.splitlines() if line.startswith('sd_')]

    def test_metadrive_lists_all_files_and_finds_them_sound(self):
        listed = self.sound_files(self.out)
        self.assertEqual(listed, [entry['files'][0] for entry in self.index])
        self.assertGreater(len(listed), 50)

    def test_metadrive_finds_recorded_scenes_sound(self):
        out = Path(self.folder.name, 'recorded')
        forge('convert', '--to', 'scenarionet', *LOGS, '--out', str(out))
        scenes = {json.loads(line)['scene'] for line in Path(self.scenarios).read_text(encoding='utf-8').splitlines()}
        listed = self.sound_files(out)
        self.assertEqual(len(listed), len(list(out.glob('sd_*.pkl'))))
        self.assertGreaterEqual(len(listed), len(scenes))

    def test_ego_and_attacker_touch_when_the_index_says(self):
        touches = 0
        for entry in self.index:
            scenario = self.read(entry['files'][0])
            self.assertEqual(scenario['length'], entry['states'])
            self.assertEqual(scenario['metadata']['collision_forge']['contact_time'], entry['contact_t'])
            touch = first_touch(scenario)
            if entry['contact_t'] is None:
                self.assertIsNone(touch, entry)
            else:
                touches += 1
                self.assertAlmostEqual(touch, entry['contact_t'], delta=STEP, msg=str(entry))
        self.assertGreater(touches, 50)

    def test_the_summary_is_what_the_files_tell(self):
        summary, folders = self.read('dataset_summary.pkl'), self.read('dataset_mapping.pkl')
        names = [entry['files'][0] for entry in self.index]
        self.assertEqual(folders, {name: '' for name in names})
        for name in names:
            numpy.testing.assert_equal(summary[name], self.read(name)['metadata'])

    def test_arrays_can_be_changed_in_place(self):
        position = self.read(self.index[0]['files'][0])['tracks']['ego']['state']['position']
        self.assertEqual((position.dtype, position.shape[1]), (numpy.float64, 3))
        position -= position[0].copy()
        self.assertEqual(position[0].tolist(), [0.0, 0.0, 0.0])


if __name__ == '__main__':
    os.chdir(Path(__file__).parents[2])
    unittest.main()
