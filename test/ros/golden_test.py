#!/usr/bin/python3
"""forge inject gives the reviewed figures in golden.json for the embedded data.

After an intended change: test/ros/golden_test.py --regenerate (with the package's environment sourced)."""
import json
import math
import sys
import tempfile
from pathlib import Path

import road

FILE = Path(__file__).with_name('golden.json')
TIME_TOLERANCE = 0.05                 # s; the effect of different rounding on an attack
HEADING_TOLERANCE = math.radians(2.0)
REQUEST = ('scene', 'now', 'collision_type', 'tta', 'mode', 'seed')


def answer(request, folder):
    """Return the code and, if OK, attacker, contact time (s from t0) and relative heading."""
    bag, out = folder / (request['scene'] + '.bag'), folder / 'golden_out.bag'
    result = road.inject(bag, out, request['collision_type'], request['tta'], request['now'], '--mode', request['mode'],
                         '--seed', request['seed'])
    code = road.code_of(result)
    if code != 'OK':
        return {'code': code}
    report = road.read_one(out, '/attack').report
    return {'code': code, 'attacker_id': report.attacker_id,
            'contact_after': round((report.contact_time - report.header.stamp).to_sec(), 3),
            'relative_heading': round(report.relative_heading, 4)}


def read_golden():
    return json.loads(FILE.read_text())


class GoldenTest(road.RoadTest):
    SCENES = sorted({entry['scene'] for entry in read_golden()})

    def check(self, entry):
        actual = answer(entry, self.folder)
        self.assertEqual(actual['code'], entry['code'])
        if entry['code'] != 'OK':
            return
        self.assertEqual(actual['attacker_id'], entry['attacker_id'])
        self.assertLessEqual(abs(actual['contact_after'] - entry['contact_after']), TIME_TOLERANCE)
        self.assertLessEqual(abs(road.angle_between(actual['relative_heading'], entry['relative_heading'])),
                             HEADING_TOLERANCE)
        self.assertLessEqual(abs(actual['contact_after'] - entry['tta']), 0.5, 'golden is what was asked for')


def add_tests():
    for entry in read_golden():
        name = 'test_' + '_'.join(str(entry[field]).replace('-', '_').replace('.', '_') for field in REQUEST)
        assert not hasattr(GoldenTest, name), name + ' is there twice'
        setattr(GoldenTest, name, lambda self, entry=entry: self.check(entry))


def regenerate():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        result = road.convert(folder)
        assert result.returncode == 0, result.stderr
        rows = [dict({field: entry[field] for field in REQUEST}, **answer(entry, folder)) for entry in read_golden()]
    FILE.write_text('[\n' + ',\n'.join('  ' + json.dumps(row) for row in rows) + '\n]\n')


if __name__ == '__main__':
    if '--regenerate' in sys.argv:
        regenerate()
    else:
        add_tests()
        road.main()
