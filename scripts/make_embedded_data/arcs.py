"""Fits arcline paths (nuScenes' arcline_path_3) to polylines.

A path is a list of primitives; each has three pieces, "L" (curvature +1/radius),
"S" (straight) or "R" (curvature -1/radius). Curves are fitted as biarcs, two
arcs that meet with one tangent, so that neighbours share position and heading
exactly at every joint.
"""
import math
from dataclasses import dataclass

from plane import cumulative_lengths, densified, direction, shifted, wrap_angle

POSITION_TOLERANCE = 0.03                # metres
HEADING_TOLERANCE = math.radians(0.8)
LONGEST_STEP = 4.0                       # metres between the points where a fit is compared
STRAIGHT_RADIUS = 100.0                  # radius of a primitive without an arc
LARGEST_RADIUS = 20000.0                 # flatter pieces are straight
CURVATURES = {"L": 1.0, "S": 0.0, "R": -1.0}


@dataclass(frozen=True)
class Piece:
    """A stretch of constant curvature: its start pose, curvature and length."""
    start: tuple
    curvature: float
    length: float

    def pose_at(self, s):
        return advance(self.start, self.curvature, s)

    def end(self):
        return self.pose_at(self.length)


def advance(pose, curvature, s):
    """Return the pose after length s on a constant curvature."""
    x, y, yaw = pose
    if curvature == 0.0:
        return (*shifted((x, y), yaw, s), yaw)
    turned = yaw + curvature * s
    return (x + (math.sin(turned) - math.sin(yaw)) / curvature,
            y - (math.cos(turned) - math.cos(yaw)) / curvature, turned)


def arc_to(pose, point):
    """Return the piece that leaves a pose along its heading and ends in a point."""
    chord = math.dist(pose[:2], point)
    half = wrap_angle(direction(pose[:2], point) - pose[2])
    if chord < 1e-9 or abs(2.0 * math.sin(half) / chord) < 1.0 / LARGEST_RADIUS:
        return Piece(pose, 0.0, chord)
    curvature = 2.0 * math.sin(half) / chord
    return Piece(pose, curvature, 2.0 * half / curvature)


def biarc(start, end):
    """Return two pieces from pose to pose, with equal tangent lengths."""
    vx, vy = end[0] - start[0], end[1] - start[1]
    c0, s0, c1, s1 = math.cos(start[2]), math.sin(start[2]), math.cos(end[2]), math.sin(end[2])
    vt = vx * (c0 + c1) + vy * (s0 + s1)
    twist = 2.0 * (1.0 - (c0 * c1 + s0 * s1))
    vv = vx * vx + vy * vy
    if twist < 1e-9:
        d = vv / (2.0 * vt)
    else:
        d = (-vt + math.sqrt(vt * vt + twist * vv)) / twist
    joint = ((start[0] + end[0] + d * (c0 - c1)) / 2.0, (start[1] + end[1] + d * (s0 - s1)) / 2.0)
    first = arc_to(start, joint)
    return [first, arc_to(first.end(), end[:2])]


def fit_errors(pieces, points, headings, lengths):
    """Return the largest lateral (m) and heading (rad) error of pieces along sampled poses."""
    total = sum(piece.length for piece in pieces)
    worst, worst_heading = 0.0, 0.0
    for point, heading, s in zip(points, headings, lengths):
        s = (s - lengths[0]) / (lengths[-1] - lengths[0]) * total
        piece = pieces[0]
        if s > piece.length and len(pieces) > 1:
            s, piece = s - piece.length, pieces[1]
        x, y, yaw = piece.pose_at(s)
        across = -math.sin(yaw) * (point[0] - x) + math.cos(yaw) * (point[1] - y)
        worst = max(worst, abs(across))
        worst_heading = max(worst_heading, abs(wrap_angle(heading - yaw)))
    return worst, worst_heading


