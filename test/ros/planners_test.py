#!/usr/bin/python3
"""forge test: scenarios over embedded logs, synthetic clips, resumption, and errors for invalid input."""
import csv
import json
import subprocess
import sys
from pathlib import Path

import road
from road import DATAROOT, VERSION

sys.path += [str(Path(__file__).resolve().parent.parent / folder) for folder in ('study/evaluation', 'planner_test/trials')]
import collide_clips  # noqa: E402
import published_idm_parity  # noqa: E402

HERE = Path(__file__).resolve().parent
LINE_IDM = 'rosrun collision_forge line_planner idm'
LINE_NODE = HERE / 'line_planner_node.py'
PNG = b'\x89PNG'
ROOT = ('--dataroot', DATAROOT, '--version', VERSION)


def lines_of(out):
    return [json.loads(line) for line in (out / 'results.jsonl').read_text().splitlines()]


class TestPlannersTest(road.RoadTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        requests = cls.folder / 'requests.jsonl'
        cls.scenarios = cls.folder / 'crashes.jsonl'
        for result in (road.run('requests', *ROOT, '--out', requests, '--scene', 'scene-0001', 'scene-0007',
                                '--stride', 8, '--tta', 2, 4),
                       road.run('generate', *ROOT, '--requests', requests, '--out', cls.scenarios, '--mode', 'replay')):
            assert result.returncode == 0, result.stderr
        cls.expected = cls.folder / 'expected'
        cls.result = cls.run_on(cls.scenarios, cls.expected)
        assert cls.result.returncode == 0, cls.result.stderr

    @staticmethod
    def run_on(scenarios, out, *arguments):
        return road.run('test', *ROOT, '--scenarios', scenarios, '--planners', 'idm,idm_published', '--out', out,
                        *arguments)

    def assert_same(self, out, names=('results.jsonl', 'results.csv', 'table.csv', 'table.md')):
        for name in names:
            self.assertEqual((out / name).read_bytes(), (self.expected / name).read_bytes(), name)

    def test_every_scenario_has_a_line_and_every_planner_a_row(self):
        scenarios = [json.loads(line) for line in self.scenarios.read_text().splitlines()]
        results = lines_of(self.expected)
        self.assertEqual([result['name'] for result in results],
                         ['crashes:{}'.format(number + 1) for number in range(len(scenarios))])
        tested = 0
        for scenario, result in zip(scenarios, results):
            self.assertEqual(result['status'], scenario['status']['code'])
            self.assertEqual(result['scene'], scenario['scene'])
            if result['status'] == 'OK':
                tested += 1
                self.assertEqual([row['planner'] for row in result['planners']], ['idm', 'idm_published'])
        self.assertGreater(tested, 3)
        with open(str(self.expected / 'results.csv')) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(results) + tested)

    def run_external(self, mode, *arguments):
        out = self.path('external_' + mode)
        node = '/usr/bin/python3 {} {}'.format(HERE / 'odd_planner.py', mode)
        result = self.run_on(self.scenarios, out, '--planners', 'external', '--planner-node', node, *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        left = subprocess.run(['pgrep', '-f', 'odd_planner.py ' + mode], stdout=subprocess.PIPE, check=False)
        self.assertEqual(left.stdout, b'')
        return [row for result in lines_of(out) for row in result.get('planners', []) if row['planner'] == 'external']

    def test_a_planner_in_a_node_drives_every_case(self):
        rows = self.run_external('straight', '--jobs', 2)
        self.assertGreater(len(rows), 3)
        self.assertLessEqual({row['failure'] for row in rows}, {'none', 'off_map'})

    def test_a_node_that_dies_is_replaced(self):
        rows = self.run_external('dies', '--jobs', 1)
        self.assertEqual({row['failure'] for row in rows}, {'timed_out'})
        self.assertEqual({row['contact'] for row in rows}, {None})

    def run_idm(self, name, *arguments):
        """Drive idm as an external planner and return its rows under the name idm."""
        out = self.path('idm_' + name)
        result = road.run('test', *ROOT, '--scenarios', self.scenarios, '--planners', 'external', '--out', out,
                          *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return [dict(row, planner='idm') for line in lines_of(out) for row in line.get('planners', [])]

    def test_a_planner_drives_the_same_in_this_process_as_a_command_and_as_a_node(self):
        expected = [line['planners'][0] for line in lines_of(self.expected) if line.get('planners')]
        self.assertEqual(self.run_idm('command', '--planner-command', LINE_IDM), expected)
        rows = self.run_idm('node', '--planner-node', '/usr/bin/python3 {} {}'.format(LINE_NODE, LINE_IDM))
        self.assertEqual(len(rows), len(expected))
        for row, known in zip(rows, expected):
            self.assertEqual((row['failure'], row['plans']), (known['failure'], known['plans']))
            self.assertAlmostEqual((row['contact'] or {}).get('t', 0), (known['contact'] or {}).get('t', 0), delta=1e-5)
            for axis in 'xy':  # a quaternion rounds the yaw
                for place, other in zip(row['drive']['ego'][axis], known['drive']['ego'][axis]):
                    self.assertAlmostEqual(place, other, delta=1e-5)

    def test_a_line_for_each_planner_is_printed(self):
        lines = self.result.stdout.splitlines()
        self.assertLessEqual(len(lines), 10)
        self.assertEqual(lines[1].split()[:6], ['planner', 'scenes', 'cases', 'hit', 'avoidable', 'failed'])
        results = [result for result in lines_of(self.expected) if result['status'] == 'OK']
        for index, line in enumerate(lines[2:4]):
            rows = [result['planners'][index] for result in results]
            hits = [row['contact']['impact_speed'] for row in rows
                    if row['failure'] == 'none' and row['contact'] and row['contact']['attacker']]
            found = line.split()
            self.assertEqual(found[0], ('idm', 'idm_published')[index])
            self.assertEqual([int(count) for count in found[1:4]],
                             [len({result['scene'] for result in results}), len(results), len(hits)])
            self.assertAlmostEqual(float(found[7]), max(hits), delta=0.051)
        self.assertIn(str(self.expected) + ': table.md', lines[4])

    def test_report_is_written(self):
        table = (self.expected / 'table.md').read_text()
        self.assertIn('Collisions with the attacker, of avoidable crashes, %', table)
        with open(str(self.expected / 'table.csv')) as file:
            measures = {row['measure'] for row in csv.DictReader(file)}
        self.assertLessEqual({'collision', 'avoidable', 'impact_speed', 'failure'}, measures)

    def test_worst_cases_are_drawn(self):
        hits = {row['planner'] for result in lines_of(self.expected) if result['avoidability']['avoidable']
                for row in result['planners'] if row['contact'] and row['contact']['attacker']}
        self.assertTrue(hits)
        for planner in hits:
            self.assertEqual((self.expected / 'worst' / (planner + '_fixed_1.png')).read_bytes()[:4], PNG)
            self.assertEqual((self.expected / 'worst' / (planner + '_fixed_1.gif')).read_bytes()[:4], b'GIF8')

    def test_until_hit_shows_weaknesses_with_witnesses(self):
        out, again = self.path('hit'), self.path('again')
        for folder, jobs in ((out, 1), (again, 2)):
            result = road.run('test', *ROOT, '--until-hit', '--scene', 'scene-0001', 'scene-0007', '--planners', 'idm',
                              '--tries', 28, '--worst', 0, '--jobs', jobs, '--out', folder)
            self.assertEqual(result.returncode, 0, result.stderr)
        for name in ('results.jsonl', 'weaknesses.md', 'weaknesses.jsonl', 'witnesses.jsonl'):
            self.assertEqual((again / name).read_bytes(), (out / name).read_bytes(), name)
        table = (out / 'weaknesses.md').read_text()
        lines = result.stdout.splitlines()
        self.assertLessEqual(len(lines), 11)
        self.assertIn(table.splitlines()[0], lines)
        shown = [line for line in lines if line.startswith('  ') and ' idm against adaptive: ' in line]
        self.assertEqual(len(shown), min(5, table.count('| idm against adaptive |')))
        results = {result['name']: result for result in lines_of(out)}
        self.assertEqual(len(results), 28)
        witnesses = [json.loads(line) for line in (out / 'witnesses.jsonl').read_text().splitlines()]
        self.assertGreater(len(witnesses), 0)
        speeds = []
        for rank, witness in enumerate(witnesses, 1):
            row = results[witness['name']]['planners'][0]
            self.assertTrue(row['contact']['attacker'] and row['fair'])
            self.assertNotEqual(row['contact']['cause'], 'rear', 'who runs into the ego from behind is at fault')
            self.assertEqual(row['evasion']['last']['start_t'], witness['start_t'])
            self.assertLess(witness['start_t'], row['contact']['t'])
            self.assertGreater(witness['ego'][-1]['t'], row['contact']['t'])
            speeds.append(row['contact']['impact_speed'])
            for name in ('{}.png', '{}_escape.png'):
                self.assertEqual((out / 'weaknesses' / name.format(rank)).read_bytes()[:4], PNG)
        self.assertEqual(speeds, sorted(speeds, reverse=True))
        tested = road.run('test', *ROOT, '--scenarios', out / 'weaknesses.jsonl', '--planners', 'idm',
                          '--attacker-policy', 'adaptive', '--worst', 0, '--out', self.path('tested'))
        self.assertEqual(tested.returncode, 0, tested.stderr)
        for result, speed in zip(lines_of(self.path('tested')), speeds):
            self.assertAlmostEqual(result['planners'][0]['contact']['impact_speed'], speed, 3)

    def test_until_hit_draws_from_a_catalogue(self):
        out = self.path('named')
        names = ('26_lead_vehicle_stopped', '30_straight_crossing_paths')
        result = road.run('test', *ROOT, '--until-hit', '--catalogue', 'nhtsa', '--name', *names, '--scene', 'scene-0001',
                          'scene-0007', '--planners', 'idm', '--tries', 6, '--worst', 0, '--out', out)
        self.assertEqual(result.returncode, 0, result.stderr)
        results = lines_of(out)
        self.assertEqual(len(results), 6)
        cells = {'nhtsa/' + cell for cell in (names[0], names[1] + ' from_side=left', names[1] + ' from_side=right')}
        for one in results:
            self.assertTrue(any(cell in one['name'] for cell in cells), one['name'])
        self.assertTrue(any(one['planners'] for one in results))
        unknown = road.run('test', *ROOT, '--until-hit', '--catalogue', 'nhtsa', '--name', '26_lead_vehicle_stoped', '--planners',
                           'idm', '--out', self.path('unknown'))
        self.assertEqual(unknown.returncode, 1)
        self.assertIn('did you mean 26_lead_vehicle_stopped?', unknown.stderr)

    def test_bad_lines_are_cases_of_their_own(self):
        scenarios, out = self.path('bad.jsonl'), self.path('out')
        attack = next(line for line in self.scenarios.read_text().splitlines() if '"code":"OK"' in line)
        parsed = json.loads(attack)
        touching = json.loads(attack)
        ego = next(result for result in lines_of(self.expected) if result['status'] == 'OK')
        touching['attacker']['trajectory'][0].update(self.ego_pose(parsed))
        scenarios.write_text('\n'.join([
            attack.replace('"version":7', '"version":8'),
            attack.replace(parsed['scene'], 'scene-9999'),
            attack.replace('"now":16', '"now":17'),
            json.dumps(touching),
            attack,
            attack[:100]]) + '\n')
        result = self.run_on(scenarios, out)
        self.assertEqual(result.returncode, 0, result.stderr)
        results = lines_of(out)
        self.assertEqual([result['status'] for result in results],
                         ['UNREADABLE', 'UNREADABLE', 'NO_SCENE', 'UNFIT', 'OK', 'UNREADABLE'])
        for result, word in zip(results, ('version', 'scene-9999', 'frame', 'touches the ego', '', 'line 6')):
            self.assertIn(word, result['message'])
        self.assertEqual(results[4]['planners'], ego['planners'])
        with open(str(out / 'results.csv')) as file:
            rows = {row['name']: row for row in csv.DictReader(file)}
        for result in results:
            if result['status'] == 'UNREADABLE':
                for field in ('source', 'scene', 'type', 'tta', 'now'):
                    self.assertIsNone(result[field])
                    self.assertEqual(rows[result['name']].get(field, ''), '')
        table = (out / 'table.md').read_text()
        self.assertIn('- not tested, UNREADABLE: 3', table)
        self.assertNotIn('idm / ', table, 'all cases are of one source')

    def test_nothing_to_test_is_an_error(self):
        scenarios, out = self.path('bad.jsonl'), self.path('out')
        scenarios.write_text('{}\n[]\n')
        for _ in range(2):
            result = self.run_on(scenarios, out)
            self.assertEqual(result.returncode, 1, result.stdout)
            for word in ('results.jsonl', 'no case could be tested (2 tried)', 'bad:1', 'format'):
                self.assertIn(word, result.stderr)
            self.assertEqual(len(lines_of(out)), 2)
            self.assertFalse((out / 'table.md').exists())

    @staticmethod
    def ego_pose(scenario):
        """Return the position of the ego's box centre at t0, from the embedded tables."""
        recording = collide_clips.Recording(DATAROOT / VERSION, scenario['scene'])
        frame = min(range(len(recording.timestamps)),
                    key=lambda i: abs(recording.timestamps[i] * 1e-6 - scenario['now']))
        x, y, yaw = recording.tracks['ego'][frame]
        return {'x': x, 'y': y, 'yaw': yaw}

    def test_the_learned_planner_drives_beside_another(self):
        out, again = self.path('out'), self.path('again')
        for folder, jobs in ((out, 1), (again, 2)):
            result = self.run_on(self.scenarios, folder, '--planners', 'torchscript', '--worst', 0, '--jobs', jobs)
            self.assertEqual(result.returncode, 0, result.stderr)
        rows = [row for result in lines_of(out) for row in result['planners'] if row['planner'] == 'torchscript']
        self.assertGreater(len(rows), 3)
        self.assertLessEqual({row['failure'] for row in rows}, {'none', 'off_map'})
        self.assertEqual((out / 'results.jsonl').read_bytes(), (again / 'results.jsonl').read_bytes())
        other = self.path('other.pt')
        other.write_bytes((road.PACKAGE_FOLDER / 'data' / 'weights' / 'planner.pt').read_bytes() + b' ')
        result = self.run_on(self.scenarios, out, '--planners', 'torchscript', '--planner-file', other)
        self.assertEqual(result.returncode, 1)
        self.assertIn('planner_file', result.stderr)


class TestPlannersOnClipsTest(road.RoadTest):
    def run_on(self, collide, out, *arguments):
        return road.run('study', 'test', '--dataroot', DATAROOT, '--collide', collide, '--out', out, '--worst', 0,
                        *arguments)

    def test_embedded_clips_with_every_attacker(self):
        collide = self.path('collide')
        for scene, first, last in (('scene-0005', 12, 23), ('scene-0010', 14, 23)):
            collide_clips.write_embedded_clip(collide / 'trajectory' / 'val', DATAROOT / VERSION, scene, first, last)
        for attacker in ('recorded', 'history', 'replay'):
            out = self.path(attacker)
            result = self.run_on(collide, out, '--drive', attacker, '--planners', 'idm')
            self.assertEqual(result.returncode, 0, result.stderr)
            results = lines_of(out)
            self.assertEqual(len(results), 2)
            self.assertEqual({entry['source'] for entry in results}, {attacker})
            if attacker == 'recorded':
                self.assertEqual([entry['status'] for entry in results], ['OK', 'OK'])
                self.assertTrue(all(entry['strict'] for entry in results))

    def test_hits_of_published_idm_are_compared_clip_by_clip(self):
        collide, out = self.path('collide'), self.path('out')
        collide_clips.write_random_clips(collide / 'trajectory' / 'val', 20, 'embedded-right', 3)
        result = self.run_on(collide, out, '--planners', 'idm_published', '--jobs', 2)
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(str(out / 'results.csv')) as file:
            hits = {row['name']: int(row['published_hit']) for row in csv.DictReader(file) if row['published_hit']}
        fixture = self.path('fixture.json')
        for flipped, code in ((0, 0), (1, 1)):
            cases = [{'in': name + '.csv', 'out': ['none', hit ^ (number < flipped)]}
                     for number, (name, hit) in enumerate(sorted(hits.items()))]
            fixture.write_text(json.dumps({'out_fields': ['end', 'hit'], 'cases': cases}))
            self.assertEqual(published_idm_parity.main(out / 'results.csv', fixture), code)


if __name__ == '__main__':
    road.main()
