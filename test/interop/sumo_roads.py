"""OpenDRIVE files read by SUMO's netconvert, and how far its lanes are beside the middles of the file's."""
import math
import os
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from virtual_environments import python_with

SPACING = 0.5  # m between the points of a lane
MOVED = 6.0  # m by which netconvert moves ends of lanes along the road, at most
WORDS = ['--offset.disable-normalization', 'true', '--opendrive.internal-shapes', 'true',
         '--opendrive.curve-resolution', '0.5', '--junctions.endpoint-shape', 'true', '--no-turnarounds', 'true',
         '--opendrive.import-all-lanes', 'true', '--no-warnings', 'true']


def places(pieces, begin, end):
    """Poses of a reference line between two arc lengths: (arc length, x, y, heading)."""
    found = []
    for piece in pieces:
        first, x, y, heading, length = (float(piece.get(name)) for name in ('s', 'x', 'y', 'hdg', 'length'))
        arc = piece.find('arc')
        curvature = float(arc.get('curvature')) if arc is not None else 0.0
        count = max(1, math.ceil(length / SPACING))
        ways = {length * step / count for step in range(count + 1)} | {begin - first, end - first}
        low, high = max(0.0, begin - first) - 1e-9, min(length, end - first) + 1e-9
        for way in sorted(way for way in ways if low <= way <= high):
            half = curvature * way / 2
            chord = way * (math.sin(half) / half if half else 1.0)
            found.append((first + way, x + chord * math.cos(heading + half), y + chord * math.sin(heading + half),
                          heading + 2 * half))
    return found


def value(pieces, at, start):
    """Value of a piecewise linear function at a distance."""
    part = [piece for piece in pieces if float(piece.get(start)) <= at + 1e-9][-1]
    return float(part.get('a')) + float(part.get('b')) * (at - float(part.get(start)))


def middle_lines(road, kinds=('driving',), beyond=0.0):
    """The middles of a road's lanes of these types, a line of points for each lane and lane section.

    `beyond` (m) is the length by which straight lines extend both ends.
    """
    sections = list(road.iter('laneSection'))
    ends = [float(section.get('s')) for section in sections[1:]] + [float(road.get('length'))]
    offsets = road.findall('lanes/laneOffset')
    for section, end in zip(sections, ends):
        begin, lines = float(section.get('s')), {}
        for at, x, y, heading in places(road.find('planView'), begin, end):
            for side, sign in (('left', 1), ('right', -1)):
                border = value(offsets, at, 's')
                for lane in sorted(section.findall(side + '/lane'), key=lambda one: abs(int(one.get('id')))):
                    width = sign * value(lane.findall('width'), max(at - begin, 0.0), 'sOffset')
                    if lane.get('type') in kinds:
                        middle = border + width / 2
                        lines.setdefault(lane.get('id'), []).append(
                            (x - middle * math.sin(heading), y + middle * math.cos(heading), heading))
                    border += width
        for line in lines.values():
            (x, y, heading), (to_x, to_y, to_heading) = line[0], line[-1]
            points = [(x, y) for x, y, _ in line]
            yield [(x - beyond * math.cos(heading), y - beyond * math.sin(heading)), *points,
                   (to_x + beyond * math.cos(to_heading), to_y + beyond * math.sin(to_heading))]


class Lines:
    """Lines of points, found by their place."""

    def __init__(self, lines):
        self.cells = {}
        for line in lines:
            for (x, y), (to_x, to_y) in zip(line, line[1:]):
                count = max(1, math.ceil(math.hypot(to_x - x, to_y - y)))
                points = [(x + (to_x - x) * i / count, y + (to_y - y) * i / count) for i in range(count + 1)]
                for piece in zip(points, points[1:]):
                    self.cells.setdefault((round(piece[0][0]), round(piece[0][1])), []).append(piece)

    def distance_to(self, x, y):
        """Return the distance (m) of the nearest line; infinite beyond about 1 m."""
        cells = [(round(x) + i, round(y) + j) for i in (-2, -1, 0, 1, 2) for j in (-2, -1, 0, 1, 2)]
        return min((to_piece(x, y, *piece) for cell in cells for piece in self.cells.get(cell, ())), default=math.inf)


def to_piece(x, y, begin, end):
    """Distance (m) of a point from a straight piece."""
    along = end[0] - begin[0], end[1] - begin[1]
    square = along[0] ** 2 + along[1] ** 2
    share = ((x - begin[0]) * along[0] + (y - begin[1]) * along[1]) / square if square else 0.0
    share = min(max(share, 0.0), 1.0)
    return math.hypot(x - begin[0] - share * along[0], y - begin[1] - share * along[1])


class RoadsNotRead(Exception):
    """netconvert does not read a file as intended."""


def python_with_netconvert():
    """The interpreter of an environment with netconvert. That of Debian (1.15) draws junctions over short lanes."""
    return python_with('sumo', 'eclipse-sumo==1.28.0')


def farthest(python, path, net, like=None):
    """m that lanes of netconvert are beside the file's lanes, at most; `net` is written. Raises RoadsNotRead.

    netconvert makes room for a junction where lane sections meet, and moves short pieces along the road; so lanes are
    extended by MOVED. Sidewalks and other lanes without vehicles are not compared.

    `python` is that of python_with_netconvert(); `like` is the file with the right lanes, by default `path`.
    """
    home = next(python.parent.parent.glob('lib/python*/site-packages/sumo'))
    result = subprocess.run([python.parent / 'netconvert', '--opendrive-files', path, '-o', net, *WORDS], text=True,
                            check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            env=dict(os.environ, SUMO_HOME=str(home)))
    if result.returncode or not Path(net).exists():
        raise RoadsNotRead('{}: {}'.format(path, result.stdout))
    roads = list(ElementTree.parse(path).getroot().iter('road'))
    right = ElementTree.parse(like or path).getroot().iter('road')
    lanes = Lines(line for road in right for line in middle_lines(road, ('driving', 'biking'), MOVED))
    seen, worst = set(), 0.0
    for edge in ElementTree.parse(net).getroot().iter('edge'):
        if edge.get('function') != 'internal':
            seen.add(edge.get('id').lstrip('-').partition('#')[0])  # one from a junction to itself is split
        for lane in edge.iter('lane'):
            if lane.get('type') in ('sidewalk', 'shoulder') or lane.get('disallow') == 'all':
                continue
            for point in lane.get('shape').split():
                x, y = (float(text) for text in point.split(',')[:2])
                worst = max(worst, lanes.distance_to(x, y))
    missing = {road.get('id') for road in roads if road.get('junction') == '-1'} - seen
    if missing:
        raise RoadsNotRead('{}: roads {} are no edges'.format(path, sorted(missing)))
    return worst
