#!/usr/bin/python3
"""What scripts/check_limits must find in a scenario file, and what it must let pass."""
import json
import math
import subprocess
import tempfile
import unittest
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent.parent.parent
CONTACT = 3.0  # s from now


def arc(speed, acceleration=0.0, curvature=0.0, slip=0.0):
    """A constant acceleration on a circle, exactly, for a second longer than to contact."""
    points = []
    for i in range(round(10.0 * (CONTACT + 1.0)) + 1):
        t = 0.1 * i
        way = speed * t + 0.5 * acceleration * t * t
        yaw = curvature * way
        chord = way if curvature == 0.0 else 2.0 / curvature * math.sin(0.5 * yaw)
        points.append({'t': round(t, 6), 'x': 600.0 + chord * math.cos(0.5 * yaw), 'y': 1600.0 + chord * math.sin(0.5 * yaw),
                       'yaw': math.remainder(yaw + slip, 2.0 * math.pi), 'v': speed + acceleration * t,
                       'a': acceleration, 'kappa': curvature})
    return points


def scenario(points):
    return {'format': 'collision_forge/scenario', 'version': 2, 'scene': 'scene-0001', 'now': 100.5,
            'request': {'type': 'ltap', 'tta': 3, 'attacker': None, 'mode': 'replay', 'seed': 7},
            'attacker': points and {'id': 'a', 'trajectory': points}, 'report': points and {'contact_t': CONTACT}}


def spoilt(key, index, change):
    """A good drive with one number changed."""
    points = arc(10.0, 1.0, 0.02)
    points[index][key] += change
    return points


