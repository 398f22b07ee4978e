#!/usr/bin/python3
"""What scripts/measure_sources must count."""
import importlib.machinery
import importlib.util
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / 'scripts' / 'measure_sources'


def load(path):
    loader = importlib.machinery.SourceFileLoader('measure_sources', str(path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def attack(x, contact_t):
    return {'status': {'code': 'OK'}, 'report': {'ego_at_contact': {'x': x, 'y': 0.0}, 'contact_t': contact_t}}


REFUSED = {'status': {'code': 'ROAD_DOES_NOT_ALLOW'}}


class MeasureSourcesTest(unittest.TestCase):
    def setUp(self):
        self.script = load(SCRIPT)

    def test_contacts_are_the_same_where_time_and_place_are(self):
        expected = [attack(1.0, 2.0)] * 4
        found = [attack(1.05, 2.05), attack(1.2, 2.0), attack(1.0, 2.2), attack(1.0, 2.0)]
        self.assertEqual(self.script.compare(expected, found), (4, 4, 2))

    def test_a_status_alone_is_no_attack(self):
        self.assertEqual(self.script.compare([REFUSED, REFUSED, attack(1.0, 2.0)],
                                             [REFUSED, attack(1.0, 2.0), REFUSED]), (1, 0, 0))


if __name__ == '__main__':
    unittest.main()
