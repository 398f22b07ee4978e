"""OpenDRIVE files read by SUMO's netconvert, and how far its lanes are from the middles of the file's."""
import math
import os
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from virtual_environments import python_with

SPACING = 0.1  # m between the points of a lane
WORDS = ['--offset.disable-normalization', 'true', '--opendrive.internal-shapes', 'true',
         '--opendrive.curve-resolution', '0.5', '--junctions.endpoint-shape', 'true', '--no-turnarounds', 'true',
         '--no-warnings', 'true']


def places(pieces, begin, end):
    """Poses of a reference line between two arc lengths: (arc length, x, y, heading)."""
    found = []
    for piece in pieces:
        first, x, y, heading, length = (float(piece.get(name)) for name in ('s', 'x', 'y', 'hdg', 'length'))
        arc = piece.find('arc')
        curvature = float(arc.get('curvature')) if arc is not None else 0.0
        count = max(1, math.ceil(length / SPACING))
        ways = {length * step / count for step in range(count + 1)} | {begin - first, end - first}
        for way in sorted(way for way in ways if 0 <= way <= length and begin - 1e-9 <= first + way <= end + 1e-9):
            half = curvature * way / 2
            chord = way * (math.sin(half) / half if half else 1.0)
            found.append((first + way, x + chord * math.cos(heading + half), y + chord * math.sin(heading + half),
                          heading + 2 * half))
    return found


def value(pieces, at, start):
    """Value of a piecewise linear function at a distance."""
    part = [piece for piece in pieces if float(piece.get(start)) <= at + 1e-9][-1]
    return float(part.get('a')) + float(part.get('b')) * (at - float(part.get(start)))


def middles(road):
    """Points of the middles of a road's lanes for traffic."""
    sections = list(road.iter('laneSection'))
    ends = [float(section.get('s')) for section in sections[1:]] + [float(road.get('length'))]
    offsets = road.findall('lanes/laneOffset')
    for section, end in zip(sections, ends):
        begin = float(section.get('s'))
        for at, x, y, heading in places(road.find('planView'), begin, end):
            for side, sign in (('left', 1), ('right', -1)):
                border = value(offsets, at, 's')
                for lane in sorted(section.findall(side + '/lane'), key=lambda one: abs(int(one.get('id')))):
                    width = sign * value(lane.findall('width'), max(at - begin, 0.0), 'sOffset')
                    if lane.get('type') == 'driving':
                        middle = border + width / 2
                        yield x - middle * math.sin(heading), y + middle * math.cos(heading)
                    border += width


class Middles:
    """The points of the middles of all lanes of a file, found by their place."""

    def __init__(self, roads):
        self.cells = {}
        for road in roads:
            for x, y in middles(road):
                self.cells.setdefault((round(x), round(y)), []).append((x, y))

    def distance_to(self, x, y):
        """Return the distance (m) of the nearest point; infinite beyond about 1 m."""
        cells = [(round(x) + i, round(y) + j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
        return min((math.hypot(x - px, y - py) for cell in cells for px, py in self.cells.get(cell, ())),
                   default=math.inf)


class RoadsNotRead(Exception):
    """netconvert does not read a file as intended."""


def python_with_netconvert():
    """The interpreter of an environment with netconvert. That of Debian (1.15) draws junctions over short lanes."""
    return python_with('sumo', 'eclipse-sumo==1.28.0')


def farthest(python, path, net, like=None):
    """m that lanes of netconvert are off, at most; `net` is written. Raises RoadsNotRead.

    `python` is that of python_with_netconvert(); `like` is the file with the right lanes, by default `path`.
    """
    home = next(python.parent.parent.glob('lib/python*/site-packages/sumo'))
    result = subprocess.run([python.parent / 'netconvert', '--opendrive-files', path, '-o', net, *WORDS], text=True,
                            check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            env=dict(os.environ, SUMO_HOME=str(home)))
    if result.returncode or not Path(net).exists():
        raise RoadsNotRead('{}: {}'.format(path, result.stdout))
    roads = list(ElementTree.parse(path).getroot().iter('road'))
    lanes, seen, worst = Middles(ElementTree.parse(like or path).getroot().iter('road')), set(), 0.0
    for edge in ElementTree.parse(net).getroot().iter('edge'):
        if edge.get('function') != 'internal':
            seen.add(edge.get('id').lstrip('-').partition('#')[0])  # one from a junction to itself is split
        for lane in edge.iter('lane'):
            for point in lane.get('shape').split():
                x, y = (float(text) for text in point.split(',')[:2])
                worst = max(worst, lanes.distance_to(x, y))
    missing = {road.get('id') for road in roads if road.get('junction') == '-1'} - seen
    if missing:
        raise RoadsNotRead('{}: roads {} are no edges'.format(path, sorted(missing)))
    return worst
