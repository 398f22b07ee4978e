"""Checks of the drivable limits by class, at the rear axle of a kinematic single track; part of check_limits."""
import math

from scenario_files import steps_to_contact

BACKWARDS = 1e-3  # m that a step may lead back, as in the package's own check
ROUNDING = 1e-6   # of any unit

# Tolerances of differences over samples 0.1 s apart. A second difference of paths or positions is a mean of the
# acceleration over its two steps and a third one a mean of the jerk, so neither exceeds a limit that is kept at every
# instant, except for the error of an arc whose steering angle changes within the step.
SPEED_ERROR = 1e-3           # m/s; rounding
ACCELERATION_ERROR = 0.05    # m/s2; includes the error of the forward limit, taken at a mean speed
JERK_ERROR = 0.2             # m/s3; for fast changes of the steering
SLIP = 0.1                   # m/s across the heading, 10 mm per step; slip_limit() allows more if steering explains it
SLIP_SPREAD = 1.05           # factor by which speed and steering angle exceed their means within such a step
# A step gives the mean steering angle over its distance. If its speed changes, that is not the mean over its time.
SHORT_STEP = 0.05            # m; shorter steps give no steering angle
STEERING_ERROR = 1e-3        # rad; rounding
STEERING_RATE_ERROR = 0.05   # share of max_steering_rate
SHORT_TURN = 2e-3            # rad by which the turn in a short step may exceed the turn at max_steering_angle
# Tolerances of values written at a sample against means over the steps around it. check_agreement() adds the difference
# between these means, for an acceleration that changes at the sample, and half of the largest change of the steering
# angle in a step, for a steering angle that reverses there.
WRITTEN_SPEED = 0.05         # m/s
WRITTEN_ACCELERATION = 0.2   # m/s2
WRITTEN_STEERING = 1e-3      # rad


class Worst:
    """The worst violation of each limit."""

    def __init__(self):
        self.found = {}

    def check(self, name, value, limit, time, tolerance=ROUNDING):
        """Record a violation if `value` exceeds `limit` by more than `tolerance` (rounding of the differences)."""
        excess = value - limit - tolerance
        if excess > 0.0 and excess > self.found.get(name, (0.0,))[0]:
            self.found[name] = (excess, value, limit, time)

    def violations(self):
        """Return (limit, value, allowed value, s from t0) of each violated limit."""
        return [(name, value, limit, time) for name, (_, value, limit, time) in sorted(self.found.items())]


def turn(start, end):
    return math.remainder(end - start, 2.0 * math.pi)


class Step:
    """The motion of the axle that does not steer from one sample to the next, as an arc.

    `ahead`: m from this axle to the middle of the box, in the direction of travel."""

    def __init__(self, a, b, wheelbase, ahead):
        self.a, self.b = a, b
        self.duration = b['t'] - a['t']
        self.turn = turn(a['yaw'], b['yaw'])
        half = 0.5 * self.turn
        heading = a['yaw'] + half
        # Displacement of the middle of the box, less the part from its rotation around the axle.
        dx = b['x'] - a['x'] - ahead * (math.cos(b['yaw']) - math.cos(a['yaw']))
        dy = b['y'] - a['y'] - ahead * (math.sin(b['yaw']) - math.sin(a['yaw']))
        self.velocity = (dx / self.duration, dy / self.duration)
        self.slip = abs(dy * math.cos(heading) - dx * math.sin(heading)) / self.duration
        self.way = (dx * math.cos(heading) + dy * math.sin(heading)) * (half / math.sin(half) if half else 1.0)
        self.speed = self.way / self.duration
        self.yaw_rate = self.turn / self.duration
        self.steering = math.atan(wheelbase * self.turn / self.way) if self.way >= SHORT_STEP else None
        self.middle = 0.5 * (a['t'] + b['t'])


def between(before, after):
    """Return the time from the middle of one step to the middle of another, s."""
    return after.middle - before.middle


