#!/usr/bin/python3
"""forge requests and generate: contents of the files, resumption after interruptions, any number of threads."""
import csv
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import time
from pathlib import Path

import jsonschema

import road
from road import DATAROOT, PACKAGE_FOLDER, VERSION

SCHEMA = PACKAGE_FOLDER / 'docs' / 'scenario.schema.json'
REQUEST_SCHEMA = json.loads((PACKAGE_FOLDER / 'docs' / 'request.schema.json').read_text(encoding='utf-8'))
ROOT = ('--dataroot', DATAROOT, '--version', VERSION)
SEED = int(os.environ.get('PROPERTY_SEED', '1'))  # of the first random list
LISTS = 3
WAIT = 60.0  # s for something to happen that takes less than one


def make_requests(out, *arguments, dataroot=DATAROOT):
    return road.run('requests', '--dataroot', dataroot, '--version', VERSION, '--out', out, *arguments)


def generate_command(requests, out, *arguments):
    """Add --mode history unless there is a --mode."""
    if '--mode' not in arguments:
        arguments += ('--mode', 'history')
    return [str(word) for word in ('forge', 'generate', *ROOT, '--requests', requests, '--out', out, *arguments)]


def run(command, **options):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
                          universal_newlines=True, timeout=road.TIMEOUT, check=False, **options)


def lines_of(path):
    return path.read_text().splitlines()


def complete_lines(path):
    """Return the number of lines of a file; 0 if it does not exist."""
    return path.read_bytes().count(b'\n') if path.exists() else 0


