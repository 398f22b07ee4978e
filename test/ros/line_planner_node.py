#!/usr/bin/python3
"""usage: line_planner_node.py COMMAND...: a planner node that plans with a process of the line protocol.

Ignores the states of a test until its map is there.
"""
import json
import math
import subprocess
import sys

import rospy

from collision_forge.msg import Agent, LaneMap, PlannedTrajectory, PlanningState, TrajectoryPoint

CLASSES = {value: name.lower() for name, value in vars(Agent).items() if name.isupper()}


def xy(points, origin):
    return [[origin.x + point.x, origin.y + point.y] for point in points]


def polygons(areas, origin):
    return [{'exterior': xy(area.exterior.points, origin),
             'holes': [{'exterior': xy(hole.points, origin)} for hole in area.holes]} for area in areas]


def begin_of(state, road):
    return {'interval': state.interval, 'wheelbase': state.wheelbase,
            'ego': {'length': state.ego_size.x, 'width': state.ego_size.y, 'center_offset': state.center_offset},
            'route': [[pose.x, pose.y] for pose in state.route],
            'driving_side': 'left' if road.driving_side == LaneMap.DRIVE_LEFT else 'right',
            'lanes': [{'id': lane.id, 'connector': lane.is_connector, 'intersection': lane.is_intersection,
                       'centerline': [[pose.x, pose.y, pose.theta] for pose in lane.centerline],
                       'outline': xy(lane.polygon.points, road.origin), 'predecessors': lane.incoming,
                       'successors': lane.outgoing, 'speed_limit': lane.speed_limit or None} for lane in road.lanes],
            'drivable_area': polygons(road.drivable_area, road.origin),
            'walkways': polygons(road.walkways, road.origin)}


def plan_of(state):
    ego, place = state.ego, state.ego.pose
    yaw = 2.0 * math.atan2(place.orientation.z, place.orientation.w)
    return {'ego': [[ego.stamp.to_sec(), place.position.x, place.position.y, yaw, ego.speed, ego.acceleration,
                     ego.curvature]],
            'agents': [{'id': agent.id, 'class': CLASSES[agent.agent_class], 'length': agent.size.x,
                        'width': agent.size.y,
                        'states': [[at.stamp.to_sec(), at.pose.x, at.pose.y, at.pose.theta, at.velocity_x,
                                    at.velocity_y] for at in agent.states]} for agent in state.agents],
            'red_lanes': state.red_lanes}


def point_of(row):
    time, x, y, yaw, speed, acceleration, curvature = row
    point = TrajectoryPoint(stamp=rospy.Time.from_sec(time), speed=speed, acceleration=acceleration,
                            curvature=curvature)
    point.pose.position.x, point.pose.position.y = x, y
    point.pose.orientation.z, point.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return point


class LinePlannerNode:
    def __init__(self, command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        universal_newlines=True)
        self.process.stdout.readline()
        self.road, self.test = LaneMap(), None
        self.publisher = rospy.Publisher('planned_trajectory', PlannedTrajectory, queue_size=1, tcp_nodelay=True)
        rospy.Subscriber('tested_map', LaneMap, self.take_map, tcp_nodelay=True)
        rospy.Subscriber('planning_state', PlanningState, self.answer, tcp_nodelay=True)

    def take_map(self, road):
        self.road = road

    def ask(self, request):
        self.process.stdin.write(json.dumps(request) + '\n')
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def answer(self, state):
        if state.test != self.test:
            if self.road.header.stamp != state.header.stamp:
                return
            self.ask({'begin': begin_of(state, self.road)})
            self.test = state.test
        rows = self.ask({'plan': plan_of(state)})['points']
        self.publisher.publish(PlannedTrajectory(header=state.header, test=state.test,
                                                 points=[point_of(row) for row in rows]))


rospy.init_node('line_planner_node')
node = LinePlannerNode(sys.argv[1:])
rospy.spin()