def accelerations_of(steps):
    """Return the accelerations along the path at the end of every step but the last, m/s2."""
    return [(after.speed - before.speed) / between(before, after) for before, after in zip(steps, steps[1:])]


def forward_limit(limits, speed):
    return limits['max_forward_acceleration'] * min(1.0, limits['switching_speed'] / max(speed, ROUNDING))


def slip_limit(step, limits, wheelbase):
    """Return the largest allowed speed across the heading in a step, m/s.

    A steering angle that changes throughout a step moves its middle sideways, at 25 m/s by as much as SLIP, but by no
    more than an instantaneous change from full left to full right."""
    bend = limits['max_steering_rate'] / wheelbase * (1.0 + (wheelbase * step.turn / max(step.way, SHORT_STEP))**2)
    steered = bend * (step.speed * step.duration)**2 / 12.0 * SLIP_SPREAD
    return max(SLIP, min(steered, 0.25 * limits['max_lateral_acceleration'] * step.duration))


def total_limit(limits):
    return max(limits['max_braking'], limits['max_lateral_acceleration'])


def turned_round(point):
    """Return a point of a vehicle that reverses, in its direction of travel."""
    return dict(point, yaw=point['yaw'] + math.pi, v=-point['v'], a=-point['a'], kappa=-point['kappa'])


