#!/usr/bin/python3
"""usage: published_reference.py CLIPS RESULTS: compare results.csv of `evaluate --protocol published` with this program.

A second implementation of the published protocol (docs/protocols.md), independent of study/evaluation/published.cpp. Reads
the clips of the folder CLIPS, judges the recorded and the constant-velocity attackers, prints the rates of both
implementations and the name of each clip for which they differ. Exit code 1 if any differs."""
import csv
import math
import sys
from collections import namedtuple
from pathlib import Path

LENGTH, WIDTH = 4.7, 2.0   # m
THRESHOLD = 0.02           # shared over joint area
STEPS, STEPS_AFTER = 5, 20
SIMILAR = 10.0             # degrees
NOW = 7                    # frame
DEGREES_TOLERANCE = 0.011  # results.csv has two decimals
TIME_TOLERANCE = 1e-3      # and three of seconds

State = namedtuple('State', 'time speed x y yaw')  # microseconds, m/s, m, m, degrees
Clip = namedtuple('Clip', 'attacker angle tracks')
Outcome = namedtuple('Outcome', 'event step heading')  # event: hit, attacker, ego or none; heading in degrees


def read_clip(path):
    fields = path.stem.split('_')
    tracks = {}
    with open(str(path)) as file:
        for row in csv.DictReader(file):
            state = State(int(row['TIMESTAMP']), *(float(row[key]) for key in ('V', 'X', 'Y', 'YAW')))
            tracks.setdefault(row['TRACK_ID'], []).append(state if any(state[1:]) else None)
    return Clip(fields[9], float(fields[8]), tracks)


# ---- overlap: the joint corners of both boxes, in order around their mean ----

def corners(box):
    x, y, yaw = box
    c, s = math.cos(math.radians(yaw)), math.sin(math.radians(yaw))
    return [(x + c * u - s * v, y + s * u + c * v) for u, v in ((LENGTH / 2, WIDTH / 2), (-LENGTH / 2, WIDTH / 2),
                                                                (-LENGTH / 2, -WIDTH / 2), (LENGTH / 2, -WIDTH / 2))]


def is_inside(point, box):
    c, s = math.cos(math.radians(box[2])), math.sin(math.radians(box[2]))
    dx, dy = point[0] - box[0], point[1] - box[1]
    return abs(c * dx + s * dy) <= LENGTH / 2 + 1e-9 and abs(c * dy - s * dx) <= WIDTH / 2 + 1e-9


def crossing(a, b, c, d):
    """Return the intersection of the segments a-b and c-d, or None."""
    bx, by, dx, dy = b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]
    determinant = bx * dy - by * dx
    if abs(determinant) < 1e-12:
        return None
    t = ((c[0] - a[0]) * dy - (c[1] - a[1]) * dx) / determinant
    u = ((c[0] - a[0]) * by - (c[1] - a[1]) * bx) / determinant
    return (a[0] + t * bx, a[1] + t * by) if 0.0 <= t <= 1.0 and 0.0 <= u <= 1.0 else None


def shared_area(first, second):
    a, b = corners(first), corners(second)
    points = [p for p in a if is_inside(p, second)] + [p for p in b if is_inside(p, first)]
    points += filter(None, (crossing(a[i - 1], a[i], b[j - 1], b[j]) for i in range(4) for j in range(4)))
    if len(points) < 3:
        return 0.0
    x = sum(p[0] for p in points) / len(points)
    y = sum(p[1] for p in points) / len(points)
    points.sort(key=lambda p: math.atan2(p[1] - y, p[0] - x))
    return 0.5 * abs(sum((points[i - 1][0] - x) * (points[i][1] - y) - (points[i][0] - x) * (points[i - 1][1] - y)
                         for i in range(len(points))))


def collide(first, second):
    if math.hypot(first[0] - second[0], first[1] - second[1]) > math.hypot(LENGTH, WIDTH):
        return False
    second = (second[0] - first[0], second[1] - first[1], second[2])
    shared = shared_area((0.0, 0.0, first[2]), second)
    return shared / (2.0 * LENGTH * WIDTH - shared) > THRESHOLD


# ---- the protocol ----

