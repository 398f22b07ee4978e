#!/usr/bin/python3
"""usage: commonroad_checks.py FOLDER: what commonroad-io reads in the .xml of a folder, in an environment that has it.

Prints one JSON a file. "rewritten": written by commonroad-io and read again it is the same. "schema": what is wrong but
for initial states that are later than step 0. "touching": the steps at which ego and attacker touch by the collision
checker of commonroad-drivability-checker, null without that or without an ego.
"""
import contextlib
import json
import os
import sys
import tempfile
from pathlib import Path

import commonroad
from commonroad.common.file_reader import CommonRoadFileReader
from commonroad.common.file_writer import CommonRoadFileWriter, OverwriteExistingFile
from commonroad.common.util import FileFormat
from lxml import etree

try:
    from commonroad_dc import pycrcc
except ImportError:
    pycrcc = None

DECIMALS = 9
EGO, ATTACKER = 1, 2


def contents_of(scenario, problems):
    """Return the compared parts of a scenario, which itself also holds the time at which it was read."""
    return [scenario.dt, scenario.scenario_id, scenario.tags, scenario.lanelet_network.lanelets,
            scenario.static_obstacles, scenario.dynamic_obstacles, problems]


def is_rewritten(scenario, problems):
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(sys.stderr):
        path = os.path.join(folder, 'again.xml')
        writer = CommonRoadFileWriter(scenario, problems, decimal_precision=DECIMALS, file_format=FileFormat.XML)
        writer.write_to_file(path, OverwriteExistingFile.ALWAYS)
        return contents_of(*CommonRoadFileReader(path).open()) == contents_of(scenario, problems)


def schema_errors(path):
    """Return the schema's errors; None if this release of commonroad-io has no schema."""
    file = Path(commonroad.__file__).parent / 'common' / 'xml_definition_files' / 'XML_commonRoad_XSD.xsd'
    if not file.exists():
        return None
    tree = etree.parse(str(path))
    for step in tree.iterfind('.//initialState/time/exact'):
        step.text = '0'
    schema = etree.XMLSchema(etree.parse(str(file)))
    schema.validate(tree)
    return [str(error) for error in schema.error_log]


def obstacle_of(scenario, number):
    return next((obstacle for obstacle in scenario.dynamic_obstacles if obstacle.obstacle_id == number), None)


def states_of(obstacle):
    return [obstacle.initial_state, *obstacle.prediction.trajectory.state_list]


def boxes_of(obstacle):
    half = [extent / 2 for extent in (obstacle.obstacle_shape.length, obstacle.obstacle_shape.width)]
    return {state.time_step: pycrcc.RectOBB(*half, state.orientation, *map(float, state.position))
            for state in states_of(obstacle)}


def touching_steps(scenario):
    ego, attacker = (obstacle_of(scenario, number) for number in (EGO, ATTACKER))
    if pycrcc is None or ego is None:
        return None
    places, others = boxes_of(ego), boxes_of(attacker)
    return [step for step in sorted(places) if step in others and places[step].collide(others[step])]


def findings(path):
    scenario, problems = CommonRoadFileReader(str(path)).open()
    problem, = problems.planning_problem_dict.values()
    goal = problem.goal.state_list[0]
    ego = obstacle_of(scenario, EGO)
    return {'file': path.name, 'dt': scenario.dt, 'benchmark': str(scenario.scenario_id),
            'tags': sorted(tag.value for tag in scenario.tags),
            'lanelets': len(scenario.lanelet_network.lanelets), 'static': len(scenario.static_obstacles),
            'dynamic': {obstacle.obstacle_id: [state.time_step for state in states_of(obstacle)]
                        for obstacle in scenario.dynamic_obstacles},
            'begin': problem.initial_state.time_step, 'end': goal.time_step.end,
            'reached': None if ego is None else bool(problem.goal.is_reached(states_of(ego)[-1])),
            'rewritten': is_rewritten(scenario, problems), 'schema': schema_errors(path),
            'touching': touching_steps(scenario)}


if __name__ == '__main__':
    for each in sorted(Path(sys.argv[1]).glob('*.xml')):
        print(json.dumps(findings(each)))
