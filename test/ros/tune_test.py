#!/usr/bin/python3
"""forge tune: scenarios over embedded logs, resumption, and errors for invalid input."""
import csv
import json
import re

import road
from road import DATAROOT, VERSION

ROOT = ('--dataroot', DATAROOT, '--version', VERSION)
GRID = 'idm:\n  idm.standard.max_acceleration: [1.0, 4.0]\n  idm.standard.min_gap: [1.0, 4.0]\n'
FILES = ('train.jsonl', 'test.jsonl', 'variants.csv', 'table.csv', 'table.md', 'planners.yaml')


def lines_of(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def is_collision(row):
    contact = row['contact']
    return row['failure'] != 'none' or bool(contact and (contact['attacker'] or contact['at_fault']))


class TunePlannerTest(road.RoadTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.grid = cls.folder / 'grid.yaml'
        cls.grid.write_text(GRID)
        cls.train, cls.test = (cls.crashes(name, scene) for name, scene in (('a', 'scene-0001'), ('b', 'scene-0007')))
        cls.expected = cls.folder / 'expected'
        cls.result = cls.tune(cls.expected)
        assert cls.result.returncode == 0, cls.result.stderr

    @classmethod
    def crashes(cls, name, scene):
        requests, scenarios = cls.folder / (name + '_requests.jsonl'), cls.folder / (name + '.jsonl')
        for result in (road.run('requests', *ROOT, '--out', requests, '--scene', scene, '--stride', 8, '--tta', 2, 4),
                       road.run('generate', *ROOT, '--requests', requests, '--out', scenarios, '--mode', 'replay')):
            assert result.returncode == 0, result.stderr
        return scenarios

    @classmethod
    def words(cls, out, *arguments, grid=None, train=None, test=None):
        return ('tune', *ROOT, '--planner', 'idm', '--grid', grid or cls.grid, '--train', train or cls.train,
                '--test', test or cls.test, '--out', out, *arguments)

    @classmethod
    def tune(cls, out, *arguments, **files):
        return road.run(*cls.words(out, *arguments, **files))

    def assert_same(self, out):
        for name in FILES:
            self.assertEqual((out / name).read_bytes(), (self.expected / name).read_bytes(), name)

    def variants(self):
        with open(str(self.expected / 'variants.csv')) as file:
            return list(csv.DictReader(file))

    def test_the_best_has_the_fewest_collisions_then_the_most_progress(self):
        counted = [result['planners'] for result in lines_of(self.expected / 'train.jsonl')
                   if result['avoidability']['avoidable']]
        self.assertGreater(len(counted), 1)
        variants = self.variants()
        self.assertEqual([variant['variant'] for variant in variants], ['default', '1', '2', '3'])
        scores = []
        for index, variant in enumerate(variants):
            rows = [rows[index] for rows in counted]
            self.assertEqual({row['planner'] for row in rows}, {variant['variant']})
            collisions = sum(is_collision(row) for row in rows)
            self.assertEqual(variant['avoidable'], str(len(counted)))
            self.assertAlmostEqual(float(variant['collision']), collisions / len(rows), delta=1e-4)
            scores.append((collisions, -sum(row['progress'] for row in rows)))
        best = scores.index(min(scores))
        self.assertEqual([variant['best'] for variant in variants], ['1' if i == best else '0' for i in range(4)])

    def test_other_scenarios_have_no_rows_in_training_and_two_in_the_test(self):
        for result in lines_of(self.expected / 'train.jsonl'):
            if not result['avoidability']['avoidable']:
                self.assertEqual(result['planners'], [])
        tested = [result for result in lines_of(self.expected / 'test.jsonl') if result['status'] == 'OK']
        self.assertGreater(len(tested), 1)
        for result in tested:
            self.assertEqual([row['planner'] for row in result['planners']], ['default', 'tuned'])

    def test_planners_yaml_drives_as_tuned(self):
        best = next(variant for variant in self.variants() if variant['best'] == '1')
        tuned = (self.expected / 'planners.yaml').read_text()
        written = re.search(r'max_acceleration: (\S+) ', tuned).group(1)
        self.assertEqual(float(written), float(best['idm.standard.max_acceleration']))
        for name, planners in (('default', None), ('tuned', tuned)):
            config, out = road.copy_config(self.path(name + '_config')), self.path(name)
            if planners:
                (config / 'planners.yaml').write_text(planners)
            result = road.run('test', *ROOT, '--scenarios', self.test, '--planners', 'idm', '--out', out, '--worst',
                              0, '--config', config)
            self.assertEqual(result.returncode, 0, result.stderr)
            driven = [row for line in lines_of(out / 'results.jsonl') for row in line['planners']]
            expected = [dict(row, planner='idm') for line in lines_of(self.expected / 'test.jsonl')
                        for row in line['planners'] if row['planner'] == name]
            self.assertEqual(driven, expected)

    def test_report_is_printed_and_written(self):
        table = (self.expected / 'table.md').read_text()
        printed, _, files = self.result.stdout.rpartition('\nin ')
        self.assertTrue(table.startswith(printed))
        self.assertIn('| tuned - default |', printed)
        self.assertNotIn('nuPlan', printed, 'the tables are in files')
        self.assertIn('planners.yaml', files)
        for words in ('| idm.standard.min_gap | 1 | ', '| tuned - default |', 'Collisions with the attacker, of avoidable'):
            self.assertIn(words, table)
        with open(str(self.expected / 'table.csv')) as file:
            rows = list(csv.DictReader(file))
        self.assertLessEqual({'tuned_collision', 'collision_avoidable', 'progress'}, {row['measure'] for row in rows})

    def clips(self):
        """Create a folder of clips with the attacks of both files."""
        folder, requests = self.path('clips'), self.path('requests.jsonl')
        requests.write_text(''.join((self.folder / (name + '_requests.jsonl')).read_text() for name in ('a', 'b')))
        result = road.run('generate', *ROOT, '--requests', requests, '--out', folder, '--format', 'csv-collide',
                          '--mode', 'replay')
        self.assertEqual(result.returncode, 0, result.stderr)
        return folder

    def tune_on(self, clips, out, *arguments):
        return road.run('study', 'tune', '--dataroot', DATAROOT, '--planner', 'idm', '--grid', self.grid, '--collide',
                        clips, '--out', out, *arguments)

    def test_clips_of_one_scene_are_tuned_on_and_those_of_the_other_compared_on(self):
        out, clips = self.path('out'), self.clips()
        result = self.tune_on(clips, out, '--train-method', 'constant_velocity', '--test-method', 'search')
        self.assertEqual(result.returncode, 0, result.stderr)
        names = sorted(path.stem for path in (clips / 'trajectory' / 'val').iterdir())
        for part, scene, method in (('train', 'scene-0001', 'constant_velocity'), ('test', 'scene-0007', 'search')):
            self.assertEqual(sorted(result['name'] for result in lines_of(out / (part + '.jsonl'))),
                             [name for name in names if scene in name])
            options = (out / (part + '.jsonl.options')).read_text()
            self.assertIn('attacker history by ' + method + ', unverified', options)
        self.assertIn('Test: ', result.stdout)

    def test_training_without_an_avoidable_crash_is_an_error(self):
        out, train = self.path('out'), self.path('bad.jsonl')
        train.write_text('no scenario\n')
        result = road.run(*self.words(out, train=train))
        self.assertNotEqual(result.returncode, 0)
        self.assertIn('no avoidable collision', result.stderr)


if __name__ == '__main__':
    road.main()
