#!/usr/bin/python3
"""What scripts/check_limits must find in a scenario file, and what it must let pass."""
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
        'emergency_vehicle': 'emergency', 'motorcycle': 'motorcycle'}  # of the lengths that drives have here


class CheckLimits(unittest.TestCase):
    LIMITS = 'drivable'
    SUMMARY = 3  # lines after the counts

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.file = self.folder / 'scenarios.jsonl'

    def run_on(self, text, *arguments):
        self.file.write_text(text)
        return subprocess.run([str(PACKAGE / 'scripts' / 'check_limits'), '--limits', self.LIMITS, str(self.file)] +
                              list(arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                              check=False)

    def check(self, *scenarios):
        return self.run_on(''.join(json.dumps(line) + '\n' for line in scenarios))

    def broken(self, *scenarios):
        """The names of the limits that trajectories of one class are said to break."""
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
        """The angle at which that is the lateral acceleration."""
        return math.atan(self.wheelbase * lateral / speed**2)

    def full_throttle(self, share):
        """That share of what is allowed at every speed, from half the switching speed on."""
        speed, time, knots = 0.5 * self.switching_speed, 0.0, []
        while time < 4.5:
            now = share * self.max_forward_acceleration * min(1.0, self.switching_speed / speed)
            knots.append((time, now))
            speed, time = speed + 0.05 * now, time + 0.05
        return self.drive(0.5 * self.switching_speed, knots)

    def brake(self, braking, jerk, steering=0.0):
        """For half a second, from the sample 1 s from now on."""
        rise = braking / jerk
        knots = [(1.0, 0.0), (1.0 + rise, -braking), (1.5 + rise, -braking), (1.5 + 2.0 * rise, 0.0)]
        return self.drive(0.9 * self.max_speed, knots, steering)

    def swing(self, rate):
        return self.drive(5.0, 0.0, [(1.0, -0.14), (1.0 + 0.28 / rate, 0.14)])

    def turn_by(self, speed, lateral):
        return self.drive(speed, 0.0, self.steering(speed, lateral))


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


def spun(line, wheelbase, turn):
    """The same, but turned about the rear axle by that much more at every sample."""
    for i, point in enumerate(line['attacker']['trajectory']):
        for key, function in (('x', math.cos), ('y', math.sin)):
            point[key] += 0.5 * wheelbase * (function(point['yaw'] + turn * i) - function(point['yaw']))
        point['yaw'] += turn * i
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
    """Within all limits, often at one."""
    fastest = draw.uniform(3.0, vehicle.max_speed)
    share = draw.uniform(0.0, 0.99)  # of braking; what is left of the friction circle is for turning
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
    def expect(self, name, within, beyond):
        """A drive within a limit breaks none, the one beyond it breaks it."""
        self.assertEqual(self.broken(within), [], name)
        self.assertIn(name, self.broken(beyond))

    def test_random_drives_within_all_limits_pass(self):
        draw = random.Random(1)
        for vehicle in vehicles():
            self.assertEqual(self.broken(*(random_drive(draw, vehicle) for _ in range(40))), [])

    def test_speed(self):
        for vehicle in vehicles():
            self.expect('max_speed', vehicle.drive(vehicle.max_speed), vehicle.drive(vehicle.max_speed + 0.01))

    def test_forward_acceleration_and_its_fall(self):
        for vehicle in vehicles():
            self.expect('max_forward_acceleration', vehicle.full_throttle(0.99), vehicle.full_throttle(1.06))
        car = Vehicle('car')
        self.expect('max_forward_acceleration', car.drive(16.0, [(0.0, 0.0), (0.2, 2.4), (0.3, 2.2), (0.4, 0.0)]),
                    car.drive(16.0, [(0.0, 0.0), (0.2, 3.0), (0.5, 3.0), (0.7, 0.0)]))

    def test_braking(self):
        for vehicle in vehicles():
            self.expect('max_braking', vehicle.brake(vehicle.max_braking, vehicle.max_jerk),
                        vehicle.brake(vehicle.max_braking + 0.06, vehicle.max_jerk))

    def test_lateral_acceleration(self):
        for vehicle in vehicles():
            for speed in (7.0, 0.9 * vehicle.max_speed):
                self.expect('max_lateral_acceleration', vehicle.turn_by(speed, vehicle.max_lateral_acceleration),
                            vehicle.turn_by(speed, -vehicle.max_lateral_acceleration - 0.06))

    def test_total_acceleration(self):
        for vehicle in vehicles():
            steering = vehicle.steering(0.9 * vehicle.max_speed, 0.9 * vehicle.max_lateral_acceleration)
            self.expect('max_total_acceleration', vehicle.brake(0.4 * vehicle.max_braking, vehicle.max_jerk, steering),
                        vehicle.brake(vehicle.max_braking, vehicle.max_jerk, steering))

    def test_steering_angle(self):
        for vehicle in vehicles():
            for side in (1.0, -1.0):
                self.expect('max_steering_angle', vehicle.drive(1.5, 0.0, side * vehicle.max_steering_angle),
                            vehicle.drive(1.5, 0.0, side * (vehicle.max_steering_angle + 0.002)))

    def test_steering_rate(self):
        for vehicle in vehicles():
            self.expect('max_steering_rate', vehicle.swing(vehicle.max_steering_rate),
                        vehicle.swing(1.08 * vehicle.max_steering_rate))

    def test_steering_while_it_stands_for_a_moment(self):
        car = Vehicle('car')
        acceleration = [(0.0, -4.0), (0.55, -4.0), (0.8, 0.0), (0.9, 0.0), (1.1, 4.0)]
        self.expect('max_steering_rate', car.drive(2.0, acceleration, [(0.4, 0.2), (1.2, -0.1)]),
                    car.drive(2.0, acceleration, [(0.5, 0.2), (1.1, -0.5)]))

    def test_jerk(self):
        for vehicle in vehicles():
            self.expect('max_jerk', vehicle.brake(vehicle.max_braking, vehicle.max_jerk),
                        vehicle.brake(vehicle.max_braking, 1.03 * vehicle.max_jerk))

    def test_coming_to_a_standstill_has_no_jerk(self):
        for vehicle in vehicles():
            for time in range(10):
                line = vehicle.drive(vehicle.max_braking * (1.5 + 0.01 * time), -vehicle.max_braking)
                self.assertEqual(self.broken(line), [])
        car = Vehicle('car')
        self.assertIn('max_jerk', self.broken(car.drive(10.0, [(0.0, -8.0), (1.0, -8.0), (1.1, 0.0)])), 'released')
        self.assertIn('max_jerk', self.broken(car.drive(0.0, [(0.0, 0.0), (1.0, 0.0), (1.1, 5.0)])), 'pulls away')

    def test_slip(self):
        for vehicle in vehicles():
            for slip in (1.0, -1.0):
                self.expect('slip', vehicle.drive(5.0, slip=0.09 * slip), vehicle.drive(5.0, slip=0.11 * slip))
        # A vehicle of which another point rolls without slip: the middle of the box.
        points = Drive(Vehicle('car').wheelbase, 5.0, 0.0, 0.4).points()
        for point in points:
            point['x'] -= 0.5 * Vehicle('car').wheelbase * math.cos(point['yaw'])
            point['y'] -= 0.5 * Vehicle('car').wheelbase * math.sin(point['yaw'])
        self.assertIn('slip', self.broken(scenario(points)))

    def test_turning_while_hardly_moving(self):
        for vehicle in vehicles():
            self.expect('slow_turn', vehicle.drive(0.3, 0.0, vehicle.max_steering_angle),
                        spun(vehicle.drive(0.3, 0.0, vehicle.max_steering_angle), vehicle.wheelbase, 0.0025))
            self.expect('slow_turn', spun(vehicle.drive(0.0), vehicle.wheelbase, 0.0019),
                        spun(vehicle.drive(0.0), vehicle.wheelbase, 0.0021))

    def test_reversing(self):
        backwards = Vehicle('car').drive(0.5)
        self.assertIn('no_reversing', self.broken(moved(backwards, yaw=math.pi)))

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

    def test_kappa_is_that_of_the_rear_axle(self):
        line = Vehicle('bus').drive(3.0, 0.0, 0.64)
        turning = math.tan(0.64) / Vehicle('bus').wheelbase
        self.assertEqual(self.broken(line), [])
        middle = turning / math.hypot(1.0, 0.5 * math.tan(0.64))
        self.assertEqual(self.broken(moved(line, kappa=middle - turning)), ['kappa'])

    def test_what_comes_after_contact_does_not_matter(self):
        contact = round(10.0 * CONTACT)
        self.assertEqual(self.broken(moved(Vehicle('car').drive(10.0), index=contact + 3, x=0.5)), [])
        self.assertIn('max_speed', self.broken(moved(Vehicle('car').drive(10.0), index=contact, x=-3.0)))

    def test_class_and_length_choose_the_limits(self):
        limits = VehicleLimits(CONFIG)
        for agent_class, length, row in (('car', 5.6, 'car'), ('car', 5.61, 'van'), ('truck', 6.29, 'van'),
                                         ('truck', 6.3, 'truck'), ('truck', 13.0, 'truck'),
                                         ('truck', 13.01, 'articulated'), ('bus', 18.0, 'bus'),
                                         ('emergency_vehicle', 5.0, 'emergency'),
                                         ('construction_vehicle', 14.0, 'construction'),
                                         ('motorcycle', 2.0, 'motorcycle')):
            wheelbase = limits.drivable[row]['wheelbase_share'] * length
            greatest = limits.drivable[row]['max_speed']
            points = [Drive(wheelbase, greatest + more, 0.0, 0.001).points() for more in (-0.1, 0.1)]
            result = self.check(*(scenario(drive, agent_class, length) for drive in points))
            lines = result.stdout.splitlines()
            self.assertRegex(lines[0], r'line 2: .* max_speed .* > {:.4f}'.format(greatest))
            self.assertTrue(lines[-1].startswith(row + ' (2 trajectories): '), lines)

    def test_a_class_without_limits_is_no_success(self):
        for agent_class, named in (('bicycle', 'no limits for the class "bicycle"'), (None, 'has no class')):
            result = self.check(dict(scenario(Drive(2.7, 5.0).points(), agent_class, 4.6)))
            self.assertEqual(result.returncode, 2)
            self.assertIn('line 1: ', result.stderr)
            self.assertIn(named, result.stderr)

    def test_extremes_are_told_by_class(self):
        car = Vehicle('car')
        result = self.check(car.swing(0.3), Vehicle('bus').brake(5.0, 8.0), car.turn_by(10.0, 2.5), car.drive(1.0))
        lines = result.stdout.splitlines()
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertEqual([line.rsplit(': ', 1)[0] for line in lines[1:]],
                         ['{}: {}'.format(row, name) for row in ('bus (1 trajectories)', 'car (3 trajectories)')
                          for name in ('fastest steering, rad/s', 'greatest jerk, m/s3',
                                       'greatest lateral acceleration, m/s2')])
        self.assertIn('50 % 8.0, 90 % 8.0, 99 % 8.0', lines[2])
        self.assertIn('50 % 0.000, 90 % 0.300, 99 % 0.300', lines[4])
        self.assertIn('99 % 2.50', lines[6])

    def test_lines_name_file_request_limit_and_value(self):
        car = Vehicle('car')
        result = self.check(car.drive(10.0), scenario(None), car.drive(37.0))
        self.assertEqual(result.returncode, 1)
        lines = result.stdout.splitlines()
        self.assertRegex(lines[0], r'^{}: line 3: scene-0001 now 100.500000 ltap tta 3 replay seed 7: '
                                   r'max_speed 37\.0000 > 36\.0000 at \d\.\d s$'.format(self.file))
        self.assertEqual(lines[2], '2 trajectories of 3 requests, 2 violations')

    def test_limits_are_those_of_the_configuration(self):
        text = (CONFIG / 'vehicle_limits.yaml').read_text()
        config = self.folder / 'config'
        config.mkdir()
        limits = config / 'vehicle_limits.yaml'
        line = json.dumps(Vehicle('car').drive(20.0)) + '\n'
        limits.write_text(text.replace('max_speed: 36.0', 'max_speed: 19.0'))
        self.assertIn('max_speed 20.0000 > 19.0000', self.run_on(line, '--config', str(config)).stdout)
        for changed, named in ((text.replace('max_speed', 'max_pace'), 'max_speed is missing'),
                               (text.replace('36.0', 'fast'), 'max_speed = "fast" is no number'),
                               (text.replace('36.0', '-1.0'), 'car.max_speed is missing or not positive'),
                               (text.replace('    bus:', '    tram:'), 'bus is missing'),
                               (text.replace('truck: 13.0', ''), 'lengths.truck is missing'),
                               (text.replace('strict:', 'lax:'), 'strict is missing'), ('?\n', 'no key in "?"')):
            limits.write_text(changed)
            result = self.run_on(line, '--config', str(config))
            self.assertEqual(result.returncode, 2, named)
            self.assertIn(named, result.stderr)

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


def arc(speed, acceleration=0.0, curvature=0.0, slip=0.0):
    """A constant acceleration on a circle, exactly, for a second longer than to contact."""
    points = []
    for i in range(round(10.0 * (CONTACT + 1.0)) + 1):
        t = 0.1 * i
        way = speed * t + 0.5 * acceleration * t * t
        yaw = curvature * way
        chord = way if curvature == 0.0 else 2.0 / curvature * math.sin(0.5 * yaw)
        points.append({'t': round(t, 6), 'x': 600.0 + chord * math.cos(0.5 * yaw),
                       'y': 1600.0 + chord * math.sin(0.5 * yaw), 'yaw': math.remainder(yaw + slip, 2.0 * math.pi),
                       'v': speed + acceleration * t, 'a': acceleration, 'kappa': curvature})
    return points


def strict(points):
    """Without a class, as the strict limits need none."""
    line = scenario(points)
    del line['attacker']['class']
    return line


def spoilt(key, index, change):
    """A good drive with one number changed."""
    points = arc(10.0, 1.0, 0.02)
    points[index][key] += change
    return points


class StrictLimits(CheckLimits):
    LIMITS = 'strict'
    SUMMARY = 1

    def broken_by(self, points):
        return self.broken(strict(points))

    def test_drives_near_every_limit_pass(self):
        for points in (arc(24.99), arc(5.0, 4.99), arc(24.9, -7.99), arc(10.0, 0.0, 0.0799), arc(5.0, 0.0, -0.1999),
                       arc(1.0, 0.0, 0.3), arc(0.0), arc(0.0, 3.0), spoilt('x', 10, 0.0)):
            self.assertEqual(self.broken_by(points), [], points[1])

    def test_drives_beyond_a_limit_are_found(self):
        for name, points in (('max_speed', arc(25.01)), ('max_forward_acceleration', arc(5.0, 5.06)),
                             ('max_braking', arc(24.9, -8.06)), ('max_total_acceleration', arc(10.0, 0.0, 0.081)),
                             ('max_curvature', arc(5.0, 0.0, -0.202)), ('slip', arc(5.0, slip=0.021)),
                             ('no_reversing', arc(-0.5)), ('heading_slack', arc(1.0, 0.0, 0.4))):
            self.assertIn(name, self.broken_by(points))

    def test_the_fastest_steering_is_told(self):
        def told(points):
            return self.check(strict(points)).stdout.splitlines()[-1]
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
                             ('written max_speed', spoilt('v', 10, 14.5)),
                             ('written no_reversing', spoilt('v', 10, -12.0)),
                             ('written max_forward_acceleration', spoilt('a', 10, 4.1)),
                             ('written max_braking', spoilt('a', 10, -9.1)),
                             ('written max_total_acceleration', spoilt('kappa', 10, 0.06)),
                             ('written max_curvature', spoilt('kappa', 10, -0.23))):
            self.assertIn(name, self.broken_by(points))


if __name__ == '__main__':
    unittest.main()
