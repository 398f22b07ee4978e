#!/usr/bin/python3
"""scripts/soak: its counts, its pass criterion, and equal requests for equal seeds."""
import importlib.machinery
import importlib.util
import sys
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parent.parent.parent / 'scripts'
sys.path.insert(0, str(SCRIPTS))
from soak_requests import Requests  # noqa: E402

LOADER = importlib.machinery.SourceFileLoader('soak', str(SCRIPTS / 'soak'))
soak = importlib.util.module_from_spec(importlib.util.spec_from_loader('soak', LOADER))
LOADER.exec_module(soak)


def counts_of(*calls, megabytes=()):
    counts = soak.Counts()
    for call in calls:
        counts.add(*call)
    counts.megabytes.extend(megabytes)
    return counts


def requests_of(seed):
    requests = Requests(seed, lambda: None, lambda: None)
    return [(name, repr(request)) for name, request in (requests.draw() for _ in range(300))]


class SoakTest(unittest.TestCase):
    def test_what_must_not_be_is_not_good(self):
        for call in (('predict_pattern', 0.1, None), ('predict_pattern', 0.1, soak.NODE_UNAVAILABLE),
                     ('predict_pattern', 2.5, soak.OK)):
            self.assertFalse(counts_of(call).is_good(), call)
        crashed = counts_of()
        crashed.crashes += 1
        self.assertFalse(crashed.is_good())

    def test_memory_counts_after_the_first_tenth(self):
        steady, rising = [100.0] + 19 * [200.0], [100.0 + step for step in range(20)]
        self.assertTrue(counts_of(megabytes=steady).is_good())
        self.assertFalse(counts_of(megabytes=steady[:-2] + [200.0 + soak.MAX_GROWTH] * 2).is_good())
        self.assertAlmostEqual(counts_of(megabytes=rising).growth(), 16.0)

    def test_a_seed_gives_the_same_requests_of_all_services(self):
        self.assertEqual(requests_of(3), requests_of(3))
        self.assertNotEqual(requests_of(3), requests_of(4))
        self.assertEqual({name for name, _ in requests_of(3)}, set(soak.SERVICES))


if __name__ == '__main__':
    unittest.main()
