#!/usr/bin/python3
"""Two runs of one command on one --out: one writes it, the other is rejected at its start and names the first.

PAIRS=100 neighbours_test.py runs 100 pairs of every command and prints their outcomes."""
import os
import re
import shutil
import subprocess
import sys
import time
import unittest
from pathlib import Path

import road
from road import DATAROOT, VERSION

LOGS = ('--dataroot', DATAROOT, '--version', VERSION)
SCENE = ('--scene', 'scene-0001')
PAIRS = int(os.environ.get('PAIRS', '1'))
COUNTS = {}  # by command: what became of its pairs


def content(path):
    """Return the bytes of each file of an output, without the state of a training, which differs in every run."""
    if path.is_file():
        return {'': path.read_bytes()}
    return {str(file.relative_to(path)): file.read_bytes() if '.pt' not in file.suffixes else b''
            for file in path.rglob('*') if file.is_file()}


class NeighboursTest(road.RoadTest):
    SCENES = ['scene-0001']

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.requests, cls.scenarios, cls.other = (cls.folder / name for name in
                                                  ('requests.jsonl', 'scenarios.jsonl', 'other.jsonl'))
        few = ('--stride', 8, '--tta', 2, 4)
        for words in (('requests', *LOGS, *SCENE, *few, '--out', cls.requests),
                      ('generate', *LOGS, '--requests', cls.requests, '--mode', 'replay', '--out', cls.scenarios),
                      ('requests', *LOGS, '--scene', 'scene-0007', *few, '--out', cls.folder / 'r7.jsonl'),
                      ('generate', *LOGS, '--requests', cls.folder / 'r7.jsonl', '--mode', 'replay', '--out',
                       cls.other)):
            result = road.run(*words)
            assert result.returncode == 0, result.stderr
        cls.grid = cls.folder / 'grid.yaml'
        cls.grid.write_text('idm:\n  idm.standard.min_gap: [1.0, 4.0]\n')
        cls.config = road.copy_config(cls.folder / 'config')
        for file, changes in (('study/training.yaml', {'max_agents': 4, 'max_lanes': 4, 'lane_points': 4, 'max_ways': 2,
                                                 'way_anchors': 7, 'hidden': 8, 'scene': 8, 'anchor': 8, 'epochs': 1}),
                              ('study/dataset.yaml', {'begin_stride': 2.0, 'lane_change': 1, 'rear_end': 1, 'ltap': 1,
                                                'opposite_direction': 1, 'junction_crossing': 1})):
            text = (cls.config / file).read_text()
            for key, value in changes.items():
                text, count = re.subn(r'\b{}: [\d.]+'.format(key), '{}: {}'.format(key, value), text)
                assert count == 1, key
            (cls.config / file).write_text(text)

    @classmethod
    def tearDownClass(cls):
        for name, counts in sorted(COUNTS.items()):
            print(name, counts, file=sys.stderr)

    def start(self, words, out):
        return subprocess.Popen([str(word) for word in ('forge', *words, '--out', out)], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, universal_newlines=True)

    def end(self, process):
        _, errors = process.communicate(timeout=road.TIMEOUT)
        return process.returncode, errors

    def assert_same(self, out, alone):
        written, expected = content(out), content(alone)
        self.assertEqual(sorted(written), sorted(expected))
        self.assertEqual([name for name in expected if written[name] != expected[name]], [])

    def assert_neighbours(self, name, *words):
        """Run pairs of the command `words`; on a slow machine a pair may run one after the other."""
        ending = '.bag' if words[0] == 'inject' else ''
        alone, out = (self.path('{}_{}{}'.format(name.replace(' ', '_'), which, ending)) for which in ('alone', 'pair'))
        code, errors = self.end(self.start(words, alone))
        self.assertEqual(code, 0, errors)
        counts = COUNTS[name] = {'pairs': 0, 'refused': 0}
        for _ in range(PAIRS):
            pair = [self.start(words, out), self.start(words, out)]
            ends = [self.end(process) for process in pair]
            refused = [index for index, (_, errors) in enumerate(ends) if 'is being written' in errors]
            counts['pairs'] += 1
            counts['refused'] += len(refused)
            self.assertLess(len(refused), 2, 'both were refused')
            for index, (code, errors) in enumerate(ends):
                self.assertEqual(code, 1 if index in refused else 0, errors)
            for index in refused:
                self.assertRegex(ends[index][1], 'is being written by (process {}|another process)\n$'.format(
                    pair[1 - index].pid))
            self.assert_same(out, alone)
            if out.is_dir():
                shutil.rmtree(str(out))
            else:
                out.unlink()
            left = {path.name[len(out.name):] for path in self.folder.glob(out.name + '*')}
            self.assertLessEqual(left, {'.options'})
            for ending in left:
                Path(str(out) + ending).unlink()

    def test_convert(self):
        self.assert_neighbours('convert', 'convert', *LOGS, *SCENE)

    def test_inject(self):
        self.assert_neighbours('inject', 'inject', '--bag', self.bag('scene-0001'), '--type', 'rear_end', '--tta', 4,
                               '--now', 4)

    def test_generate(self):
        self.assert_neighbours('generate', 'generate', *LOGS, '--requests', self.requests)
        self.assert_neighbours('generate clips', 'generate', *LOGS, '--requests', self.requests, '--mode', 'replay',
                               '--format', 'csv-collide')

    def test_export(self):
        for form in ('openscenario', 'commonroad', 'scenarionet'):
            self.assert_neighbours('export ' + form, 'export', '--to', form, '--scenarios', self.scenarios, *LOGS)
        self.assert_neighbours('export mcap', 'export', '--to', 'mcap', '--bag', self.bag('scene-0001'))

    def test_report(self):
        self.assert_neighbours('report', 'report', self.scenarios, *LOGS)

    def test_train(self):
        self.assert_neighbours('study train', 'study', 'train', *LOGS, '--config', self.config, '--fold', 1, '--folds', 2)

    def test_two_files_of_one_folder_are_written_at_once(self):
        words = ('generate', *LOGS, '--requests', self.requests)
        outs = [self.path(name) for name in ('one.jsonl', 'two.jsonl')]
        for code, errors in [self.end(process) for process in [self.start(words, out) for out in outs]]:
            self.assertEqual(code, 0, errors)
        self.assertEqual(outs[0].read_bytes(), outs[1].read_bytes())

    def test_a_killed_run_is_followed_by_the_next(self):
        words, out = ('convert', *LOGS), self.path('out')
        process = self.start(words, out)
        while not (out / '.lock').exists():
            self.assertIsNone(process.poll())
            time.sleep(0.001)
        process.kill()
        process.communicate()
        self.assertTrue((out / '.lock').exists())
        code, errors = self.end(self.start(words, out))
        self.assertEqual(code, 0, errors)
        self.assertEqual({path.suffix for path in out.iterdir()}, {'.bag'})


if __name__ == '__main__':
    if PAIRS > 1:
        unittest.main()
    road.main()
