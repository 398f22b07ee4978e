#!/usr/bin/python3
"""Planner process without ROS, for forge test --planner-command: keeps its speed and brakes for agents on the route."""
import json
import math
import os
import sys

BRAKING = float(os.environ.get('braking', 4.0))  # m/s2; a parameter of planners.yaml, section external
STEPS, STEP, CORRIDOR, MARGIN = 40, 0.1, 2.0, 5.0  # number of steps; s; half width in m around the route; m


def along(route, x, y):
    """Return the arc length (m) of the nearest point of the route, and the distance (m) to it."""
    best, length = (0.0, math.inf), 0.0
    for (ax, ay), (bx, by) in zip(route, route[1:]):
        step = math.hypot(bx - ax, by - ay)
        share = min(1.0, max(0.0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / step ** 2)) if step else 0.0
        aside = math.hypot(ax + share * (bx - ax) - x, ay + share * (by - ay) - y)
        best = min(best, (length + share * step, aside), key=lambda found: found[1])
        length += step
    return best


def pose_at(route, length):
    for (ax, ay), (bx, by) in zip(route, route[1:]):
        step = math.hypot(bx - ax, by - ay)
        if length <= step or (bx, by) == tuple(route[-1]):
            return [ax + (bx - ax) * length / step, ay + (by - ay) * length / step, math.atan2(by - ay, bx - ax)]
        length -= step


def plan(route, ego, agents):
    time, x, y, _, speed, _, _ = ego
    start, _ = along(route, x, y)
    positions = [along(route, *agent['states'][-1][1:3]) for agent in agents]
    gaps = [place - start for place, aside in positions if aside < CORRIDOR and place > start]
    change = -BRAKING if min(gaps, default=math.inf) < speed ** 2 / (2 * BRAKING) + MARGIN else 0.0
    points, driven = [ego], 0.0
    for step in range(1, STEPS + 1):
        driven, speed = driven + speed * STEP, max(0.0, speed + change * STEP)
        points.append([time + step * STEP, *pose_at(route, start + driven), speed])
    return points


print(json.dumps({'ready': 1}), flush=True)
for line in sys.stdin:
    request = json.loads(line)
    if 'begin' in request:
        task, response = request['begin'], {}
    else:
        response = {'points': plan(task['route'], request['plan']['ego'][0], request['plan']['agents'])}
    print(json.dumps(response), flush=True)
