"""Checks of the limits of the protocol "strict", at the middle of the box; part of check_limits."""
import math

from limit_checks import BACKWARDS, ROUNDING, Worst, turn
from scenario_files import steps_to_contact

# Tolerances of finite differences over samples 0.1 s apart. A second difference is a mean of the acceleration over its
# two steps, and a turn over a distance is a mean of the curvature. Neither exceeds a limit that is kept at every
# instant, except because the heading turns within the steps and because the chord is shorter than the arc.
ACCELERATION_ERROR = 0.05    # m/s2
CURVATURE_ERROR = 0.001      # 1/m
SLIP = 0.02                  # rad between a step and the heading halfway
# Tolerances of written values against the range of the differences around them. v has a sudden change of acceleration
# within a step at once, the differences have its mean, so v is outside their range by a quarter of change times step.
WRITTEN_SPEED = 0.33         # m/s between v and a step's speed; 13 m/s2 from full braking to full throttle
WRITTEN_ACCELERATION = 0.1   # m/s2 between a and a second difference
WRITTEN_CURVATURE = 0.002    # 1/m between kappa and a turn over a step
# Near curvature_min_speed, the speed of a step does not determine which of the two rules for turning applies.
SURELY_FAST = 1.1            # times curvature_min_speed
SURELY_SLOW = 0.85


class Step:
    """The motion of the middle of the box from one sample to the next."""

    def __init__(self, a, b):
        self.a, self.b = a, b
        self.duration = b['t'] - a['t']
        dx, dy = b['x'] - a['x'], b['y'] - a['y']
        self.length = math.hypot(dx, dy)
        self.speed = self.length / self.duration
        self.velocity = (dx / self.duration, dy / self.duration)
        self.forward = dx * math.cos(a['yaw']) + dy * math.sin(a['yaw'])
        self.turn = turn(a['yaw'], b['yaw'])
        self.slip = abs(turn(a['yaw'] + 0.5 * self.turn, math.atan2(dy, dx)))


def check_steps(steps, limits, worst):
    for step in steps:
        time = step.a['t']
        worst.check('max_speed', step.speed, limits['max_speed'], time)
        worst.check('no_reversing', -step.forward, 0.0, time, BACKWARDS + ROUNDING)
        if step.speed >= SURELY_FAST * limits['curvature_min_speed']:
            curvature = abs(step.turn) / step.length
            worst.check('max_curvature', curvature, limits['max_curvature'], time, CURVATURE_ERROR)
            worst.check('slip', step.slip, 0.0, time, SLIP)


def acceleration(before, after):
    """Return the acceleration along the heading at the sample between two steps, and the total one, m/s2."""
    between = 0.5 * (before.duration + after.duration)
    x, y = ((v - u) / between for u, v in zip(before.velocity, after.velocity))
    yaw = after.a['yaw']
    return x * math.cos(yaw) + y * math.sin(yaw), math.hypot(x, y)


def check_accelerations(steps, limits, worst):
    for before, after in zip(steps, steps[1:]):
        time = after.a['t']
        along, total = acceleration(before, after)
        worst.check('max_forward_acceleration', along, limits['max_forward_acceleration'], time, ACCELERATION_ERROR)
        worst.check('max_braking', -along, limits['max_braking'], time, ACCELERATION_ERROR)
        worst.check('max_total_acceleration', total, limits['max_total_acceleration'], time, ACCELERATION_ERROR)


def check_slow_turns(steps, limits, worst):
    """Compare headings in slow steps with the heading at the start of the slow stretch."""
    begin, driven = steps[0].a['yaw'], 0.0
    for step in steps:
        if step.speed >= SURELY_FAST * limits['curvature_min_speed']:
            begin, driven = step.a['yaw'], 0.0
        driven += step.length
        if step.speed <= SURELY_SLOW * limits['curvature_min_speed']:
            allowed = limits['heading_slack'] + limits['heading_per_metre'] * driven
            worst.check('heading_slack', abs(turn(begin, step.b['yaw'])), allowed, step.a['t'])


def check_written(points, limits, worst):
    for point in points:
        v, a, kappa = point['v'], point['a'], point['kappa']
        worst.check('written max_speed', v, limits['max_speed'], point['t'])
        worst.check('written no_reversing', -v, 0.0, point['t'])
        worst.check('written max_forward_acceleration', a, limits['max_forward_acceleration'], point['t'])
        worst.check('written max_braking', -a, limits['max_braking'], point['t'])
        total = math.hypot(a, v * v * kappa)
        worst.check('written max_total_acceleration', total, limits['max_total_acceleration'], point['t'])
        if v >= limits['curvature_min_speed']:
            worst.check('written max_curvature', abs(kappa), limits['max_curvature'], point['t'])


def outside(value, around):
    """Return the distance of a value from the range of the values `around`; 0 inside."""
    return max(min(around) - value, value - max(around), 0.0)


def check_agreement(steps, count, limits, worst):
    """Compare the values written at the points of the first `count` steps with the differences around them."""
    along = [acceleration(before, after)[0] for before, after in zip(steps, steps[1:])]
    for i, (before, after) in enumerate(zip(steps[:count], steps[1:])):
        point = after.a
        around = along[i - 1:i + 2]
        if len(around) == 3:
            # The means hide a step between two harder or two gentler ones; the written speeds show it.
            around += [(step.b['v'] - step.a['v']) / step.duration for step in (before, after)]
            vary = max(around[:3]) - min(around[:3])  # a step's own acceleration may be this far outside the means
            worst.check('a', outside(point['a'], around), vary, point['t'], WRITTEN_ACCELERATION)
        speeds = [math.copysign(step.speed, step.forward) for step in (before, after)]
        worst.check('v', outside(point['v'], speeds), 0.0, point['t'], WRITTEN_SPEED)
        if min(before.speed, after.speed) >= SURELY_FAST * limits['curvature_min_speed']:
            curvatures = [step.turn / step.length for step in (before, after)]
            worst.check('kappa', outside(point['kappa'], curvatures), 0.0, point['t'], WRITTEN_CURVATURE)


def fastest_steering(steps, limits):
    """Return the fastest change of curvature between fast steps, 1/(m s)."""
    slow = SURELY_FAST * limits['curvature_min_speed']
    return max((abs(after.turn / after.length - before.turn / before.length) /
                (0.5 * (before.duration + after.duration))
                for before, after in zip(steps, steps[1:]) if min(before.speed, after.speed) >= slow), default=0.0)


def judge(scenario, limits):
    """Return (violations, fastest change of curvature) of the attacker from t0 to contact."""
    points = scenario['attacker']['trajectory']
    all_steps = [Step(a, b) for a, b in zip(points, points[1:])]
    count = steps_to_contact(scenario)
    steps = all_steps[:count]
    worst = Worst()
    check_steps(steps, limits, worst)
    check_accelerations(steps, limits, worst)
    check_slow_turns(steps, limits, worst)
    check_written(points[:count + 1], limits, worst)
    check_agreement(all_steps, count, limits, worst)
    return worst.violations(), fastest_steering(steps, limits)
