"""Drives of a kinematic single track, as the attackers of scenario files: what scripts that judge them must let pass or
find."""
import math

CONTACT = 3.0      # s from now
SUBSTEPS = 20      # of 0.1 s
LENGTHS = {'car': 4.6, 'truck': 9.0, 'bus': 12.0, 'construction_vehicle': 7.0, 'emergency_vehicle': 6.0,
           'motorcycle': 2.1}


def at(knots, time):
    """Piecewise linear through (time, value), constant outside."""
    if time <= knots[0][0]:
        return knots[0][1]
    for (t0, v0), (t1, v1) in zip(knots, knots[1:]):
        if time <= t1:
            return v0 + (v1 - v0) * (time - t0) / (t1 - t0)
    return knots[-1][1]


class Drive:
    """Of a vehicle of this wheelbase (m): speed now, then knots of acceleration and steering angle over time. It stops
    where it would reverse. `slip`: m/s of the rear axle to the left."""

    def __init__(self, wheelbase, speed, acceleration=0.0, steering=0.0, slip=0.0, yaw=3.0):
        self.wheelbase, self.slip = wheelbase, slip
        self.acceleration, self.steering = (
            knots if isinstance(knots, list) else [(0.0, knots)] for knots in (acceleration, steering))
        self.rear = [600.0, 1600.0]
        self.yaw, self.v, self.standing = yaw, speed, False

    def advance(self, time, duration):
        """The acceleration is linear within a substep, and so is nearly the turning: Simpson's rule."""
        a, b = (at(self.acceleration, t) for t in (time, time + duration))
        speeds = [max(self.v, 0.0), max(self.v + duration * (3.0 * a + b) / 8.0, 0.0),
                  max(self.v + 0.5 * duration * (a + b), 0.0)]
        k0, k1, k2 = (v * math.tan(at(self.steering, time + share * duration)) / self.wheelbase
                      for v, share in zip(speeds, (0.0, 0.5, 1.0)))
        yaws = [self.yaw, self.yaw + duration * (5.0 * k0 + 8.0 * k1 - k2) / 24.0,
                self.yaw + duration * (k0 + 4.0 * k1 + k2) / 6.0]
        for weight, v, yaw in zip((1.0, 4.0, 1.0), speeds, yaws):
            self.rear[0] += duration * weight / 6.0 * (v * math.cos(yaw) - self.slip * math.sin(yaw))
            self.rear[1] += duration * weight / 6.0 * (v * math.sin(yaw) + self.slip * math.cos(yaw))
        self.yaw, self.v = yaws[2], speeds[2]
        self.standing = self.v == 0.0 and b <= 0.0

    def point(self, time):
        half = 0.5 * self.wheelbase
        return {'t': round(time, 6), 'x': self.rear[0] + half * math.cos(self.yaw),
                'y': self.rear[1] + half * math.sin(self.yaw), 'yaw': math.remainder(self.yaw, 2.0 * math.pi),
                'v': self.v, 'a': 0.0 if self.standing else at(self.acceleration, time),
                'kappa': math.tan(at(self.steering, time)) / self.wheelbase}

    def points(self, duration=CONTACT + 1.0, step=0.1):
        """Every `step` for a second longer than to contact."""
        points = [self.point(0.0)]
        for i in range(round(duration / step)):
            for j in range(SUBSTEPS):
                self.advance(step * (i + j / SUBSTEPS), step / SUBSTEPS)
            points.append(self.point(step * (i + 1)))
        return points


def scenario(points, agent_class='car', length=None):
    """A line of a scenario file, without attacker for no points."""
    attacker = {'id': 'a', 'class': agent_class, 'length': length or LENGTHS[agent_class], 'width': 2.0,
                'trajectory': points}
    return {'format': 'collision_forge/scenario', 'version': 6, 'scene': 'scene-0001', 'now': 100.5,
            'request': {'type': 'ltap', 'tta': 3, 'attacker': None, 'mode': 'replay', 'seed': 7},
            'attacker': points and attacker, 'report': points and {'contact_t': CONTACT}}