class Attacker:
    """An attacker from t0 to contact: its limits, its steps and the worst violation of each limit."""

    def __init__(self, scenario, limits):
        attacker = scenario['attacker']
        self.limits = limits
        self.wheelbase = limits['wheelbase_share'] * attacker['length']
        self.points = attacker['trajectory']
        ahead = 0.5 * self.wheelbase
        if scenario.get('report', {}).get('manoeuvre') == 'back_out':
            self.points = [turned_round(point) for point in self.points]
            ahead = -ahead
            self.limits = dict(limits, max_speed=limits['max_reverse_speed'])
        self.all_steps = [Step(a, b, self.wheelbase, ahead) for a, b in zip(self.points, self.points[1:])]
        self.count = steps_to_contact(scenario)
        self.steps = self.all_steps[:self.count]
        self.worst = Worst()

    def check_steps(self):
        limits, check = self.limits, self.worst.check
        for step in self.steps:
            time = step.a['t']
            check('max_speed', step.speed, limits['max_speed'], time, SPEED_ERROR)
            check('no_reversing', -step.way, 0.0, time, BACKWARDS + ROUNDING)
            check('slip', step.slip, slip_limit(step, limits, self.wheelbase), time)
            if step.steering is None:
                allowed = max(step.way, 0.0) * math.tan(limits['max_steering_angle']) / self.wheelbase
                check('slow_turn', abs(step.turn), allowed, time, SHORT_TURN)
            else:
                check('max_steering_angle', abs(step.steering), limits['max_steering_angle'], time, STEERING_ERROR)
        for step in self.steps:
            check('max_lateral_acceleration', abs(step.speed * step.yaw_rate), limits['max_lateral_acceleration'],
                  step.a['t'], ACCELERATION_ERROR)

    def check_accelerations(self):
        limits, check = self.limits, self.worst.check
        for before, after, along in zip(self.steps, self.steps[1:], accelerations_of(self.steps)):
            time = after.a['t']
            total = math.hypot(*(v - u for u, v in zip(before.velocity, after.velocity))) / between(before, after)
            speed = 0.5 * (before.speed + after.speed)
            check('max_forward_acceleration', along, forward_limit(limits, speed), time, ACCELERATION_ERROR)
            check('max_braking', -along, limits['max_braking'], time, ACCELERATION_ERROR)
            check('max_total_acceleration', total, total_limit(limits), time, ACCELERATION_ERROR)

    def steering_rates(self):
        """Return (rad/s, s from t0) between successive steps with a steering angle; skips steps without one."""
        steered = [step for step in self.steps if step.steering is not None]
        return [((after.steering - before.steering) / between(before, after), before.b['t'])
                for before, after in zip(steered, steered[1:])]

    def jerks(self):
        """Return (m/s3, s from t0) of the jerks, except of stops at a standstill, where braking ends abruptly."""
        accelerations = accelerations_of(self.steps)
        last_speed = 0.5 * self.limits['max_braking']  # times the duration: mean speed of a step that ends at 0
        found = []
        for step, last, a, b in zip(self.steps[1:], self.steps[2:], accelerations, accelerations[1:]):
            stops = a < 0.0 and a < b and last.speed <= last_speed * last.duration
            if not stops:
                found.append(((b - a) / step.duration, step.a['t']))
        return found

    def check_changes(self):
        for rate, time in self.steering_rates():
            self.worst.check('max_steering_rate', abs(rate), self.limits['max_steering_rate'], time,
                             STEERING_RATE_ERROR * self.limits['max_steering_rate'])
        for jerk, time in self.jerks():
            self.worst.check('max_jerk', abs(jerk), self.limits['max_jerk'], time, JERK_ERROR)

    def check_written(self):
        limits, check = self.limits, self.worst.check
        for point in self.points[:self.count + 1]:
            time, v, a, kappa = point['t'], point['v'], point['a'], point['kappa']
            steering, lateral = math.atan(self.wheelbase * kappa), v * v * kappa
            check('written max_speed', v, limits['max_speed'], time)
            check('written no_reversing', -v, 0.0, time)
            check('written max_forward_acceleration', a, forward_limit(limits, v), time)
            check('written max_braking', -a, limits['max_braking'], time)
            check('written max_steering_angle', abs(steering), limits['max_steering_angle'], time)
            check('written max_lateral_acceleration', abs(lateral), limits['max_lateral_acceleration'], time)
            check('written max_total_acceleration', math.hypot(a, lateral), total_limit(limits), time)

    def check_agreement(self):
        """Compare the values written at the samples with the means over the steps around them."""
        along = accelerations_of(self.all_steps)
        for i, (before, after) in enumerate(zip(self.all_steps[:self.count], self.all_steps[1:])):
            point, near = after.a, along[max(i - 1, 0):i + 2]
            # Doubled at the first sample, whose preceding step is missing, and for short steps, which may hide a stop.
            apart = (max(near) - min(near)) * (1.0 if i > 0 and after.way >= SHORT_STEP else 2.0)
            self.worst.check('v', abs(point['v'] - 0.5 * (before.speed + after.speed)), 0.25 * apart * after.duration,
                             point['t'], WRITTEN_SPEED)
            if i > 0 and before.way >= SHORT_STEP:
                self.worst.check('a', abs(point['a'] - along[i]), apart, point['t'], WRITTEN_ACCELERATION)
            if before.steering is not None and after.steering is not None:
                off = abs(math.atan(self.wheelbase * point['kappa']) - 0.5 * (before.steering + after.steering))
                turned = 0.5 * self.limits['max_steering_rate'] * after.duration
                self.worst.check('kappa', off, turned, point['t'], WRITTEN_STEERING)

    def extremes(self):
        """Return the fastest steering, rad/s, the greatest jerk, m/s3, and the greatest lateral acceleration, m/s2."""
        return (max((abs(rate) for rate, _ in self.steering_rates()), default=0.0),
                max((abs(jerk) for jerk, _ in self.jerks()), default=0.0),
                max((abs(step.speed * step.yaw_rate) for step in self.steps), default=0.0))


def judge(scenario, limits):
    """Return (violations, extremes) of the attacker from t0 to contact."""
    attacker = Attacker(scenario, limits)
    attacker.check_steps()
    attacker.check_accelerations()
    attacker.check_changes()
    attacker.check_written()
    attacker.check_agreement()
    return attacker.worst.violations(), attacker.extremes()