class CheckLimits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.file = self.folder / 'scenarios.jsonl'

    def run_on(self, text, *arguments):
        self.file.write_text(text)
        return subprocess.run([str(PACKAGE / 'scripts' / 'check_limits'), str(self.file)] + list(arguments),
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)

    def check(self, *trajectories):
        return self.run_on(''.join(json.dumps(scenario(points)) + '\n' for points in trajectories))

    def broken(self, points):
        """The names of the limits that a trajectory is said to break."""
        result = self.check(points)
        lines = result.stdout.splitlines()
        names = [line.split(' seed 7: ')[1].rsplit(' ', 6)[0] for line in lines[:-2]]
        self.assertEqual(lines[-2], '1 trajectories of 1 requests, {} violations'.format(len(names)))
        self.assertEqual(result.returncode, 1 if names else 0, result.stderr)
        return names

    def test_drives_near_every_limit_pass(self):
        for points in (arc(24.99), arc(5.0, 4.99), arc(24.9, -7.99), arc(10.0, 0.0, 0.0799), arc(5.0, 0.0, -0.1999),
                       arc(1.0, 0.0, 0.3), arc(0.0), arc(0.0, 3.0), spoilt('x', 10, 0.0)):
            self.assertEqual(self.broken(points), [], points[1])

    def test_drives_beyond_a_limit_are_found(self):
        for name, points in (('max_speed', arc(25.01)), ('max_forward_acceleration', arc(5.0, 5.06)),
                             ('max_braking', arc(24.9, -8.06)), ('max_total_acceleration', arc(10.0, 0.0, 0.081)),
                             ('max_curvature', arc(5.0, 0.0, -0.202)), ('slip', arc(5.0, slip=0.021)),
                             ('no_reversing', arc(-0.5)), ('heading_slack', arc(1.0, 0.0, 0.4))):
            self.assertIn(name, self.broken(points))

    def test_the_fastest_steering_is_told(self):
        def told(points):
            return self.check(points).stdout.splitlines()[-1]
        self.assertEqual(told(arc(10.0, 0.0, 0.05)),
                         'fastest change of curvature, 1/(m s): 50 % 0.00, 90 % 0.00, 99 % 0.00')
        points = arc(10.0)
        points[11]['yaw'] += 0.02  # a turn of 0.02 on the metre before, of -0.02 on the one after
        self.assertEqual(told(points), 'fastest change of curvature, 1/(m s): 50 % 0.40, 90 % 0.40, 99 % 0.40')
        self.assertIn('50 % 0.00', told([dict(point, yaw=0.01 * (i % 2)) for i, point in enumerate(arc(1.0))]), 'slow')

    def test_one_spoilt_number_is_found(self):
        for name, points in (('max_total_acceleration', spoilt('x', 10, 0.1)), ('max_braking', spoilt('y', 10, 1.0)),
                             ('max_forward_acceleration', spoilt('t', 10, 0.01)), ('max_speed', spoilt('x', 10, 2.0)),
                             ('no_reversing', spoilt('x', 10, -1.2)), ('slip', spoilt('yaw', 10, 0.05)),
                             ('max_curvature', spoilt('yaw', 10, 0.25)), ('v', spoilt('v', 10, 0.4)),
                             ('a', spoilt('a', 10, 0.15)), ('kappa', spoilt('kappa', 10, 0.003)),
                             ('written max_speed', spoilt('v', 10, 14.5)), ('written no_reversing', spoilt('v', 10, -12.0)),
                             ('written max_forward_acceleration', spoilt('a', 10, 4.1)),
                             ('written max_braking', spoilt('a', 10, -9.1)),
                             ('written max_total_acceleration', spoilt('kappa', 10, 0.06)),
                             ('written max_curvature', spoilt('kappa', 10, -0.23))):
            self.assertIn(name, self.broken(points))

    def test_what_comes_after_contact_does_not_matter(self):
        contact = round(10.0 * CONTACT)
        self.assertEqual(self.broken(spoilt('x', contact + 1, 0.5)), [])
        self.assertIn('max_speed', self.broken(spoilt('x', contact, 2.0)))

    def test_lines_name_file_request_limit_and_value(self):
        result = self.check(arc(10.0), None, arc(26.0))
        self.assertEqual(result.returncode, 1)
        lines = result.stdout.splitlines()
        self.assertRegex(lines[0], r'^{}: line 3: scene-0001 now 100.500000 ltap tta 3 replay seed 7: '
                                   r'max_speed 26\.0000 > 25\.0000 at \d\.\d s$'.format(self.file))
        self.assertEqual(lines[-2], '2 trajectories of 3 requests, 2 violations')

    def test_limits_are_those_of_the_configuration(self):
        text = (PACKAGE / 'config' / 'vehicle_limits.yaml').read_text()
        config = self.folder / 'config'
        config.mkdir()
        limits = config / 'vehicle_limits.yaml'
        line = json.dumps(scenario(arc(20.0))) + '\n'
        limits.write_text(text.replace('max_speed: 25.0', 'max_speed: 19.0'))
        self.assertIn('max_speed 20.0000 > 19.0000', self.run_on(line, '--config', str(config)).stdout)
        for changed, named in ((text.replace('max_speed', 'max_pace'), 'max_speed is missing'),
                               (text.replace('25.0', 'fast'), 'max_speed = "fast" is no number')):
            limits.write_text(changed)
            result = self.run_on(line, '--config', str(config))
            self.assertEqual(result.returncode, 2)
            self.assertIn(named, result.stderr)

    def test_what_is_no_scenario_file_is_no_success(self):
        good = json.dumps(scenario(arc(10.0))) + '\n'
        for text, named in (('', 'no trajectory'), (json.dumps(scenario(None)) + '\n', 'no trajectory'),
                            (good + '{"scene": ', 'line 2: no scenario'), (good.replace('scenario"', 'list"'), 'line 1'),
                            (good.replace('"v": 10.0', '"v": NaN'), 'NaN'), (good.replace('"x"', '"z"'), "'x'"),
                            (good.replace('"t": 0.1,', '"t": 0.0,'), 'malformed')):
            result = self.run_on(text)
            self.assertEqual(result.returncode, 2, text)
            self.assertIn(named, result.stderr)


if __name__ == '__main__':
    unittest.main()
