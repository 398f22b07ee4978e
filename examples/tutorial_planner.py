#!/usr/bin/python3
"""Planner of the tutorial: follows the route and keeps its distance from agents on it."""
import math

import rospy
from collision_forge.msg import PlannedTrajectory, PlanningState, TrajectoryPoint

INSTANTS = [0.0]  # s from now at which other agents are checked
WIDTH = 1.5       # m to either side of the route that must be free


def project(route, x, y):
    """Return the distance along the route and the offset to its left, in m."""
    along, best = 0.0, (math.inf, 0.0, 0.0)
    for here, following in zip(route, route[1:]):
        dx, dy, sine, cosine = x - here.x, y - here.y, math.sin(here.theta), math.cos(here.theta)
        best = min(best, (math.hypot(dx, dy), along + dx * cosine + dy * sine, dy * cosine - dx * sine))
        along += math.hypot(following.x - here.x, following.y - here.y)
    return best[1:]


def pose_at(route, along):
    """Return x, y and yaw of the point of the route at this distance."""
    for here, following in zip(route, route[1:]):
        length = math.hypot(following.x - here.x, following.y - here.y)
        if along < length:
            break
        along -= length
    return here.x + along * math.cos(here.theta), here.y + along * math.sin(here.theta), here.theta


def blocks_route(route, agent):
    points = [project(route, agent.pose.x + t * agent.velocity_x, agent.pose.y + t * agent.velocity_y)
              for t in INSTANTS]
    return any(abs(left) < WIDTH for _, left in points)


def acceleration(state, ego_along, speed):
    """Up to 10 m/s; 2 m and 1.5 s behind the agent ahead."""
    interaction = (speed / 10.0) ** 4
    for track in state.agents:
        agent = track.states[-1]
        ahead = project(state.route, agent.pose.x, agent.pose.y)[0] - ego_along
        if ahead > 0.0 and blocks_route(state.route, agent):
            gap = max(1.0, ahead - (track.size.x + state.ego_size.x) / 2)
            closing = speed - math.hypot(agent.velocity_x, agent.velocity_y)
            desired_gap = 2.0 + max(0.0, 1.5 * speed + speed * closing / 5.0)
            interaction = max(interaction, (desired_gap / gap) ** 2)
    return max(-8.0, 1.5 * (1.0 - interaction))


def plan(state):
    along, _ = project(state.route, state.ego.pose.position.x, state.ego.pose.position.y)
    speed = max(0.0, state.ego.speed)
    change = acceleration(state, along, speed)
    trajectory = PlannedTrajectory(header=state.header, test=state.test, points=[state.ego])
    for step in range(1, 41):  # 4 s
        speed = max(0.0, speed + 0.1 * change)
        along += 0.1 * speed
        point = TrajectoryPoint(stamp=state.header.stamp + rospy.Duration(0.1 * step), speed=speed)
        point.pose.position.x, point.pose.position.y, yaw = pose_at(state.route, along)
        point.pose.orientation.z, point.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        trajectory.points.append(point)
    return trajectory


rospy.init_node('my_planner')
publisher = rospy.Publisher('planned_trajectory', PlannedTrajectory, queue_size=1, tcp_nodelay=True)
rospy.Subscriber('planning_state', PlanningState, lambda state: publisher.publish(plan(state)), tcp_nodelay=True)
rospy.spin()
