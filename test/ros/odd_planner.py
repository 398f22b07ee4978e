#!/usr/bin/python3
"""usage: odd_planner.py MODE: an external planner that drives straight on: valid plans for five steps, then faults.

MODE after the valid plans: straight: no fault; never: no response; dies: exits; nan: a coordinate is NaN; empty: no
points; unfilled: an invalid orientation; far: a point far away; many: too many points; late: the stamp of the previous
step; stranger: first an empty plan of another test, then the valid one. At the first step: twice: publishes the plan
twice; deaf: ignores the state until it is repeated.
"""
import math
import os
import sys

import rospy

from collision_forge.msg import PlannedTrajectory, PlanningState, TrajectoryPoint
from geometry_msgs.msg import Quaternion

GOOD_TICKS = 5
mode = sys.argv[1]
states = []


def straight(state):
    yaw = 2.0 * math.atan2(state.ego.pose.orientation.z, state.ego.pose.orientation.w)
    answer = PlannedTrajectory(header=state.header, test=state.test, points=[state.ego])
    for step in range(1, 41):
        point = TrajectoryPoint(stamp=state.header.stamp + rospy.Duration(0.1 * step), speed=state.ego.speed)
        point.pose.position.x = state.ego.pose.position.x + 0.1 * step * state.ego.speed * math.cos(yaw)
        point.pose.position.y = state.ego.pose.position.y + 0.1 * step * state.ego.speed * math.sin(yaw)
        point.pose.orientation = state.ego.pose.orientation
        answer.points.append(point)
    return answer


def answers(state):
    is_repeated = bool(states) and states[-1].header.stamp == state.header.stamp
    if not is_repeated:
        states.append(state)
    answer = straight(state)
    if mode == 'twice' and len(states) == 1:
        return [answer, answer]
    if mode == 'deaf' and len(states) == 1 and not is_repeated:
        return []
    if len(states) <= GOOD_TICKS:
        return [answer]
    if mode == 'never':
        return []
    if mode == 'dies':
        os._exit(1)
    if mode == 'nan':
        answer.points[3].pose.position.y = math.nan
    if mode == 'empty':
        answer.points = []
    if mode == 'far':
        answer.points[3].pose.position.x = 1e9
    if mode == 'many':
        answer.points += 5000 * [answer.points[-1]]
    if mode == 'unfilled':
        answer.points[3].pose.orientation = Quaternion()
    if mode == 'late':
        answer.header = states[-2].header
    if mode == 'stranger':
        other = straight(state)
        other.test -= 1
        other.points = []
        return [other, answer]
    return [answer]


rospy.init_node('odd_planner')
publisher = rospy.Publisher('planned_trajectory', PlannedTrajectory, queue_size=10, tcp_nodelay=True)
rospy.Subscriber('planning_state', PlanningState, lambda state: [publisher.publish(answer) for answer in answers(state)],
                 tcp_nodelay=True)
rospy.spin()