class RequestsTest(road.RoadTest):
    def requests(self, *arguments):
        result = make_requests(self.path('requests.jsonl'), *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        requests = [json.loads(line) for line in lines_of(self.path('requests.jsonl'))]
        for request in requests:
            jsonschema.validate(request, REQUEST_SCHEMA)
        return requests

    def test_a_request_in_words_is_a_line_of_a_list(self):
        result = road.run('ask', 'purple truck cuts in from the left in 3 s, 30 km/h slower, quarter overlap',
                          '--scene', 'scene-0003', '--now', 1.5)
        self.assertEqual(result.returncode, 0, result.stderr)
        request = json.loads(result.stdout)
        jsonschema.validate(request, REQUEST_SCHEMA)
        self.assertEqual((request['manoeuvre'], request['tta'], request['scene']), ('cut_in', 3, 'scene-0003'))
        self.assertIn('understood "truck": attacker_class = truck\n', result.stderr)
        self.assertIn('not understood: purple\n', result.stderr)
        refused = road.run('ask', 'CBDA')
        self.assertEqual((refused.returncode, refused.stdout), (1, ''))
        self.assertIn('doors do not open', refused.stderr)

    def test_every_request_is_possible_and_in_order(self):
        samples = json.loads((DATAROOT / VERSION / 'sample.json').read_text())
        scenes = json.loads((DATAROOT / VERSION / 'scene.json').read_text())
        frames = {scene['name']: sorted(row['timestamp'] * 1e-6 for row in samples
                                        if row['scene_token'] == scene['token']) for scene in scenes}
        requests = self.requests()
        for request in requests:
            times = frames[request['scene']]
            self.assertIn(request['now'], times)
            self.assertGreater(request['now'], times[0], 'history')
            self.assertLessEqual(request['now'] + request['tta'] + 0.5, times[-1])
            self.assertEqual((request['attacker'], request['seed']), (None, 0))
        order = [(request['scene'], request['now'], request['tta']) for request in requests]
        self.assertEqual(order, sorted(order))
        self.assertEqual(len({json.dumps(request) for request in requests}), len(requests))
        self.assertEqual({request['tta'] for request in requests}, {2, 3, 4, 5, 6})
        self.assertEqual(len({request['type'] for request in requests}), 5)

    def test_the_options_are_kept(self):
        requests = self.requests('--scene', 'scene-0003', 'scene-0001', '--types', 'RE', 'ltap', '--tta', 4.5,
                                 '--stride', 4, '--seed', 9)
        self.assertEqual([request['scene'] for request in requests],
                         sorted(request['scene'] for request in requests), "the table's order")
        self.assertEqual({request['scene'] for request in requests}, {'scene-0001', 'scene-0003'})
        self.assertEqual({request['type'] for request in requests}, {'rear_end', 'ltap'})
        self.assertEqual({(request['tta'], request['seed']) for request in requests}, {(4.5, 9)})
        nows = sorted({request['now'] for request in requests if request['scene'] == 'scene-0001'})
        for before, after in zip(nows, nows[1:]):
            self.assertAlmostEqual(after - before, 4.0, places=1)

    def test_requests_the_road_allows_are_counted_and_optionally_filtered(self):
        whole, allowed = self.path('requests.jsonl'), self.path('allowed.jsonl')
        arguments = ('--scene', 'scene-0001', 'scene-0007', '--stride', 4, '--tta', 2, 4)
        results = [make_requests(whole, *arguments), make_requests(allowed, *arguments, '--allowed-only')]
        for result in results:
            self.assertEqual(result.returncode, 0, result.stderr)
        everything, kept = lines_of(whole), lines_of(allowed)
        self.assertEqual([line for line in everything if line in kept], kept)
        self.assertLess(len(kept), len(everything))
        counts = results[0].stdout.splitlines()[1:]
        self.assertEqual(results[1].stdout.splitlines()[1:], counts)
        types = sorted({json.loads(line)['type'] for line in everything})
        expected = {name: (sum(json.loads(line)['type'] == name for line in kept),
                           sum(json.loads(line)['type'] == name for line in everything)) for name in types}
        expected['all'] = (len(kept), len(everything))
        self.assertEqual(set(counts), {'{}: the road allows {} of {} requests'.format(name, *count)
                                       for name, count in expected.items()})

    def test_duplicate_requests_are_listed_once(self):
        once = self.requests('--scene', 'scene-0001', '--types', 'RE', 'ltap', '--tta', 4, 3)
        self.assertEqual(self.requests('--scene', 'scene-0001', 'scene-0001', '--types', 'RE', 'ltap', 'rear_end', 'RE',
                                       '--tta', 4, 3, '4.0', 3), once)

    def test_each_attacker_has_a_request(self):
        requests = self.requests('--scene', 'scene-0001', '--attackers', 'each', '--types', 'RE', '--tta', 4)
        instances = {row['token'] for row in json.loads((DATAROOT / VERSION / 'instance.json').read_text())}
        self.assertGreater(len(requests), 10)
        for request in requests:
            self.assertIn(request['attacker'], instances)

    def test_only_controls_that_are_not_by_default_are_written(self):
        plain = self.requests('--scene', 'scene-0001', '--types', 'RE', '--tta', 4)
        self.assertEqual(self.requests('--scene', 'scene-0001', '--types', 'RE', '--tta', 4, '--believable', 'true',
                                       '--limits', 'drivable'), plain)
        asked = self.requests('--scene', 'scene-0001', '--tta', 4, '--attackers', 'existing', '--manoeuvre',
                              'lead_brakes', '--believable', 'false', '--impact-speed', 2, 9.5, '--overlap', 0.25, 1)
        self.assertEqual(asked, [dict(request, choice='existing', believable=False, manoeuvre='lead_brakes',
                                      impact_speed={'min': 2, 'max': 9.5}, overlap={'min': 0.25, 'max': 1})
                                 for request in plain])

    def test_a_faster_ego_than_any_leaves_no_request(self):
        result = make_requests(self.path('none.jsonl'), '--min-ego-speed', 100)
        self.assertEqual(result.returncode, 1)
        self.assertIn('no request', result.stderr)
        self.assertFalse(self.path('none.jsonl').exists())


class GenerateTest(road.RoadTest):
    """Runs over one list of about 100 requests."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.requests = cls.folder / 'requests.jsonl'
        result = make_requests(cls.requests, '--scene', 'scene-0001', 'scene-0007', '--stride', 3, '--tta', 2, 4, 6)
        assert result.returncode == 0, result.stderr
        cls.expected = cls.folder / 'expected.jsonl'
        result = run(generate_command(cls.requests, cls.expected, '--jobs', 1))
        assert result.returncode == 0, result.stderr
        cls.count = len(lines_of(cls.requests))

    def setUp(self):
        self.out = self.path('out.jsonl')
        self.part = self.path('out.jsonl.part')

    def start(self, command, **options):
        """Start a run; the end of the test kills it."""
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
                                   universal_newlines=True, **options)
        self.addCleanup(lambda: (process.kill(), process.communicate()))
        return process

    def start_and_wait_for_lines(self, command, count, **options):
        process = self.start(command, **options)
        deadline = time.monotonic() + WAIT
        while complete_lines(self.part) < count:
            self.assertIsNone(process.poll(), 'ended too soon')
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.005)
        return process

    def assert_goes_on(self, before, command=None, **options):
        """Check that a resumed run repeats no item and gives the output of an uninterrupted run."""
        kept = complete_lines(self.part)
        self.assertGreaterEqual(kept, before)
        self.assertLess(kept, self.count)
        self.assertFalse(self.out.exists())
        result = run(command or generate_command(self.requests, self.out, '--jobs', 2), **options)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('{} of {} requests were done in an earlier run'.format(kept, self.count), result.stderr)
        self.assertEqual(self.out.read_bytes(), self.expected.read_bytes())
        self.assertFalse(self.part.exists())

    def assert_refused(self, named, *arguments, requests=None):
        result = run(generate_command(requests or self.requests, self.out, *arguments))
        self.assertEqual(result.returncode, 1, result.stderr)
        for text in named:
            self.assertIn(str(text), result.stderr)

    def test_lines_answer_the_requests_in_order(self):
        scenarios = [json.loads(line) for line in lines_of(self.expected)]
        requests = [json.loads(line) for line in lines_of(self.requests)]
        self.assertEqual(len(scenarios), len(requests))
        for scenario, request in zip(scenarios, requests):
            self.assertEqual((scenario['scene'], scenario['now']), (request['scene'], request['now']))
            self.assertEqual(scenario['request'], {'type': request['type'], 'tta': request['tta'], 'attacker': None,
                                                   'choice': 'any', 'believable': True, 'limits': 'drivable',
                                                   'attacker_class': None, 'manoeuvre': None, 'ego_side': None,
                                                   'impact_speed': None, 'overlap': None, 'alternatives': 1, 'mode': 'history', 'seed': 0})
        self.assertGreater(len({scenario['status']['code'] for scenario in scenarios}), 1)

    def test_the_command_line_precedes_the_list(self):
        result = run(generate_command(self.requests, self.out, '--believable', 'false', '--attacker-class', 'truck',
                                      '--attacker', 'existing'))
        self.assertEqual(result.returncode, 0, result.stderr)
        validator = jsonschema.Draft202012Validator(json.loads(SCHEMA.read_text()))
        for scenario in map(json.loads, lines_of(self.out)):
            validator.validate(scenario)
            request = scenario['request']
            self.assertEqual((request['believable'], request['attacker_class'], request['choice']),
                             (False, 'truck', 'existing'))
            if scenario['attacker']:
                self.assertEqual((scenario['attacker']['class'], scenario['attacker']['origin']), ('truck', 'recorded'))

    def test_alternatives_differ_in_attacker_or_manoeuvre_and_leave_the_first_as_it_is(self):
        few = self.path('few.jsonl')
        few.write_text('\n'.join(lines_of(self.requests)[::6]) + '\n')
        result = run(generate_command(few, self.out, '--alternatives', 3))
        self.assertEqual(result.returncode, 0, result.stderr)
        validator = jsonschema.Draft202012Validator(json.loads(SCHEMA.read_text()))
        counts = set()
        for line, first in zip(lines_of(self.out), lines_of(self.expected)[::6]):
            scenario, alone = json.loads(line), json.loads(first)
            validator.validate(scenario)
            for field in ('status', 'attacker', 'report'):
                self.assertEqual(scenario[field], alone[field])
            self.assertEqual(alone['alternatives'], [])
            if scenario['attacker']:
                attacks = [scenario] + scenario['alternatives']
                kinds = {(attack['attacker']['id'], attack['report']['manoeuvre']) for attack in attacks}
                self.assertEqual(len(kinds), len(attacks))
                self.assertTrue(all(attack['report']['verified'] for attack in attacks))
                counts.add(len(attacks))
            else:
                self.assertEqual(scenario['alternatives'], [])
        self.assertEqual(max(counts), 3)

    def test_lines_keep_the_schema(self):
        schema = json.loads(SCHEMA.read_text())
        validator = jsonschema.Draft202012Validator(schema)
        validator.check_schema(schema)
        for line in lines_of(self.expected):
            validator.validate(json.loads(line))

    def test_the_schema_rejects_invalid_scenarios(self):
        validator = jsonschema.Draft202012Validator(json.loads(SCHEMA.read_text()))
        good = next(line for line in lines_of(self.expected) if '"code":"OK"' in line)
        for change in (lambda row: row.pop('ego'), lambda row: row.update(extra=1), lambda row: row.update(version=2),
                       lambda row: row['status'].update(code='FINE'), lambda row: row.update(attacker=None),
                       lambda row: row.update(confidence=1.5), lambda row: row['request'].update(type='drift'),
                       lambda row: row['attacker']['trajectory'][0].pop('kappa'),
                       lambda row: row['attacker'].update(trajectory=[]),
                       lambda row: row['attacker'].update(origin='added', past=None),
                       lambda row: row['attacker'].update({'class': 'tank'}),
                       lambda row: row['request'].update(manoeuvre='swerve'),
                       lambda row: row['report'].update(believable=False, unbelievable=None),
                       lambda row: row['status'].update(code='NO_CANDIDATE')):
            scenario = json.loads(good)
            change(scenario)
            self.assertFalse(validator.is_valid(scenario))

    def test_random_lists_have_the_same_bytes_whatever_the_number_of_jobs(self):
        for seed in range(SEED, SEED + LISTS):
            draw = random.Random(seed)
            requests, alone = self.path('requests.jsonl'), self.path('alone.jsonl')
            listed = draw.sample(lines_of(self.requests), draw.randint(1, 9))
            requests.write_text('\n'.join(json.dumps(dict(json.loads(line), seed=draw.randrange(1000),
                                                          believable=draw.random() < 0.7)) for line in listed) + '\n')
            mode = draw.choice(['history', 'replay', 'adaptive'])
            commands = [(alone, generate_command(requests, alone, '--mode', mode, '--jobs', 1))]
            for jobs in (2, 3):
                out = self.path('{}.jsonl'.format(jobs))
                commands.append((out, generate_command(requests, out, '--mode', mode, '--jobs', jobs)))
            for out, command in commands:
                told = 'PROPERTY_SEED={}: {}'.format(seed, ' '.join(command))
                result = run(command)
                self.assertEqual(result.returncode, 0, told + '\n' + result.stderr)
                self.assertEqual(out.read_bytes(), alone.read_bytes(), told)
            for out, _ in commands:
                out.unlink()
                Path(str(out) + '.options').unlink()

    def test_an_interrupted_run_says_so_and_goes_on(self):
        for signal_sent in (signal.SIGINT, signal.SIGTERM):
            process = self.start_and_wait_for_lines(generate_command(self.requests, self.out, '--jobs', 2), 5)
            process.send_signal(signal_sent)
            _, errors = process.communicate(timeout=WAIT)
            self.assertEqual(process.returncode, -signal_sent)
            self.assertIn('interrupted', errors)
            self.assertIn(str(self.part), errors)
            self.assert_goes_on(5)
            self.out.unlink()

    def test_changed_tables_and_maps_prevent_resuming(self):
        lines = self.expected.read_bytes().splitlines(keepends=True)
        dataroot = self.path('data')
        shutil.copytree(str(DATAROOT), str(dataroot))
        command = [word if word != str(DATAROOT) else str(dataroot) for word in
                   map(str, generate_command(self.requests, self.out))]
        self.assertEqual(run(command).returncode, 0)
        self.assertEqual(self.out.read_bytes(), self.expected.read_bytes())
        self.out.unlink()
        road.leave_part(self.out, b''.join(lines[:7]))
        for name, file in (('tables', dataroot / VERSION / 'ego_pose.json'),
                           ('maps', dataroot / 'maps' / 'expansion' / 'embedded-right.json')):
            original = file.read_bytes()
            file.write_bytes(original + b'\n')
            result = run(command)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertRegex(result.stderr, 'was made with {} = .*, not '.format(name))
            file.write_bytes(original)
        self.assertEqual(run(command).returncode, 0)
        self.assertEqual(self.out.read_bytes(), self.expected.read_bytes())

    def test_a_full_disk_is_reported_and_the_run_can_be_resumed(self):
        room = 100000  # bytes; for a few of the lines

        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))

        result = run(generate_command(self.requests, self.out), preexec_fn=limit)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(str(self.part) + ': cannot be written: File too large', result.stderr)
        self.assertTrue(self.part.read_bytes().endswith(b'\n'), 'no half of a line')
        self.assert_goes_on(3)

    def test_a_run_does_not_resume_another_run(self):
        begun = b''.join(self.expected.read_bytes().splitlines(keepends=True)[:4])
        road.leave_part(self.out, begun)
        shutil.copy(str(self.expected) + '.options', str(self.out) + '.options')
        self.assert_refused([self.part, 'mode = history, not replay'], '--mode', 'replay')
        other = self.path('other.jsonl')
        other.write_text('\n'.join(lines_of(self.requests)[:-1]) + '\n')
        self.assert_refused([self.part, 'requests = '], requests=other)
        config = self.path('config')
        config.mkdir()
        (config / 'believability.yaml').write_text('believability: {before_contact: 1.0}\n')
        self.assert_refused([self.part, 'config/believability.yaml'], '--config', config)
        self.assertEqual(self.part.read_bytes(), begun)
        self.assert_goes_on(4)

    def test_methods_that_need_non_commercial_weights_name_the_key_that_switches_them_off(self):
        config = self.path('config')
        config.mkdir()
        (config / 'models.yaml').write_text('models: {non_commercial_weights: false}\n')
        for method in ('network', 'c_mid'):
            self.assert_refused([method, 'models.non_commercial_weights'], '--method', method, '--config', config)

    def test_malformed_lists_are_refused_before_anything_is_written(self):
        good = json.loads(lines_of(self.requests)[0])
        for change, named in ((dict(type='drift'), 'field type = "drift"'), (dict(scene='scene-0099'), 'scene-0099'),
                              (dict(tta='soon'), 'field tta = "soon"'), (dict(stray=1), 'field stray = 1')):
            requests = self.path('bad.jsonl')
            requests.write_text('{}\n{}\n'.format(json.dumps(good), json.dumps(dict(good, **change))))
            self.assert_refused([str(requests) + ': line 2', named], requests=requests)
        requests.write_text(json.dumps(good)[:-3])
        self.assert_refused([str(requests) + ': line 1: invalid JSON'], requests=requests)
        self.assert_refused([self.path('none')], requests=self.path('none'))
        self.assertFalse(self.part.exists())
        self.assertFalse(self.out.exists())


class CollideFormatTest(road.RoadTest):
    """generate --format csv-collide: a folder with the scenarios and one clip per attack."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.requests = cls.folder / 'requests.jsonl'
        result = make_requests(cls.requests, '--scene', 'scene-0001', 'scene-0007', '--stride', 3, '--tta', 2, 4)
        assert result.returncode == 0, result.stderr
        cls.expected = cls.folder / 'expected'
        cls.result = run(cls.command(cls.expected, '--jobs', 1))
        assert cls.result.returncode == 0, cls.result.stderr
        cls.scenarios = [json.loads(line) for line in lines_of(cls.expected / 'scenarios.jsonl')]
        cls.clips = sorted(path.name for path in cls.clips_of(cls.expected).iterdir())

    @classmethod
    def command(cls, out, *arguments):
        return generate_command(cls.requests, out, '--format', 'csv-collide', '--mode', 'replay', *arguments)

    @staticmethod
    def clips_of(out):
        return out / 'trajectory' / 'val'

    def setUp(self):
        self.out = self.path('out')

    def copy(self):
        shutil.copytree(str(self.expected), str(self.out))

    def assert_like_expected(self, out):
        files = {path.relative_to(out): path.read_bytes() for path in out.rglob('*') if path.is_file()}
        expected = {path.relative_to(self.expected): path.read_bytes()
                    for path in self.expected.rglob('*') if path.is_file()}
        self.assertEqual(sorted(files), sorted(expected))
        self.assertEqual(files, expected)

    def test_scenarios_are_those_of_the_other_format(self):
        result = run(generate_command(self.requests, self.out, '--mode', 'replay', '--format', 'jsonl'))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.out.read_bytes(), (self.expected / 'scenarios.jsonl').read_bytes())

    def test_every_attack_has_a_clip_or_is_counted(self):
        attacks = sum(scenario['status']['code'] == 'OK' for scenario in self.scenarios)
        without, of, reasons = re.search(r'^(\d+) of (\d+) attacks have no clip of .*: (.*)$', self.result.stderr,
                                         re.MULTILINE).groups()
        self.assertEqual(int(of), attacks)
        self.assertGreater(len(self.clips), 0)
        self.assertEqual(len(self.clips), attacks - int(without))
        self.assertIn('{} clips in {}'.format(len(self.clips), self.clips_of(self.expected)), self.result.stdout)
        self.assertEqual(sum(int(reason.split()[0]) for reason in reasons.split(', ')), int(without))

    def test_clips_can_be_evaluated(self):
        result = road.run('study', 'evaluate', '--collide', self.expected, '--dataroot', DATAROOT, '--split', 'val',
                          '--protocol', 'published', '--mode', 'replay', '--out', self.out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('{} clips'.format(len(self.clips)), result.stdout)
        with (self.out / 'results.csv').open() as file:
            rows = [row for row in csv.DictReader(file) if row['method'] == 'recorded']
        self.assertEqual(len(rows), len(self.clips))
        self.assertGreater(sum(row['collision'] == '1' for row in rows), len(rows) / 2)

    def test_clips_of_something_else_are_not_taken_for_this_runs(self):
        self.copy()
        (self.out / 'scenarios.jsonl').unlink()
        result = run(self.command(self.out))
        self.assertEqual(result.returncode, 1)
        self.assertIn('{}: contains clips of another run'.format(self.clips_of(self.out)), result.stderr)
        self.assertFalse((self.out / 'scenarios.jsonl.part').exists())


if __name__ == '__main__':
    road.main()
