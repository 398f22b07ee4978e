#!/usr/bin/python3
"""forge export: attacks over embedded logs, resumption, and errors for invalid input."""
import json

import road
from road import DATAROOT, VERSION

LOGS = ('--dataroot', DATAROOT, '--version', VERSION)
FORMATS = ('openscenario', 'commonroad', 'scenarionet', 'openlabel')


def lines_of(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


class ExportTest(road.RoadTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        requests, cls.scenarios = cls.folder / 'requests.jsonl', cls.folder / 'scenarios.jsonl'
        for words in (('requests', *LOGS, '--out', requests, '--scene', 'scene-0001', 'scene-0007', '--stride', 6,
                       '--tta', 2, 4),
                      ('generate', *LOGS, '--requests', requests, '--mode', 'history', '--out', cls.scenarios)):
            result = road.run(*words)
            assert result.returncode == 0, result.stderr
        cls.attacks = [number for number, line in enumerate(lines_of(cls.scenarios), start=1)
                       if line['status']['code'] == 'OK']

    def words(self, out, form='openscenario', *more, scenarios=None):
        return ('export', '--to', form, '--scenarios', scenarios or self.scenarios, *LOGS, '--out', out, *more)

    def export(self, *arguments, **named):
        return road.run(*self.words(*arguments, **named))

    @staticmethod
    def files_in(out):
        return {str(path.relative_to(out)): path.read_bytes() for path in out.rglob('*') if path.is_file()}

    def test_every_format_has_every_attack(self):
        self.assertGreater(len(self.attacks), 3)
        for form in FORMATS:
            out = self.path(form)
            result = self.export(out, form)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn('{} attacks of '.format(len(self.attacks)), result.stdout)
            index = lines_of(out / 'index.jsonl')
            self.assertEqual([entry['line'] for entry in index], self.attacks)
            for entry in index:
                self.assertEqual(entry['name'], '{}_{}'.format(entry['scene'], entry['line']))
                for file in entry['files']:
                    self.assertGreater((out / file).stat().st_size, 1000)

    def test_contact_equals_the_attack_if_the_future_is_known(self):
        requests, scenarios, out = (self.path(name) for name in ('requests.jsonl', 'scenarios.jsonl', 'out'))
        requests.write_text((self.folder / 'requests.jsonl').read_text())
        self.assertEqual(road.run('generate', *LOGS, '--requests', requests, '--mode', 'replay', '--out',
                                  scenarios).returncode, 0)
        self.assertEqual(self.export(out, scenarios=scenarios).returncode, 0)
        answers, index = lines_of(scenarios), lines_of(out / 'index.jsonl')
        self.assertGreater(len(index), 3)
        for entry in index:
            self.assertAlmostEqual(entry['contact_t'] - entry['now_t'],
                                   answers[entry['line'] - 1]['report']['contact_t'], delta=2e-3)
            self.assertLessEqual(entry['now_t'], 2.0)

    def test_a_bag_with_an_attack_is_exported_too(self):
        self.assertEqual(road.convert(self.path('bags'), '--scene', 'scene-0001').returncode, 0)
        recorded, attacked = self.path('bags') / 'scene-0001.bag', self.path('cut.in.bag')
        result = road.inject(recorded, attacked, 'lane_change', 4, 4, '--mode', 'replay')
        self.assertEqual(result.returncode, 0, result.stderr)
        for form in FORMATS:
            out = self.path(form)
            result = road.run('export', '--to', form, '--bag', attacked, '--out', out)
            self.assertEqual(result.returncode, 0, result.stderr)
            entry, = lines_of(out / 'index.jsonl')
            self.assertEqual((entry['name'], entry['location']), (attacked.stem + '_1', 'embedded-right'))
            self.assertAlmostEqual(entry['contact_t'] - entry['now_t'], 4.0, delta=0.3)
        out = self.path('out')
        result = road.run('export', '--to', 'openscenario', '--bag', attacked, recorded, '--out', out)
        self.assertEqual(result.returncode, 1)
        self.assertIn(str(recorded) + ': no attack', result.stderr)
        self.assertFalse((out / 'index.jsonl').exists())

    def test_another_format_does_not_resume(self):
        out = self.path('out')
        self.assertEqual(self.export(out).returncode, 0)
        before = self.files_in(out)
        for words in (('commonroad',), ('openscenario', '--ego', 'free')):
            result = self.export(out, *words)
            self.assertEqual(result.returncode, 1)
            self.assertIn('was made with', result.stderr)
        self.assertEqual(self.files_in(out), before)

    def test_bad_lines_are_reported(self):
        line = json.loads(self.scenarios.read_text().splitlines()[self.attacks[0] - 1])
        for change, told in (({'scene': '../evil'}, '../evil'), ({'scene': 'scene-9999'}, 'scene-9999'),
                             ({'format': 'x'}, 'format')):
            out, scenarios = self.path('out'), self.path('bad.jsonl')
            scenarios.write_text(json.dumps(dict(line, **change)) + '\n')
            result = self.export(out, scenarios=scenarios)
            self.assertEqual(result.returncode, 1)
            self.assertIn(told, result.stderr)
            self.assertFalse((out / 'index.jsonl').exists())
        self.assertFalse((self.folder / 'evil').exists())


if __name__ == '__main__':
    road.main()
