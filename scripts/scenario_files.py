"""Reads scenario files and vehicle limits for the scripts that check attackers, without code of the package itself."""
import json
import math
from pathlib import Path

import yaml

CONFIG = Path(__file__).resolve().parent.parent / 'config'
VERSIONS = (5, 6, 7)

DRIVABLE = ('wheelbase_share', 'max_steering_angle', 'max_steering_rate', 'max_lateral_acceleration',
            'max_forward_acceleration', 'switching_speed', 'max_braking', 'max_jerk', 'max_speed')
LENGTHS = ('car', 'van', 'truck')
# The row of limits of each class; for cars and trucks, row_of() also uses the length.
ROWS = {'car': 'car', 'truck': 'truck', 'bus': 'bus', 'construction_vehicle': 'construction',
        'emergency_vehicle': 'van', 'motorcycle': 'motorcycle', 'bicycle': 'bicycle', 'pedestrian': 'pedestrian',
        'child': 'child', 'runner': 'runner', 'scooter': 'scooter'}


class BadInput(Exception):
    """The input is invalid; the message names file, line or field, and value."""


def read_yaml(path):
    try:
        return yaml.safe_load(path.read_text(encoding='utf-8'))
    except yaml.YAMLError as error:
        raise BadInput('{}: {}'.format(path, error)) from None


def merged(below, above):
    """Return the configuration `below` with the keys of the overlay `above` replaced."""
    both = dict(below)
    for key, value in above.items():
        both[key] = merged(below[key], value) if isinstance(value, dict) and isinstance(below.get(key), dict) else value
    return both


def section_of(path, parent, name, keys):
    """Return a section; raise BadInput unless each of its `keys` is a positive finite number."""
    section = parent.get(name) if isinstance(parent, dict) else None
    if not isinstance(section, dict):
        raise BadInput('{}: {} is missing'.format(path, name))
    for key in keys:
        value = section.get(key)
        if not isinstance(value, (int, float)) or not 0.0 < value < math.inf:
            raise BadInput('{}: {}.{} is missing or not positive'.format(path, name, key))
    return section


class VehicleLimits:
    """config/vehicle_limits.yaml: the drivable limits by class."""

    def __init__(self, config=CONFIG):
        path = config / 'vehicle_limits.yaml'
        overlay = read_yaml(path) if path.exists() else {}
        root = section_of(path, merged(read_yaml(CONFIG / path.name), overlay), 'vehicle_limits', ('max_reverse_speed',))
        self.lengths = section_of(path, root, 'lengths', LENGTHS)
        drivable = section_of(path, root, 'drivable', ())
        rows = sorted(set(ROWS.values()) | {'van', 'articulated'})
        self.drivable = {row: dict(section_of(path, drivable, row, DRIVABLE),
                                   max_reverse_speed=root['max_reverse_speed']) for row in rows}

    def row_of(self, attacker):
        """Return the name of an attacker's row of limits, by class and length."""
        name, length = attacker.get('class'), attacker['length']
        if name is None:
            raise BadInput('the attacker has no class, so its limits are unknown')
        if name not in ROWS:
            raise BadInput('there are no limits for the class "{}"'.format(name))
        if name == 'car' and length > self.lengths['car'] or name == 'truck' and length < self.lengths['van']:
            return 'van'
        if name == 'truck' and length > self.lengths['truck']:
            return 'articulated'
        return ROWS[name]


def refuse_constant(name):
    raise ValueError('{} is not a number'.format(name))


def read_scenarios(path):
    """Yield (place, scenario) of every line; the place names file and line."""
    with open(path, encoding='utf-8') as file:
        for number, line in enumerate(file, 1):
            where = '{}: line {}'.format(path, number)
            try:
                scenario = json.loads(line, parse_constant=refuse_constant)
                if scenario['format'] != 'collision_forge/scenario' or scenario['version'] not in VERSIONS:
                    raise ValueError('the format or version is not supported')
            except (ValueError, KeyError, TypeError) as error:
                raise BadInput('{}: no scenario: {}'.format(where, error)) from None
            yield where, scenario


def steps_to_contact(scenario):
    """Return the number of steps from t0 to the first sample at or after contact."""
    contact = scenario['report']['contact_t']
    points = scenario['attacker']['trajectory']
    return min(sum(point['t'] < contact for point in points), len(points) - 1)


def describe(scenario):
    """Return a description of the request for messages."""
    request = scenario['request']
    return '{} now {:.6f} {} tta {:g} {} seed {}'.format(scenario['scene'], scenario['now'], request['type'],
                                                         request['tta'], request['mode'], request['seed'])