def fit(points, headings):
    """Return pieces along a polyline with known headings, within the tolerances."""
    points, headings = densified(points, headings, LONGEST_STEP)
    lengths = cumulative_lengths(points)

    def between(i, j):
        pieces = biarc((*points[i], headings[i]), (*points[j], headings[j]))
        errors = fit_errors(pieces, points[i:j + 1], headings[i:j + 1], lengths[i:j + 1])
        good = errors[0] <= POSITION_TOLERANCE and errors[1] <= HEADING_TOLERANCE
        if good or j == i + 1:
            return pieces
        half = min(range(i + 1, j), key=lambda k: abs(lengths[k] - (lengths[i] + lengths[j]) / 2))
        return between(i, half) + between(half, j)

    return [piece for piece in between(0, len(points) - 1) if piece.length > 1e-6]


def merged(pieces):
    """Join neighbouring pieces that are straight or have almost the same curvature."""
    result = [pieces[0]]
    for piece in pieces[1:]:
        last = result[-1]
        length = last.length + piece.length
        joined = Piece(last.start, (last.curvature * last.length
                                    + piece.curvature * piece.length) / length, length)
        end, joined_end = piece.end(), joined.end()
        if (math.dist(end[:2], joined_end[:2]) < 1e-4 and abs(end[2] - joined_end[2]) < 1e-5):
            result[-1] = joined
        else:
            result.append(piece)
    return result


def primitive(pieces):
    """Return shape, radius and lengths of one primitive from one to three pieces that share a radius."""
    curved = [piece for piece in pieces if piece.curvature != 0.0]
    radius = 1.0 / abs(curved[0].curvature) if curved else STRAIGHT_RADIUS
    letters, lengths = [], []
    for slot in ("arc", "straight", "arc"):
        fits = pieces and (pieces[0].curvature == 0.0) == (slot == "straight")
        piece = pieces.pop(0) if fits else None
        letters.append("S" if slot == "straight" else
                       ("R" if piece and piece.curvature < 0.0 else "L"))
        lengths.append(round(piece.length, 4) if piece else 0.0)
    return letters, round(radius, 4), lengths


def arcline_path(pieces):
    """Return the primitives of the map file. Poses are computed from the rounded numbers in it."""
    path, waiting = [], merged(pieces)
    pose = tuple(round(v, 4) for v in waiting[0].start[:2]) + (round(waiting[0].start[2], 6),)
    while waiting:
        count = pieces_that_fit(waiting)
        letters, radius, lengths = primitive(waiting[:count])
        waiting = waiting[count:]
        end = pose
        for letter, length in zip(letters, lengths):
            end = advance(end, CURVATURES[letter] / radius, length)
        path.append({"start_pose": rounded_pose(pose), "end_pose": rounded_pose(end),
                     "shape": "".join(letters), "radius": radius, "segment_length": lengths})
        pose = end
    return path


def pieces_that_fit(pieces):
    """Return the number of first pieces that fit into one primitive: arc, straight, arc."""
    slots = ["arc", "straight", "arc"]
    radius, count = None, 0
    for piece in pieces:
        kind = "straight" if piece.curvature == 0.0 else "arc"
        if kind not in slots:
            break
        if kind == "arc":
            if radius is not None and abs(abs(1.0 / piece.curvature) - radius) > 1e-3:
                break
            radius = abs(1.0 / piece.curvature)
        slots = slots[slots.index(kind) + 1:]
        count += 1
    return count


def rounded_pose(pose):
    return [round(pose[0], 4), round(pose[1], 4), round(wrap_angle(pose[2]), 6)]


def path_poses(path, step):
    """Return poses along a path of a map file, at most `step` metres apart, integrated exactly."""
    poses = []
    for item in path:
        pose = tuple(item["start_pose"])
        for letter, length in zip(item["shape"], item["segment_length"]):
            count = max(math.ceil(length / step), 1)
            curvature = CURVATURES[letter] / item["radius"]
            poses += [advance(pose, curvature, length * i / count) for i in range(count + 1)]
            pose = advance(pose, curvature, length)
    return poses
