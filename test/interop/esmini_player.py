"""Files of OpenSCENARIO played by esmini, a headless player, and how its motion compares with the file's."""
import bisect
import math
import os
import re
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

STEP = 0.02  # s of simulated time
COLUMNS = 31  # of the CSV for each entity, from its name on; X, Y and heading are columns 11, 12 and 24
# By default esmini drops trajectory points closer than 0.1 m and turns at corners only.
WORDS = ['--headless', '--disable_stdout', '--collision', '--fixed_timestep', str(STEP), '--traj_filter', '0',
         '--pline_interpolation', 'segment']
# Missing pictures of cars, and agents that disappear while they touch another one.
HARMLESS = re.compile(r'3D model .* not located|Unregister collision between .* vanished entity')
TOUCH = re.compile(r'\[([\d.]+)\] \[warn\] Collision between (\S+) and (\S+)$')


def player():
    """The program named by the environment variable ESMINI, or that of PATH. Raises unittest.SkipTest."""
    program = os.environ.get('ESMINI') or shutil.which('esmini')
    if not program:
        raise unittest.SkipTest('esmini is neither in PATH nor named by ESMINI: no file is played')
    return program


class Entity:
    """An entity of a file: times (s) and poses in the map's frame of its trajectory, empty if it has none."""

    def __init__(self):
        self.times, self.poses = [], []
        self.begin, self.end = 0.0, math.inf

    def pose_at(self, time):
        after = min(max(bisect.bisect_right(self.times, time), 1), len(self.times) - 1)
        first, last = self.times[after - 1], self.times[after]
        share = min(max((time - first) / (last - first), 0.0), 1.0)
        return [a + share * (b - a) for a, b in zip(self.poses[after - 1], self.poses[after])]


class Scenario:
    """What a file says: its parameters and entities."""

    def __init__(self, path):
        root = ElementTree.parse(path).getroot()
        self.parameters = {one.get('name'): one.get('value') for one in root.iter('ParameterDeclaration')}
        self.entities = {one.get('name'): Entity() for one in root.iter('ScenarioObject')}
        origin = [float(self.parameters['map_origin_' + axis]) for axis in 'xy']
        for trajectory in root.iter('Trajectory'):
            entity = self.entities[trajectory.get('name').rpartition(' ')[2]]
            for vertex in trajectory.iter('Vertex'):
                place = next(vertex.iter('WorldPosition'))
                entity.times.append(float(vertex.get('time')))
                entity.poses.append([float(place.get('x')) + origin[0], float(place.get('y')) + origin[1]])
        for event in root.iter('Event'):
            for action in event.iter('EntityAction'):
                time = float(next(event.iter('SimulationTimeCondition')).get('value'))
                entity = self.entities[action.get('entityRef')]
                if action.find('AddEntityAction') is not None:
                    entity.begin = time
                else:
                    entity.end = time


class Play:
    """A file as esmini plays it."""

    def __init__(self, program, path, folder):
        table, log = folder / (path.stem + '.csv'), folder / (path.stem + '.log')
        subprocess.run([program, '--osc', path, '--csv_logger', table, '--logfile_path', log, *WORDS], check=True,
                       stdout=subprocess.DEVNULL)
        lines = log.read_text().splitlines()
        touches = [match for match in map(TOUCH.search, lines) if match]
        self.touches = [(float(match[1]), {match[2], match[3]}) for match in touches]
        self.complaints = [line for line in lines if ('[warn]' in line or '[error]' in line) and
                           not HARMLESS.search(line) and 'Collision between' not in line]
        self.places = {}  # by entity: (time, x, y, heading)
        for line in table.read_text().splitlines():
            fields = [field.strip() for field in line.split(',')]
            if not fields[0].isdigit():
                continue
            for first in range(2, len(fields) - COLUMNS + 2, COLUMNS):
                self.places.setdefault(fields[first], []).append(
                    tuple(float(fields[column]) for column in (1, first + 11, first + 12, first + 24)))

    def contact(self):
        """Time (s) of the first contact of ego and attacker; None if there is none."""
        return next((time for time, pair in self.touches if pair == {'ego', 'attacker'}), None)

    def farthest(self, scenario):
        """The greatest distance (m) of an entity from its trajectory."""
        worst = 0.0
        for name, places in self.places.items():
            entity = scenario.entities[name]
            for time, x, y, _ in places:
                if entity.times and time <= entity.times[-1]:
                    wanted = entity.pose_at(time)
                    worst = max(worst, math.hypot(x - wanted[0], y - wanted[1]))
        return worst

    def off_stage(self, scenario):
        """Names of the entities that appear or disappear more than a step from their times."""
        last = max(places[-1][0] for places in self.places.values())
        return [name for name, entity in scenario.entities.items()
                if name not in self.places or abs(self.places[name][0][0] - entity.begin) > 1.01 * STEP or
                abs(self.places[name][-1][0] - min(entity.end, last)) > 1.01 * STEP]
