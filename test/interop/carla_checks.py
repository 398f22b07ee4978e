"""usage: carla_checks.py MAP.xodr LANES.json: compares lanes that were read from an OpenDRIVE file with CARLA's reader.

LANES.json: {id: {"line": [[x, y], ...], "next": [ids]}}, ids as ROAD.SECTION.LANE. Prints as JSON the number of
waypoints on lanes of CARLA, their largest distance (m) from the lanes of the same road, and the lanes at whose end CARLA
continues elsewhere.
"""
import json
import math
import sys

import carla

SPACING = 0.5  # m between waypoints
AHEAD = 1.0    # m beyond the end of a lane


def place_of(waypoint):
    """Return x and y in the frame of the file: CARLA's y axis points to the right."""
    location = waypoint.transform.location
    return location.x, -location.y


def distance(point, line):
    """Return the distance (m) of a point from a polyline."""
    best = math.inf
    for (x1, y1), (x2, y2) in zip(line, line[1:]):
        dx, dy = x2 - x1, y2 - y1
        share = ((point[0] - x1) * dx + (point[1] - y1) * dy) / max(dx * dx + dy * dy, 1e-12)
        share = min(max(share, 0.0), 1.0)
        best = min(best, math.hypot(point[0] - x1 - share * dx, point[1] - y1 - share * dy))
    return best


def main(path, lanes_path):
    with open(path, encoding='utf-8') as file:
        town = carla.Map('town', file.read())
    with open(lanes_path, encoding='utf-8') as file:
        lanes = json.load(file)
    of_road = {}
    for name, lane in lanes.items():
        of_road.setdefault(int(name.split('.')[0]), []).append((name, lane))
    waypoints, worst, last = town.generate_waypoints(SPACING), 0.0, {}
    for waypoint in waypoints:
        point = place_of(waypoint)
        gap, name = min((distance(point, lane['line']), name) for name, lane in of_road[waypoint.road_id])
        worst = max(worst, gap)
        end = lanes[name]['line'][-1]
        beyond = math.hypot(end[0] - point[0], end[1] - point[1])
        last[name] = min(last.get(name, (math.inf, None)), (beyond, waypoint), key=lambda entry: entry[0])
    elsewhere = []
    for name, (beyond, waypoint) in last.items():
        reached = [lanes[following]['line'] for following in lanes[name]['next']]
        for following in waypoint.next(beyond + AHEAD):
            gap = min((distance(place_of(following), line) for line in reached), default=math.inf)
            if gap > 0.1 and reached:
                elsewhere.append(name)
        if len(waypoint.next(beyond + AHEAD)) != len(reached) and reached:
            elsewhere.append(name)
    print(json.dumps({'waypoints': len(waypoints), 'worst': worst, 'elsewhere': sorted(set(elsewhere))}))


if __name__ == '__main__':
    main(*sys.argv[1:])
