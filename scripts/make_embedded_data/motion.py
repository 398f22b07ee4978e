"""Derives the motion of a body from SUMO's front points.

SUMO moves a vehicle's front point along lane centrelines. Here the front axle
follows that (slightly smoothed) path and the rear axle is drawn behind it at
the wheelbase without slipping sideways, as in a real car. So heading is
continuous and the rear axle always moves along the heading.
"""
import math
from dataclasses import dataclass

from plane import cumulative_lengths, direction, point_at, shifted, wrap_angle
from simulation import STEP
from traffic import KINDS, PEDESTRIAN

SMOOTHING = 0.2          # standard deviation in seconds
PULL_STEP = 0.1          # metres the front axle moves in one integration step
WALKING_SPEED = 0.3      # below this a pedestrian keeps facing the same way


@dataclass
class Motion:
    """The rear axle poses (x, y, yaw) of a body on consecutive steps; for pedestrians, the centres."""
    name: str
    kind: str
    first_step: int
    rear_axles: list
    speeds: list

    def body(self):
        return KINDS[self.kind]

    def covers(self, first, last):
        return self.first_step <= first and last < self.first_step + len(self.rear_axles)

    def has(self, step):
        return self.covers(step, step)

    def rear_axle(self, step):
        return self.rear_axles[step - self.first_step]

    def speed(self, step):
        return self.speeds[step - self.first_step]

    def box(self, step):
        """Return the oriented box (x, y, yaw, length, width)."""
        x, y, yaw = self.rear_axle(step)
        body = self.body()
        ahead = body.length / 2.0 - body.rear_overhang if body.wheelbase else 0.0
        centre = shifted((x, y), yaw, ahead)
        return (*centre, yaw, body.length, body.width)


def smoothed(points):
    """Return the points, smoothed in time by a Gaussian that narrows towards both ends."""
    reach = round(3.0 * SMOOTHING / STEP)
    weights = [math.exp(-0.5 * (k * STEP / SMOOTHING) ** 2) for k in range(reach + 1)]
    result = []
    for i in range(len(points)):
        width = min(reach, i, len(points) - 1 - i)
        near = range(-width, width + 1)
        total = sum(weights[abs(k)] for k in near)
        result.append(tuple(sum(weights[abs(k)] * points[i + k][axis] for k in near) / total
                            for axis in (0, 1)))
    return result


def front_axle_path(track, body):
    """Return the front axle on every step: a front overhang behind, on the front point's path."""
    overhang = body.length - body.rear_overhang - body.wheelbase
    path = smoothed(track.points)
    path.insert(0, shifted(path[0], track.yaws[0], -overhang))
    lengths = cumulative_lengths(path)
    return [point_at(path, lengths, s - overhang) for s in lengths[1:]]


def pulled(rear_yaw, front, target, wheelbase):
    """Return the yaw after the front axle moved to a target and the rear axle rolled behind it."""
    count = max(math.ceil(math.dist(front, target) / PULL_STEP), 1)
    step = math.dist(front, target) / count
    course = direction(front, target)
    for _ in range(count):
        steer = wrap_angle(course - rear_yaw)
        middle = rear_yaw + step / 2.0 * math.sin(steer) / wheelbase
        rear_yaw += step * math.sin(wrap_angle(course - middle)) / wheelbase
    return rear_yaw


def vehicle_motion(track):
    body = KINDS[track.kind]
    path = front_axle_path(track, body)
    yaw = track.yaws[0]
    poses = []
    for previous, point in zip([path[0], *path], path):
        if math.dist(previous, point) > 1e-6:
            yaw = pulled(yaw, previous, point, body.wheelbase)
        poses.append((*shifted(point, yaw, -body.wheelbase), wrap_angle(yaw)))
    return Motion(track.name, track.kind, track.first_step, poses, track.speeds)


def pedestrian_motion(track):
    path = smoothed(track.points)
    yaw = track.yaws[0]
    poses = []
    for i, point in enumerate(path):
        before, after = path[max(i - 2, 0)], path[min(i + 2, len(path) - 1)]
        if math.dist(before, after) > WALKING_SPEED * 4.0 * STEP:
            yaw = direction(before, after)
        poses.append((*point, yaw))
    return Motion(track.name, track.kind, track.first_step, poses, track.speeds)


def motion_of(track):
    """Return the motion of the body of one raw track."""
    return pedestrian_motion(track) if track.kind == PEDESTRIAN else vehicle_motion(track)


def parked_motion(name, kind, pose, first_step, steps):
    """Return the motion of a stationary body; `pose` is the centre of its box."""
    body = KINDS[kind]
    rear = shifted(pose[:2], pose[2], body.rear_overhang - body.length / 2.0)
    return Motion(name, kind, first_step, [(*rear, pose[2])] * steps, [0.0] * steps)


@dataclass(frozen=True)
class DriveFigures:
    """The largest absolute values of a drive, in rad/s, m/s2 and rad."""
    yaw_rate: float
    lateral_acceleration: float
    acceleration: float
    slip: float


def drive_figures(poses, period):
    """Return the largest values of a motion, derived from its rear axle poses."""
    rates, laterals, slips, moved = [0.0], [0.0], [0.0], []
    for a, b in zip(poses, poses[1:]):
        v = math.dist(a[:2], b[:2]) / period
        rate = abs(wrap_angle(b[2] - a[2])) / period
        moved.append(v)
        rates.append(rate)
        laterals.append(v * rate)
        if v > 2.0:
            middle = a[2] + wrap_angle(b[2] - a[2]) / 2.0
            slips.append(abs(wrap_angle(direction(a, b) - middle)))
    jumps = [abs(b - a) / period for a, b in zip(moved, moved[1:])]
    return DriveFigures(max(rates), max(laterals), max(jumps, default=0.0), max(slips))


def speed_error(poses, speeds, period):
    """Return the largest difference between speeds from poses and SUMO's speeds, m/s.

    In a step, SUMO moves a vehicle with the speed that it reports at the step's end.
    """
    return max((abs(math.dist(a[:2], b[:2]) / period - speed)
                for a, b, speed in zip(poses, poses[1:], speeds[1:])), default=0.0)
