#!/usr/bin/python3
"""usage: lanelet2_checks.py OUT.osm LATITUDE LONGITUDE: writes a map with lanelet2, in an environment that has it.

Prints one JSON: {id: centreline as lanelet2 computes it after it has read the file again, list of [x, y]}.
"""
import json
import math
import sys

from lanelet2.core import AttributeMap, Lanelet, LaneletMap, LineString3d, Point3d, getId
from lanelet2.io import Origin, load, write
from lanelet2.projection import UtmProjector


def line(places):
    return LineString3d(getId(), [Point3d(getId(), x, y, 0) for x, y in places])


def arc(radius, degrees, pieces, at):
    """Counter-clockwise from `at`, around a centre to its left."""
    angles = [math.radians(degrees) * i / pieces for i in range(pieces + 1)]
    return [(at[0] + radius * math.sin(angle), at[1] - radius * math.cos(angle)) for angle in angles]


def wave(offset, step, at):
    """Over 60 m; an offset of more than 0 is to the left."""
    places = []
    for i in range(int(60 / step) + 1):
        x = i * step
        slope = 3 / 8 * math.cos(x / 8)
        length = math.hypot(1, slope)
        places.append((at[0] + x - offset * slope / length, at[1] + 3 * math.sin(x / 8) + offset / length))
    return places


def bounds():
    """Pairs of a left and a right bound."""
    return [
        ([(0, 3.5), (100, 3.5)], [(0, 0), (30, 0), (60, 0), (100, 0)]),
        ([(0, 13.5), (100, 23.5)][::-1], [(0, 10), (100, 20)]),
        ([(0, 33.5), (50, 33.5), (100, 36)], [(0, 30), (50, 30), (100, 30)]),
        (arc(10, 90, 24, (0, 60)), arc(13.5, 90, 31, (0, 60))),
        (arc(6, 170, 30, (0, 100)), arc(9, 170, 60, (0, 100))),
        (wave(1.6, 1.0, (0, 140)), wave(-1.6, 1.5, (0, 140))),
    ]


def main(path, latitude, longitude):
    projector = UtmProjector(Origin(float(latitude), float(longitude)))
    made = LaneletMap()
    for left, right in bounds():
        lanelet = Lanelet(getId(), line(left), line(right), AttributeMap({'type': 'lanelet', 'subtype': 'road'}))
        made.add(lanelet)
    write(path, made, projector)
    read = load(path, projector)
    print(json.dumps({lanelet.id: [(point.x, point.y) for point in lanelet.centerline]
                      for lanelet in read.laneletLayer}))


if __name__ == '__main__':
    main(*sys.argv[1:])
