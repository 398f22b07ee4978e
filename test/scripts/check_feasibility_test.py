#!/usr/bin/python3
"""What scripts/check_feasibility must find. Where the checker is not installed, only what it says of that; run this
with the Python of an environment that has it (scripts/check_feasibility --help) for all."""
import importlib.util
import json
import os
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from check_limits_test import PACKAGE, Vehicle, moved, random_drive, vehicles

INSTALLED = importlib.util.find_spec('commonroad_dc') is not None


class FeasibilityTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / 'scenarios.jsonl'

    def check(self, scenarios, *arguments, **environment):
        self.file.write_text(''.join(json.dumps(line) + '\n' for line in scenarios))
        return subprocess.run([sys.executable, str(PACKAGE / 'scripts' / 'check_feasibility'), str(self.file)] +
                              [str(argument) for argument in arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, check=False, env=dict(os.environ, **environment))


class WithoutTheChecker(FeasibilityTest):
    def test_a_missing_checker_is_named(self):
        broken = self.file.parent / 'numpy.py'
        broken.write_text('raise ImportError("No module named numpy")\n')
        result = self.check([Vehicle('car').drive(5.0)], PYTHONPATH=str(self.file.parent))
        self.assertEqual(result.returncode, 2)
        self.assertIn('No module named numpy', result.stderr)
        self.assertIn('--help', result.stderr)
        told = self.check([], '--help')
        self.assertEqual(told.returncode, 0)
        self.assertIn('pip install commonroad-drivability-checker', told.stdout)


@unittest.skipUnless(INSTALLED, 'needs commonroad-drivability-checker')
class WithTheChecker(FeasibilityTest):
    def test_drives_of_all_classes_are_feasible(self):
        draw = random.Random(3)
        drives = [random_drive(draw, vehicle) for vehicle in vehicles() for _ in range(2)]
        result = self.check(drives)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertTrue(result.stdout.startswith('12 of 12 trajectories, 360 steps, '))
        self.assertIn('feasible bus: 1.0000 (2 of 2), by trajectory_feasibility() alone 1.0000\n', result.stdout)
        self.assertIn('\nfeasible: 1.0000 (12 of 12), ', result.stdout)

    def test_what_cannot_be_driven_is_not_feasible(self):
        car, bus = Vehicle('car'), Vehicle('bus')
        for what, line in (('is kinematically infeasible in the step at 0.0 s', car.drive(5.0, slip=0.3)),
                           ('is kinematically infeasible in the step at 0.0 s', car.turn_by(10.0, 8.5)),
                           ('is kinematically infeasible in the step at 1.9 s',
                            moved(car.drive(5.0), index=20, y=0.05)),
                           ('has an input out of bounds in the step at 1.0 s', car.swing(0.8)),
                           ('has an input out of bounds in the step at 1.0 s', bus.swing(0.8)),
                           ('has an input out of bounds in the step at 1.2 s', bus.brake(8.0, 40.0))):
            result = self.check([line])
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn(what, result.stdout)
            self.assertIn('\nfeasible: 0.0000 (0 of 1)', result.stdout)


if __name__ == '__main__':
    unittest.main()
