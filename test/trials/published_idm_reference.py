#!/usr/bin/python3
"""usage: published_idm_reference.py CLIPS RESULTS: do results.csv of `forge test --collide` and this agree on idm_published?

A second implementation of the published IDM and of how its collisions are counted (docs/planners.md), written apart from
trials/published_planner.cpp: it reads the clips of the folder CLIPS by itself, drives the ego of each along its recorded path behind the
set's own attacker from frame 0 on, judges it by published_reference, and prints both implementations' rates by type. Exit code 1 if a
rate differs by more than two points."""
import csv
import math
import sys
from pathlib import Path

from published_reference import State, judge, read_clip

SPEED, HEADWAY, ACCELERATION, BRAKING, GAP, EXPONENT = 5.0, 1.5, 5.0, 2.0, 2.0, 4.0
STEP = 0.1        # s
ALLOWED = 0.02    # of a rate


def state_at(track, time):
    """Position and speed, linear between frames; time in microseconds."""
    frame = max(i for i in range(len(track) - 1) if i == 0 or track[i].time <= time)
    start, end = track[frame], track[frame + 1]
    share = (time - start.time) / (end.time - start.time)
    speed = math.hypot(end.x - start.x, end.y - start.y) / (end.time - start.time) * 1e6
    return start.x + share * (end.x - start.x), start.y + share * (end.y - start.y), speed


class Way:
    """The recorded way, straight on after its end."""

    def __init__(self, states):
        self.points = [(states[0].x, states[0].y)]
        for state in states[1:]:
            if math.hypot(state.x - self.points[-1][0], state.y - self.points[-1][1]) > 0.01:
                self.points.append((state.x, state.y))
        if len(self.points) == 1:
            yaw = math.radians(states[0].yaw)
            self.points.append((states[0].x + math.cos(yaw), states[0].y + math.sin(yaw)))

    def at(self, way):
        """Position and heading in degrees."""
        for i, (start, end) in enumerate(zip(self.points, self.points[1:])):
            length = math.hypot(end[0] - start[0], end[1] - start[1])
            if way <= length or i == len(self.points) - 2:
                dx, dy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
                return start[0] + way * dx, start[1] + way * dy, math.degrees(math.atan2(dy, dx))
            way -= length
        return None


def acceleration(speed, lead_speed, distance):
    desired = GAP + speed * HEADWAY + speed * (speed - lead_speed) / (2.0 * math.sqrt(ACCELERATION * BRAKING))
    share = max(desired, 0.0) / max(distance, 0.01)
    return ACCELERATION * (1.0 - (speed / SPEED) ** EXPONENT - share * share)


def drive(ego, attacker):
    """The ego's track with IDM from frame 0 on."""
    path = Way(ego)
    way, time = 0.0, ego[0].time
    speed = state_at(ego, time)[2]
    ways = [(time, way)]
    while time < ego[-1].time:
        x, y, _ = path.at(way)
        lead_x, lead_y, lead_speed = state_at(attacker, min(time, attacker[-1].time))
        demanded = acceleration(speed, lead_speed, math.hypot(lead_x - x, lead_y - y))
        after = max(speed + STEP * demanded, 0.0)
        way += 0.5 * (speed + after) * STEP
        speed = after
        time += STEP * 1e6
        ways.append((time, way))

    def driven(state):
        for (before, start), (later, end) in zip(ways, ways[1:]):
            if state.time <= later:
                here = start + (state.time - before) / (later - before) * (end - start)
                return State(state.time, 0.0, *path.at(here))
        return State(state.time, 0.0, *path.at(ways[-1][1]))
    return [ego[0]] + [driven(state) for state in ego[1:]]


def is_hit(clip):
    attacker = clip.tracks[clip.attacker]
    clip.tracks['ego'] = drive(clip.tracks['ego'], attacker)
    return judge(clip, attacker).event == 'hit'


def rates(clips, results):
    """By type and for all: clips, hits here, hits there."""
    counts = {}
    with open(str(results)) as file:
        rows = [row for row in csv.DictReader(file) if row['planner'] == 'idm_published' and row['published_hit']]
    for row in rows:
        here = is_hit(read_clip(Path(clips, row['name'] + '.csv')))
        for group in (row['type'], 'all'):
            count = counts.setdefault(group, [0, 0, 0])
            counts[group] = [count[0] + 1, count[1] + here, count[2] + int(row['published_hit'])]
    return counts


def main(clips, results):
    counts = rates(clips, results)
    if not counts:
        raise SystemExit('{} has no row of idm_published'.format(results))
    differing = 0
    for group, (number, here, there) in sorted(counts.items()):
        print('{}: {} clips, collision rate {:.4f} here and {:.4f} there'.format(group, number, here / number,
                                                                                 there / number))
        differing += abs(here - there) > ALLOWED * number
    return 1 if differing else 0


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__.split('\n', maxsplit=1)[0])
    sys.exit(main(sys.argv[1], sys.argv[2]))
