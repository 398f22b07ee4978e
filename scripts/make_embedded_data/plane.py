"""Plane geometry: angles, polylines and oriented boxes. Angles in radians."""
import bisect
import math


def wrap_angle(angle):
    """Return the same angle in [-pi, pi)."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi


def direction(a, b):
    """Return the angle of the direction from point a to point b."""
    return math.atan2(b[1] - a[1], b[0] - a[0])


def shifted(point, angle, distance):
    """Return a point moved by a distance in the direction of an angle."""
    return (point[0] + distance * math.cos(angle), point[1] + distance * math.sin(angle))


def without_repeats(points, shortest=1e-3):
    """Return a polyline without segments shorter than `shortest`; both ends are kept."""
    kept = [points[0]]
    for point in points[1:]:
        if math.dist(point, kept[-1]) >= shortest:
            kept.append(point)
    if kept[-1] != points[-1] and len(kept) > 1:
        kept[-1] = points[-1]
    return kept


def cumulative_lengths(points):
    """Return the length along a polyline at each of its points."""
    lengths = [0.0]
    for a, b in zip(points, points[1:]):
        lengths.append(lengths[-1] + math.dist(a, b))
    return lengths


def point_at(points, lengths, s):
    """Return the point at length s, clamped to the ends."""
    i = min(max(bisect.bisect_right(lengths, s), 1), len(points) - 1)
    span = lengths[i] - lengths[i - 1]
    t = min(max((s - lengths[i - 1]) / span, 0.0), 1.0) if span > 0.0 else 0.0
    a, b = points[i - 1], points[i]
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))


def vertex_headings(points):
    """Return the heading of the smooth curve that a polyline samples, at each point.

    Inside: the mean of both sides weighted by length, exact on a circle; beside a
    much longer side, taken as straight, the heading of that side. At the ends:
    extrapolated from the first or last two segments.
    """
    steps = [direction(a, b) for a, b in zip(points, points[1:])]
    sizes = [math.dist(a, b) for a, b in zip(points, points[1:])]
    if len(steps) == 1:
        return [steps[0], steps[0]]
    inner = []
    for (a, b), (size_a, size_b) in zip(zip(steps, steps[1:]), zip(sizes, sizes[1:])):
        share = size_a / (size_a + size_b)
        share = 0.0 if share > 0.8 else 1.0 if share < 0.2 else share
        inner.append(a + wrap_angle(b - a) * share)
    first = steps[0] - wrap_angle(inner[0] - steps[0])
    last = steps[-1] + wrap_angle(steps[-1] - inner[-1])
    return [first, *inner, last]


def densified(points, headings, longest):
    """Return a polyline and its headings with segments of at most `longest`."""
    new_points, new_headings = [points[0]], [headings[0]]
    for i in range(1, len(points)):
        a, b = points[i - 1], points[i]
        count = math.ceil(math.dist(a, b) / longest)
        for k in range(1, count):
            t = k / count
            new_points.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
            new_headings.append(direction(a, b))
        new_points.append(b)
        new_headings.append(headings[i])
    return new_points, new_headings


def offset_line(points, headings, left):
    """Return a polyline moved to its left; a negative distance moves it to its right."""
    return [shifted(p, h + math.pi / 2.0, left) for p, h in zip(points, headings)]


def simplified(points, tolerance):
    """Return a polyline simplified by the Douglas-Peucker algorithm."""
    if len(points) < 3:
        return list(points)
    a, b = points[0], points[-1]
    span = math.dist(a, b) or 1e-9
    off = [abs((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / span
           for p in points]
    worst = max(range(len(points)), key=off.__getitem__)
    if off[worst] <= tolerance:
        return [a, b]
    return (simplified(points[:worst + 1], tolerance)[:-1]
            + simplified(points[worst:], tolerance))


def box_corners(x, y, yaw, length, width):
    """Return the four corners of an oriented box."""
    c, s = math.cos(yaw), math.sin(yaw)
    return [(x + c * l - s * w, y + s * l + c * w)
            for l, w in ((length / 2, width / 2), (-length / 2, width / 2),
                         (-length / 2, -width / 2), (length / 2, -width / 2))]


def boxes_overlap(a, b):
    """Return True if two boxes (x, y, yaw, length, width) overlap, by separating axes."""
    reach = (math.hypot(a[3], a[4]) + math.hypot(b[3], b[4])) / 2.0
    if math.hypot(a[0] - b[0], a[1] - b[1]) > reach:
        return False
    corners_a, corners_b = box_corners(*a), box_corners(*b)
    for yaw in (a[2], a[2] + math.pi / 2, b[2], b[2] + math.pi / 2):
        c, s = math.cos(yaw), math.sin(yaw)
        along_a = [c * x + s * y for x, y in corners_a]
        along_b = [c * x + s * y for x, y in corners_b]
        if max(along_a) <= min(along_b) or max(along_b) <= min(along_a):
            return False
    return True


def inside_polygon(point, polygon):
    """Return True if a point lies in a polygon, by counting crossings of a ray."""
    x, y = point
    inside = False
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) / (y1 - y0) * (x1 - x0):
            inside = not inside
    return inside
