#!/usr/bin/python3
"""evaluate: synthetic clips, requests over embedded logs, resumption, and a second published-protocol implementation."""
import csv
import json
import shutil
import sys
from pathlib import Path

import road
from road import DATAROOT, VERSION

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / 'study' / 'evaluation'))
import collide_clips  # noqa: E402
import published_reference  # noqa: E402



def evaluate(collide, out, *arguments):
    return road.run('study', 'evaluate', '--collide', collide, '--dataroot', DATAROOT, '--split', 'val', '--out', out, *arguments)


def rows_of(out):
    with open(str(out / 'results.csv')) as file:
        return list(csv.DictReader(file))


class EvaluateTest(road.RoadTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.collide = cls.folder / 'collide'
        val = cls.collide / 'trajectory' / 'val'
        cls.clips = [collide_clips.write_embedded_clip(val, DATAROOT / VERSION, scene, first, last)
                     for scene, first, last in (('scene-0005', 12, 23), ('scene-0010', 14, 23))]

    def test_strict_run_on_two_embedded_clips(self):
        out = self.path('out')
        result = evaluate(self.collide, out, '--method', 'search', '--mode', 'replay', '--seeds', 2, '--jobs', 2)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = rows_of(out)
        self.assertEqual([(row['name'], row['method'], row['seed']) for row in rows],
                         [(clip.stem, method, seed) for clip in sorted(self.clips)
                          for method, seed in (('recorded', '0'), ('constant_velocity', '0'), ('nominal', '0'),
                                               ('search', '0'), ('search', '1'))])
        for row in rows:
            if row['method'] == 'recorded':
                self.assertEqual(row['angle_bands'] + row['full_definitions'], '11', row)
                self.assertLessEqual(abs(float(row['contact_after']) - float(row['tta'])), 0.5, row)
                self.assertLessEqual(abs(float(row['relative_heading'])), 10.0, row)
        self.assertEqual((out / 'table.md').read_text(), result.stdout)
        self.assertIn('| recorded |', result.stdout)
        self.assertIn('strict protocol, strict limits, replay mode', result.stdout)
        self.assertNotIn('road_allows', rows[0])
        self.assertIn('All conditions, full definitions, %', result.stdout)
        self.assertFalse((out / 'results.csv.part').exists())

    def test_broken_clip_is_named_and_what_was_done_is_kept(self):
        collide, out = self.path('collide'), self.path('out')
        shutil.copytree(str(self.collide), str(collide))
        broken = sorted(collide.rglob('*.csv'))[1]
        broken.write_text(broken.read_text().replace('ego,', 'ego,x', 1))
        result = evaluate(collide, out)
        self.assertEqual(result.returncode, 1)
        self.assertIn(broken.name, result.stderr)
        self.assertIn('TIMESTAMP = "x', result.stderr)
        self.assertEqual(len((out / 'results.csv.part').read_text().splitlines()), 1 + 3)

    def test_limit_takes_the_first_clips(self):
        out = self.path('out')
        self.assertEqual(evaluate(self.collide, out, '--limit', 1).returncode, 0)
        self.assertEqual({row['name'] for row in rows_of(out)}, {min(self.clips).stem})

    def test_split_by_scene_has_every_clip_once(self):
        collide = self.path('collide')
        for split in ('train', 'val'):
            collide_clips.write_random_clips(collide / 'trajectory' / split, 88, 'embedded-right', split)
        found = {}
        for split in ('train', 'val'):
            out = self.path(split)
            result = road.run('study', 'evaluate', '--collide', collide, '--dataroot', DATAROOT, '--out', out, '--split', split,
                              '--by-scene', '--protocol', 'published')
            self.assertEqual(result.returncode, 0, result.stderr)
            found[split] = rows_of(out)
        self.assertEqual(sum(len(rows) for rows in found.values()), 3 * 176)
        self.assertFalse({row['scene'] for row in found['train']} & {row['scene'] for row in found['val']})

    def test_published_protocol_agrees_with_another_implementation(self):
        collide, out = self.path('collide'), self.path('out')
        clips = collide / 'trajectory' / 'val'
        collide_clips.write_random_clips(clips, 400, 'embedded-right', 1)
        result = evaluate(collide, out, '--protocol', 'published', '--jobs', 2)
        self.assertEqual(result.returncode, 0, result.stderr)
        differing, events = published_reference.compare(clips, out / 'results.csv')
        self.assertEqual(differing, 0)
        for event in ('hit', 'attacker', 'ego', 'none'):
            self.assertGreater(events.get(event, 0), 20, events)


class EvaluateRequestsTest(road.RoadTest):
    """Requests over the embedded logs."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.requests = cls.folder / 'requests.jsonl'
        result = road.run('requests', '--dataroot', DATAROOT, '--version', VERSION, '--out', cls.requests, '--scene',
                          'scene-0001', 'scene-0007', '--stride', 8, '--tta', 2, 4)
        assert result.returncode == 0, result.stderr
        cls.listed = [json.loads(line) for line in cls.requests.read_text().splitlines()]
        cls.expected = cls.folder / 'expected'
        cls.result = cls.run_on('--out', cls.expected)
        assert cls.result.returncode == 0, cls.result.stderr

    @classmethod
    def command(cls, *arguments):
        return ['--dataroot', DATAROOT, '--version', VERSION, '--requests', cls.requests, *arguments]

    @classmethod
    def run_on(cls, *arguments):
        return road.run('study', 'evaluate', *cls.command(*arguments))

    def assert_as_expected(self, out):
        names = sorted(path.name for path in self.expected.iterdir())
        self.assertEqual(sorted(path.name for path in out.iterdir()), names)
        for name in names:
            self.assertEqual((out / name).read_bytes(), (self.expected / name).read_bytes(), name)

    def test_every_request_has_its_rows_and_tables(self):
        methods = ['constant_velocity', 'nominal', 'search', 'replay']
        rows = rows_of(self.expected)
        self.assertEqual([(row['name'], row['scene'], row['type'], float(row['tta']), row['method']) for row in rows],
                         [(str(line), request['scene'], request['type'], request['tta'], method)
                          for line, request in enumerate(self.listed, 1) for method in methods])
        for row in rows:
            if row['method'] == 'replay' and row['status'] == 'OK':
                self.assertEqual((row['full_definitions'], row['road_allows'], row['believable']), ('1', '1', '1'), row)
                self.assertIn(row['class'], ('car', 'truck', 'bus'), row)
        table = (self.expected / 'table.md').read_text()
        for title in ('strict protocol, drivable limits, plausible, history mode', 'All conditions, full definitions, %',
                      'All conditions, full definitions, recall against replay mode',
                      'All conditions, full definitions, requests allowed by the road, %', 'Allowed by the road, %',
                      '| search, solved although the road does not allow it |',
                      'Calibration, full definitions, %',
                      'Largest difference: '):
            self.assertIn(title, table)
        self.assertNotIn('angle bands', table)

    def test_other_limits_and_any_driving(self):
        out = self.path('out')
        arguments = ['--out', out, '--scene', 'scene-0007', '--mode', 'replay', '--limits', 'strict', '--believable', 'false']
        result = self.run_on(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('strict protocol, strict limits, replay mode', result.stdout)
        for row in rows_of(out):
            if row['method'] == 'search' and row['status'] == 'OK':
                self.assertEqual(row['full_definitions'], '1', row)
        arguments[arguments.index('strict')] = 'drivable'
        result = self.run_on(*arguments)
        self.assertEqual(result.returncode, 1)
        self.assertIn('limits = strict, not drivable', result.stderr)

    def test_milliseconds_are_printed_and_in_no_file(self):
        table = (self.expected / 'table.md').read_text()
        self.assertEqual(self.result.stdout[:len(table)], table)
        times = self.result.stdout[len(table):].strip().splitlines()
        self.assertEqual(len(times), 2)
        for line in times:
            self.assertRegex(line, r'^(search|replay): mean [0-9.]+ ms on one core, median [0-9.]+ ms, '
                                   r'95 % quantile [0-9.]+ ms \({} measurements in this process\)$'.format(len(self.listed)))
        self.assertNotIn(' ms', table)

    def test_threads_do_not_change_a_byte(self):
        result = self.run_on('--out', self.path('threads'), '--jobs', 2)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_as_expected(self.path('threads'))

    def test_interrupted_run_is_resumed(self):
        out = self.path('out')
        shutil.copytree(str(self.expected), str(out))
        lines = (out / 'results.csv').read_bytes().splitlines(keepends=True)
        (out / 'results.csv').unlink()
        road.leave_part(out / 'results.csv', b''.join(lines[:1 + 4 * 10 + 2]), header=True, lines_per_item=4)
        result = self.run_on('--out', out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('({} measurements in this process)'.format(len(self.listed) - 10), result.stdout)
        self.assert_as_expected(out)
        for arguments, named in ((['--mode', 'replay'], 'mode = history'), (['--seeds', 2], 'seeds = 1'),
                                 (['--scene', 'scene-0007'], 'requests = ')):
            result = self.run_on('--out', out, *arguments)
            self.assertEqual(result.returncode, 1)
            self.assertIn(named, result.stderr)
        self.assert_as_expected(out)


if __name__ == '__main__':
    road.main()
