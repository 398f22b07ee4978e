#!/usr/bin/python3
"""forge sweep, and forge test with several backgrounds and --steps, on embedded logs."""
import csv
import json
from pathlib import Path

import road
from road import DATAROOT, VERSION

ROOT = ('--source', DATAROOT, '--version', VERSION)
TESTS = ('--planners', 'idm', '--worst', 0, '--steps', '--background', 'replay,idm')
VARY = ('--vary', 'tta=3,4', '--vary', 'choice=existing,new')


def lines_of(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


def rows_of(path):
    with open(str(path)) as file:
        return list(csv.DictReader(file))


class SweepTest(road.RoadTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.out = cls.folder / 'sweep'
        cls.result = cls.sweep(*VARY, *TESTS, '--out', cls.out, '--report', cls.out / 'page')
        assert cls.result.returncode == 0, cls.result.stderr

    @staticmethod
    def sweep(*arguments):
        return road.run('sweep', *ROOT, '--scene', 'scene-0001', '--now', 5, '--type', 'rear_end', *arguments)

    def test_every_cell_has_a_verdict_of_every_planner_and_driver(self):
        cells = lines_of(self.out / 'sweep.jsonl')
        self.assertEqual([cell['values'] for cell in cells],
                         [{'tta': tta, 'choice': choice} for tta in (3, 4) for choice in ('existing', 'new')])
        feasible = [cell for cell in cells if cell['result']['status'] == 'OK']
        self.assertTrue(feasible)
        for cell in feasible:
            self.assertEqual([row['background'] for row in cell['result']['planners']], ['replay', 'idm'])
            self.assertEqual([driver['driver'] for driver in cell['result']['careful_drivers']],
                             ['cc_driver', 'r157_system', 'rss', 'fsm'])
        self.assertEqual(len(rows_of(self.out / 'sweep.csv')), len(feasible) + len(cells))
        self.assertEqual((self.out / 'map.png').read_bytes()[:4], b'\x89PNG')
        self.assertTrue((self.out / 'boundary.csv').read_text().startswith('name,tta,choice'))
        self.assertIn('planner or driver', self.result.stdout)
        self.assertTrue((self.out / 'page' / 'index.html').exists())

    def test_a_sweep_goes_on_to_the_same_files(self):
        before = {name: (self.out / name).read_bytes() for name in ('sweep.jsonl', 'sweep.csv', 'map.png')}
        (self.out / 'sweep.jsonl').unlink()
        result = self.sweep(*VARY, *TESTS, '--out', self.out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual({name: (self.out / name).read_bytes() for name in before}, before)
        result = self.sweep('--vary', 'tta=3,5', *TESTS, '--out', self.out)
        self.assertEqual(result.returncode, 1)
        self.assertIn('scenarios.jsonl', result.stderr)

    def test_the_summary_counts_verdicts_that_depend_on_the_traffic(self):
        self.assertIn('the verdict depends on the background traffic in ', self.result.stdout)
        names = {row['background'] for result in lines_of(self.out / 'results.jsonl') for row in result['planners']}
        self.assertEqual(names, {'replay', 'idm'})
        self.assertIn('| idm in idm traffic |', (self.out / 'table.md').read_text())

    def test_every_step_has_a_row(self):
        results = lines_of(self.out / 'results.jsonl')
        self.assertEqual({path.name for path in (self.out / 'steps').iterdir()},
                         {'{}.csv'.format(i + 1) for i, result in enumerate(results) if result['status'] != 'UNREADABLE'})
        number, result = next((i + 1, result) for i, result in enumerate(results) if result['status'] == 'OK')
        rows = rows_of(self.out / 'steps' / '{}.csv'.format(number))
        self.assertEqual(len(rows), sum(len(row['drive']['ego']['t']) for row in result['planners']))
        self.assertEqual(float(rows[0]['t']), 0.0)
        self.assertGreater(float(rows[0]['attacker_gap']), 0.0)

    def test_a_sweep_without_an_attack_writes_its_files(self):
        out = self.path('nothing')
        result = self.sweep('--vary', 'tta=3,4', '--impact-speed', 80, 90, '--planners', 'idm', '--out', out)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn('NOTHING_FEASIBLE', result.stderr)
        self.assertRegex(result.stdout, r'2 cells: 2 [A-Z_]+')
        self.assertEqual(len(lines_of(out / 'sweep.jsonl')), 2)
        self.assertTrue((out / 'map.png').exists())

    def test_an_unusable_traffic_model_is_named(self):
        bad = Path(self.path('bad.pt'))
        bad.write_text('no archive')
        result = road.run('test', *ROOT, '--scenarios', self.out / 'scenarios.jsonl', '--planners', 'idm', '--background',
                          'model:{}'.format(bad), '--out', self.path('model'))
        self.assertEqual(result.returncode, 1)
        self.assertIn('bad.pt: is not a TorchScript file', result.stderr)


if __name__ == '__main__':
    road.main()