def box_at(track, step):
    """Return the box of a track at a step counted from frame 0, or None while it is missing."""
    last = len(track) - 1
    frame = min(step // STEPS, last - 1)
    start, end = track[frame], track[frame + 1]
    if start is None or end is None:
        return None
    share = (step - STEPS * frame) / STEPS
    return (start.x + share * (end.x - start.x), start.y + share * (end.y - start.y), start.yaw)


def turn(first, second):
    """Return the absolute difference of two angles, in degrees up to 180."""
    return abs((second - first + 180.0) % 360.0 - 180.0)


def judge(clip, attacker):
    """Return the first event if the clip's attacker follows the track `attacker`."""
    tracks = dict(clip.tracks)
    tracks[clip.attacker] = attacker
    for step in range(STEPS * (len(attacker) - 1) + STEPS_AFTER):
        ego, attacking = box_at(tracks['ego'], step), box_at(attacker, step)
        for key in sorted(tracks):
            other = box_at(tracks[key], step)
            if key == 'ego' or other is None:
                continue
            if key == clip.attacker:
                if collide(ego, attacking):
                    return Outcome('hit', step, turn(ego[2], attacking[2]))
            elif collide(attacking, other):
                return Outcome('attacker', step, None)
            elif collide(ego, other):
                return Outcome('ego', step, None)
    return Outcome('none', None, None)


def at_constant_velocity(track):
    now = track[NOW]
    c, s = math.cos(math.radians(now.yaw)), math.sin(math.radians(now.yaw))

    def later(state):
        way = now.speed * (state.time - now.time) * 1e-6
        return State(state.time, now.speed, now.x + c * way, now.y + s * way, now.yaw)
    return track[:NOW + 1] + [later(state) for state in track[NOW + 1:]]


METHODS = {'recorded': lambda track: track, 'constant_velocity': at_constant_velocity}


# ---- the comparison ----

def difference(clip, row):
    """Return the differences between a row of results.csv and this implementation's outcome, and the outcome."""
    outcome = judge(clip, METHODS[row['method']](clip.tracks[clip.attacker]))
    is_hit = outcome.event == 'hit'
    is_similar = is_hit and abs(outcome.heading - clip.angle) < SIMILAR
    found = []
    if row['collision'] != str(int(is_hit)) or row['similar'] != str(int(is_similar)):
        found.append('collision {}, similar {}'.format(is_hit, is_similar))
    if (outcome.step is None) != (row['contact_after'] == ''):
        found.append('event {}'.format(outcome.event))
    elif outcome.step is not None:
        after = 0.5 * (outcome.step / STEPS - NOW)
        if abs(float(row['contact_after']) - after) > TIME_TOLERANCE:
            found.append('event {} after {} s'.format(outcome.event, after))
    if is_hit and row['relative_heading']:
        if abs(float(row['relative_heading']) - outcome.heading) > DEGREES_TOLERANCE:
            found.append('relative heading {}'.format(outcome.heading))
    return outcome, is_similar, ', '.join(found)


def compare(clips, results):
    """Print the comparison. Return the number of different rows, and the number of outcomes by event."""
    with open(str(results)) as file:
        rows = [row for row in csv.DictReader(file) if row['method'] in METHODS]
    if not rows:
        raise SystemExit('{} has no row of {}'.format(results, ', '.join(METHODS)))
    differing, events = 0, {}
    counts = {method: [0, 0, 0, 0, 0] for method in METHODS}
    for row in rows:
        outcome, is_similar, text = difference(read_clip(Path(clips, row['name'] + '.csv')), row)
        events[outcome.event] = events.get(outcome.event, 0) + 1
        here = (1, outcome.event == 'hit', is_similar, int(row['collision']), int(row['similar']))
        counts[row['method']] = [sum(pair) for pair in zip(counts[row['method']], here)]
        if text:
            differing += 1
            print('{} {}: {}; there {}'.format(row['name'], row['method'], text, dict(row)))
    for method, (number, hits, similar, hits_there, similar_there) in counts.items():
        print('{}: {} clips, collision rate {:.4f} here and {:.4f} there, similarity {:.4f} and {:.4f}'.format(
            method, number, hits / max(number, 1), hits_there / max(number, 1), similar / max(hits, 1),
            similar_there / max(hits_there, 1)))
    print('{} of {} rows differ'.format(differing, len(rows)))
    return differing, events


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__.split('\n', maxsplit=1)[0])
    sys.exit(1 if compare(sys.argv[1], sys.argv[2])[0] else 0)
