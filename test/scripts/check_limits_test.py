#!/usr/bin/python3
"""scripts/check_limits: violations that it must find in a scenario file, and valid motions that it must accept."""
import json
import math
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from kinematic_drive import CONTACT, LENGTHS, Drive, scenario

PACKAGE = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(PACKAGE / 'scripts'))
from scenario_files import CONFIG, VehicleLimits  # noqa: E402

ROWS = {'car': 'car', 'truck': 'truck', 'bus': 'bus', 'construction_vehicle': 'construction',
        'emergency_vehicle': 'van', 'motorcycle': 'motorcycle'}  # of the lengths that drives have here


class CheckLimits(unittest.TestCase):
    SUMMARY = 3  # lines after the counts

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.file = self.folder / 'scenarios.jsonl'

    def run_on(self, text, *arguments):
        self.file.write_text(text)
        return subprocess.run([str(PACKAGE / 'scripts' / 'check_limits'), str(self.file)] +
                              list(arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                              check=False)

    def check(self, *scenarios):
        return self.run_on(''.join(json.dumps(line) + '\n' for line in scenarios))

    def broken(self, *scenarios):
        """Return the limits that are reported as violated for trajectories of one class."""
        result = self.check(*scenarios)
        lines = result.stdout.splitlines()
        names = [line.split(' seed 7: ')[1].rsplit(' ', 6)[0] for line in lines[:-1 - self.SUMMARY]]
        self.assertEqual(lines[-1 - self.SUMMARY], '{0} trajectories of {0} requests, {1} violations'.format(
            len(scenarios), len(names)), result.stderr)
        self.assertEqual(result.returncode, 1 if names else 0, result.stderr)
        return names


class Vehicle:
    """A class with its limits and wheelbase."""

    def __init__(self, agent_class):
        self.agent_class = agent_class
        self.limits = VehicleLimits(CONFIG).drivable[ROWS[agent_class]]
        self.wheelbase = self.limits['wheelbase_share'] * LENGTHS[agent_class]

    def __getattr__(self, name):
        return self.limits[name]

    def drive(self, *arguments, **options):
        return scenario(Drive(self.wheelbase, *arguments, **options).points(), self.agent_class)

    def steering(self, speed, lateral):
        """Return the steering angle with this lateral acceleration."""
        return math.atan(self.wheelbase * lateral / speed**2)






def vehicles():
    return [Vehicle(agent_class) for agent_class in ROWS]


def moved(line, **changes):
    """The same with other fields at one `index`, or at all."""
    points = line['attacker']['trajectory']
    index = changes.pop('index', None)
    for i, point in enumerate(points):
        for key, change in changes.items():
            if index in (None, i):
                point[key] += change(i) if callable(change) else change
    return line


def random_knots(draw, between, greatest_slope, low, high):
    """Through random values that often are the lowest or highest, often as steep as may be, until after the end."""
    time, value = 0.0, draw.uniform(low, high)
    knots = [(time, value)]
    while time < 4.5:
        target = draw.choice([low, high, draw.uniform(low, high)])
        rise = max(draw.choice([0.0, draw.uniform(*between)]), abs(target - value) / greatest_slope, between[0])
        rise = math.ceil(20.0 * rise) / 20.0
        time, value = time + rise, target
        knots.append((time, value))
        if draw.random() < 0.5:
            time += math.ceil(20.0 * draw.uniform(*between)) / 20.0
            knots.append((time, value))
    return knots


def random_drive(draw, vehicle):
    """Return a random drive within all limits, often at one of them."""
    fastest = draw.uniform(3.0, vehicle.max_speed)
    share = draw.uniform(0.0, 0.99)  # of braking; the rest of the friction circle is available for turning
    radius = max(vehicle.max_braking, vehicle.max_lateral_acceleration)
    lateral = min(vehicle.max_lateral_acceleration, radius * math.sqrt(1.0 - share**2))
    forward = min(share * radius, vehicle.max_forward_acceleration * min(1.0, vehicle.switching_speed / fastest))
    angle = min(vehicle.max_steering_angle, vehicle.steering(fastest, lateral))
    for _ in range(100):
        acceleration = random_knots(draw, (0.2, 1.0), vehicle.max_jerk, -share * vehicle.max_braking, forward)
        drive = Drive(vehicle.wheelbase, draw.uniform(0.0, fastest), acceleration,
                      random_knots(draw, (0.2, 1.0), vehicle.max_steering_rate, -angle, angle))
        points = drive.points()
        stands = [point['v'] == 0.0 for point in points]
        if max(point['v'] for point in points) <= fastest and not any(
                before and not after for before, after in zip(stands, stands[1:])):
            return scenario(points, vehicle.agent_class)
    return vehicle.drive(0.0)


class DrivableLimits(CheckLimits):

    def test_random_drives_within_all_limits_pass(self):
        draw = random.Random(1)
        for vehicle in vehicles():
            self.assertEqual(self.broken(*(random_drive(draw, vehicle) for _ in range(40))), [])

    def test_one_spoilt_number_is_found(self):
        def spoilt(**change):
            knots = [(0.0, 1.0), (0.5, -1.0), (4.0, 1.0)], [(0.0, -0.1), (2.0, 0.1), (4.0, 0.0)]
            return moved(Vehicle('car').drive(10.0, *knots), index=10, **change)
        self.assertEqual(self.broken(spoilt(v=0.04, a=0.05, kappa=0.001)), [])
        for name, line in (('max_total_acceleration', spoilt(x=0.1)), ('max_braking', spoilt(x=0.1)),
                           ('max_forward_acceleration', spoilt(t=0.01)), ('max_speed', spoilt(x=-3.0)),
                           ('no_reversing', spoilt(x=1.3)), ('slip', spoilt(yaw=0.03)), ('max_jerk', spoilt(x=0.02)),
                           ('max_steering_rate', spoilt(yaw=0.02)), ('max_steering_angle', spoilt(yaw=0.3)),
                           ('v', spoilt(v=0.07)), ('a', spoilt(a=0.35)), ('kappa', spoilt(kappa=0.015)),
                           ('written max_speed', spoilt(v=27.0)), ('written no_reversing', spoilt(v=-12.0)),
                           ('written max_forward_acceleration', spoilt(a=5.1)),
                           ('written max_braking', spoilt(a=-8.1)),
                           ('written max_lateral_acceleration', spoilt(kappa=0.08)),
                           ('written max_total_acceleration', spoilt(kappa=0.09)),
                           ('written max_steering_angle', spoilt(kappa=-0.3))):
            self.assertIn(name, self.broken(line), name)

    def test_what_comes_after_contact_does_not_matter(self):
        contact = round(10.0 * CONTACT)
        self.assertEqual(self.broken(moved(Vehicle('car').drive(10.0), index=contact + 3, x=0.5)), [])
        self.assertIn('max_speed', self.broken(moved(Vehicle('car').drive(10.0), index=contact, x=-3.0)))

    def test_class_and_length_choose_the_limits(self):
        limits = VehicleLimits(CONFIG)
        for agent_class, length, row in (('car', 5.6, 'car'), ('car', 5.61, 'van'), ('truck', 6.29, 'van'),
                                         ('truck', 6.3, 'truck'), ('truck', 13.0, 'truck'),
                                         ('truck', 13.01, 'articulated'), ('bus', 18.0, 'bus'),
                                         ('emergency_vehicle', 5.0, 'van'),
                                         ('construction_vehicle', 14.0, 'construction'),
                                         ('motorcycle', 2.0, 'motorcycle'), ('child', 0.5, 'child'),
                                         ('runner', 0.8, 'runner'), ('scooter', 1.28, 'scooter')):
            wheelbase = limits.drivable[row]['wheelbase_share'] * length
            greatest = limits.drivable[row]['max_speed']
            points = [Drive(wheelbase, greatest + more, 0.0, 0.001).points() for more in (-0.1, 0.1)]
            result = self.check(*(scenario(drive, agent_class, length) for drive in points))
            lines = result.stdout.splitlines()
            self.assertRegex(lines[0], r'line 2: .* max_speed .* > {:.4f}'.format(greatest))
            self.assertTrue(lines[-1].startswith(row + ' (2 trajectories): '), lines)

    def test_support_vehicles_are_checked(self):
        car = Vehicle('car')

        def with_support(role, points, x=0.0, y=50.0):
            line = car.drive(10.0)
            moved_points = [dict(point, x=point['x'] + x, y=point['y'] + y) for point in points]
            line['supports'] = [dict(line['attacker'], role=role, id=role + '-1', trajectory=moved_points)]
            return line

        driven = car.drive(10.0)['attacker']['trajectory']
        fast = car.drive(37.0)['attacker']['trajectory']
        stands = [dict(point, x=driven[0]['x'], y=driven[0]['y'], v=0.0, a=0.0, kappa=0.0) for point in driven]
        result = self.check(with_support('leader', driven), with_support('queue', stands))
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn('2 trajectories and 2 support vehicles of 2 requests, 0 violations', result.stdout)
        for line, named in ((with_support('leader', fast), 'leader leader-1: max_speed 37.0000 > 36.0000'),
                            (with_support('parked_vehicle', driven), 'parked_vehicle parked_vehicle-1: moves '),
                            (with_support('leader', driven, y=0.5), 'leader leader-1: touches the attacker ')):
            result = self.check(line)
            self.assertEqual(result.returncode, 1)
            self.assertIn(named, result.stdout)

    def test_a_class_without_limits_is_no_success(self):
        for agent_class, named in (('animal', 'no limits for the class "animal"'), (None, 'has no class')):
            result = self.check(dict(scenario(Drive(2.7, 5.0).points(), agent_class, 4.6)))
            self.assertEqual(result.returncode, 2)
            self.assertIn('line 1: ', result.stderr)
            self.assertIn(named, result.stderr)

    def test_lines_name_file_request_limit_and_value(self):
        car = Vehicle('car')
        result = self.check(car.drive(10.0), scenario(None), car.drive(37.0))
        self.assertEqual(result.returncode, 1)
        lines = result.stdout.splitlines()
        self.assertRegex(lines[0], r'^{}: line 3: scene-0001 now 100.500000 ltap tta 3 replay seed 7: '
                                   r'max_speed 37\.0000 > 36\.0000 at \d\.\d s$'.format(self.file))
        self.assertEqual(lines[2], '2 trajectories of 3 requests, 2 violations')

    def test_what_is_no_scenario_file_is_no_success(self):
        good = json.dumps(Vehicle('car').drive(10.0)) + '\n'
        for text, named in (('', 'no trajectory'), (json.dumps(scenario(None)) + '\n', 'no trajectory'),
                            (good + '{"scene": ', 'line 2: no scenario'),
                            (good.replace('scenario"', 'list"'), 'line 1'),
                            (good.replace('"v": 10.0', '"v": NaN'), 'NaN'), (good.replace('"x"', '"z"'), "'x'"),
                            (good.replace('"t": 0.1,', '"t": 0.0,'), 'malformed'),
                            (good.replace('"yaw": 3.0', '"yaw": 1e999'), 'malformed')):
            result = self.run_on(text)
            self.assertEqual(result.returncode, 2, text)
            self.assertIn(named, result.stderr)


if __name__ == '__main__':
    unittest.main()
