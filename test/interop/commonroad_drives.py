#!/usr/bin/python3
"""usage: commonroad_drives.py COUNT FILE...: CommonRoad's reactive planner drives planning problems.

Runs in an environment with commonroad-reactive-planner. Prints one JSON a file until COUNT problems are driven to the
end of their time: {"file": name, "driven": steps driven, "wanted": steps from the initial state to the goal}. The
planner follows the straightest lanelets from the initial state on, keeps its speed and replans every three steps.
"""
import json
import logging
import math
import sys
import warnings
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from commonroad.common.file_reader import CommonRoadFileReader
from commonroad_rp.reactive_planner import ReactivePlanner
from commonroad_rp.utility.config import ReactivePlannerConfiguration
from commonroad_rp.utility.utils_coordinate_system import create_coordinate_system

EGO = 1  # id of the recorded ego
REPLAN = 3  # steps
HORIZON = 30  # steps of a plan
LEVELS = 3  # of ever more samples
AHEAD = 150.0  # m of the reference path
SPACING = 1.0  # m between its points
BEYOND = 100.0  # m by which its ends are extended: the planner needs places beside all of its motion


def heading(a, b):
    return math.atan2(b[1] - a[1], b[0] - a[0])


def turn(a, b):
    return abs(math.remainder(b - a, 2 * math.pi))


def reference_path(network, state):
    """The centres of the straightest lanelets from an initial state on."""
    found = network.find_lanelet_by_position([state.position])[0]
    at = lambda lanelet: int(np.argmin(np.linalg.norm(lanelet.center_vertices[:-1] - state.position, axis=1)))  # noqa
    lanelets = [network.find_lanelet_by_id(number) for number in found]
    lanelet = min(lanelets, default=None, key=lambda one: turn(
        state.orientation, heading(*one.center_vertices[at(one):at(one) + 2])))
    if lanelet is None:
        return None
    points = list(lanelet.center_vertices)
    while lanelet.successor and np.linalg.norm(np.diff(points, axis=0), axis=1).sum() < AHEAD:
        last = heading(*points[-2:])
        nexts = [network.find_lanelet_by_id(number) for number in lanelet.successor]
        lanelet = min(nexts, key=lambda one: turn(last, heading(*one.center_vertices[-2:])))
        points += list(lanelet.center_vertices[1:])
    ends = [points[0] - points[1], points[-1] - points[-2]]
    begin, end = (BEYOND * end / np.linalg.norm(end) for end in ends)
    points = np.array([points[0] + begin, *points, points[-1] + end])
    along = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))))
    places = np.arange(0.0, along[-1], SPACING)
    return np.column_stack([np.interp(places, along, points[:, axis]) for axis in (0, 1)])


def planner_of(scenario, problem, path):
    config = ReactivePlannerConfiguration()
    config.planning.dt = scenario.dt
    config.planning.time_steps_computation = HORIZON
    config.planning.planning_horizon = HORIZON * scenario.dt
    config.sampling.num_sampling_levels = LEVELS
    config.debug.multiproc = False
    config.debug.logging_level = 'ERROR'
    config.update(scenario=scenario, planning_problem=problem)
    planner = ReactivePlanner(config)
    planner.set_reference_path(coordinate_system=create_coordinate_system(path))
    return planner


def drive(planner, last):
    """Drive up to the step `last`; return the step that is reached."""
    while planner.x_0.time_step < last:
        planner.set_desired_velocity(current_speed=planner.x_0.velocity)
        plan = planner.plan()
        if not plan:
            break
        step = min(REPLAN, last - planner.x_0.time_step)
        state = plan[0].state_list[step]
        state.time_step = planner.x_0.time_step + step
        planner.reset(initial_state_cart=state, initial_state_curv=(plan[1][step], plan[2][step]),
                      collision_checker=planner.collision_checker, coordinate_system=planner.coordinate_system)
    return planner.x_0.time_step


def findings(path):
    scenario, problems = CommonRoadFileReader(str(path)).open()
    ego = scenario.obstacle_by_id(EGO)
    if ego is not None:  # the recorded ego, whose place the planner takes
        scenario.remove_obstacle(ego)
    problem, = problems.planning_problem_dict.values()
    begin, last = problem.initial_state.time_step, problem.goal.state_list[0].time_step.end
    # commonroad-io does not read the yaw rate.
    problem.initial_state.yaw_rate = float(ElementTree.parse(path).findtext('planningProblem//yawRate/exact'))
    reference = reference_path(scenario.lanelet_network, problem.initial_state)
    reached = begin if reference is None else drive(planner_of(scenario, problem, reference), last)
    return {'file': path.name, 'driven': reached - begin, 'wanted': last - begin}


def main(count, paths):
    logging.disable(logging.CRITICAL)
    warnings.simplefilter('ignore')
    done = 0
    for path in paths:
        found = findings(Path(path))
        print(json.dumps(found), flush=True)
        done += found['driven'] == found['wanted']
        if done == count:
            break


if __name__ == '__main__':
    main(int(sys.argv[1]), sys.argv[2:])
