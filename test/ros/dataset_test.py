#!/usr/bin/python3
"""forge study dataset: contents of the folder, use by evaluate, resumption, any number of threads."""
import csv
import json
import math
import re
import shutil
import subprocess

import jsonschema

import road
from road import DATAROOT, PACKAGE_FOLDER, VERSION

SCHEMA = PACKAGE_FOLDER / 'docs' / 'scenario.schema.json'
SCENES = ['scene-0001', 'scene-0002', 'scene-0007']
# For a small set and pictures of it.
CHANGES = {'begin_stride': 1.0, 'lane_change': 3, 'rear_end': 3, 'opposite_direction': 1, 'junction_crossing': 3,
           'ltap': 1}
SPLITS = ['train', 'val', 'test']


def command(out, *arguments):
    return [str(word) for word in ('forge', 'study', 'dataset', '--dataroot', DATAROOT, '--version', VERSION,
                                   '--scene', *SCENES, '--out', out, *arguments)]


def run(words, **options):
    return subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
                          universal_newlines=True, timeout=road.TIMEOUT, check=False, **options)


def content(folder):
    """Return the bytes of each file under a folder, by path."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob('*') if path.is_file()}


def lines_of(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


class BuildDatasetTest(road.RoadTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.config = road.copy_config(cls.folder / 'config')
        dataset = cls.config / 'study/dataset.yaml'
        text = dataset.read_text()
        for key, value in CHANGES.items():
            text, count = re.subn(r'\b{}: [\d.]+'.format(key), '{}: {}'.format(key, value), text)
            assert count == 1, key
        dataset.write_text(text)
        cls.out = cls.folder / 'set'
        result = run(command(cls.out, '--config', cls.config, '--jobs', 1))
        assert result.returncode == 0, result.stderr
        cls.printed = result.stdout
        cls.expected = content(cls.out)

    def clips(self):
        return {split: sorted((self.out / 'trajectory' / split).glob('*.csv')) for split in SPLITS}

    def test_store_and_clips_hold_the_same_verified_attacks(self):
        schema = json.loads(SCHEMA.read_text())
        scenes = {}
        for split, clips in self.clips().items():
            scenarios = lines_of(self.out / 'scenarios' / (split + '.jsonl'))
            self.assertEqual(len(scenarios), len(clips))
            self.assertGreater(len(clips), 0)
            for scenario in scenarios:
                jsonschema.validate(scenario, schema)
                self.assertTrue(scenario['report']['verified'])
                self.assertLessEqual(abs(scenario['report']['contact_t'] - scenario['request']['tta']), 0.1 + 1e-6)
                self.assertLessEqual(scenario['report']['off_road_share'], 0.2)
            scenes[split] = {scenario['scene'] for scenario in scenarios}
        self.assertEqual(sum(map(len, scenes.values())), len(set.union(*scenes.values())), 'a scene in two splits')

    def test_recorded_attackers_keep_their_history_and_added_ones_have_one(self):
        tables = DATAROOT / VERSION
        times = {row['token']: row['timestamp'] for row in json.loads((tables / 'sample.json').read_text())}
        recorded = {(row['instance_token'], times[row['sample_token']]): row['translation']
                    for row in json.loads((tables / 'sample_annotation.json').read_text())}
        added = 0
        for clip in sum(self.clips().values(), []):
            attacker = clip.stem.split('_')[-1]
            with open(clip) as file:
                rows = [row for row in csv.DictReader(file) if row['TRACK_ID'] == attacker]
            self.assertEqual(len(rows), int(clip.stem.split('_')[-3].split('-')[-1]) + 1)
            is_added = attacker.startswith('added-')
            added += is_added
            for row in rows[:8]:
                if is_added:
                    self.assertGreater(math.hypot(float(row['X']), float(row['Y'])), 1.0, 'zeros are nobody')
                    continue
                x, y, _ = recorded[attacker, int(row['TIMESTAMP'])]
                self.assertAlmostEqual(float(row['X']), x, places=6)
                self.assertAlmostEqual(float(row['Y']), y, places=6)
        self.assertGreater(added, 0)

    def test_statistics_count_the_clips(self):
        with open(self.out / 'statistics.csv') as file:
            rows = list(csv.DictReader(file))
        for group in ('type', 'tta', 'location'):
            for split, clips in self.clips().items():
                self.assertEqual(sum(int(row[split]) for row in rows if row['group'] == group), len(clips), group)
        self.assertEqual(self.printed, (self.out / 'statistics.md').read_text())
        for row in rows:
            if row['group'] == 'type':
                self.assertGreaterEqual(float(row['share']), 0.02)

    def test_evaluate_reads_it_and_finds_the_hits(self):
        for protocol, column in (('published', 'collision'), ('strict', 'contact')):
            out = self.path(protocol)
            result = road.run('study', 'evaluate', '--collide', self.out, '--dataroot', DATAROOT, '--split', 'val',
                              '--protocol', protocol, '--method', 'recorded', '--out', out)
            self.assertEqual(result.returncode, 0, result.stderr)
            with open(out / 'results.csv') as file:
                rows = [row for row in csv.DictReader(line for line in file if not line.startswith('#'))
                        if row['method'] == 'recorded']
            self.assertEqual(len(rows), len(self.clips()['val']))
            for row in rows:
                self.assertEqual(row[column], '1', row)

    def test_threads_give_the_same_bytes_beside_a_page(self):
        threads = self.path('threads')
        page = threads / 'page'
        result = run(command(threads, '--config', self.config, '--jobs', 3, '--report', page))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue((page / 'index.html').exists())
        shutil.rmtree(str(page))
        self.assertEqual(content(threads), self.expected)


if __name__ == '__main__':
    road.main()
