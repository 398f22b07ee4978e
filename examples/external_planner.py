#!/usr/bin/python3
"""External planner node: follows the route and the nearest agent on it with the intelligent driver model."""
import math

import rospy
from collision_forge.msg import PlannedTrajectory, PlanningState, TrajectoryPoint

SPEED, HEADWAY, MIN_GAP, ACCELERATION, BRAKING, MAX_BRAKING = 10.0, 1.5, 2.0, 1.5, 4.0, 8.0  # m/s, s, m, m/s2
STEPS, STEP, CORRIDOR = 40, 0.1, 2.0  # number of steps; s; half width in m around the route


def project(route, pose):
    """Project a pose on the route: index of the nearest point, longitudinal and absolute lateral offset (m)."""
    index = min(range(len(route)), key=lambda i: math.hypot(route[i].x - pose.x, route[i].y - pose.y))
    dx, dy, yaw = pose.x - route[index].x, pose.y - route[index].y, route[index].theta
    return index, dx * math.cos(yaw) + dy * math.sin(yaw), abs(dy * math.cos(yaw) - dx * math.sin(yaw))


def pose_ahead(route, index, distance):
    """Return x, y, yaw at `distance` m after route point `index`."""
    while index + 2 < len(route):
        length = math.hypot(route[index + 1].x - route[index].x, route[index + 1].y - route[index].y)
        if distance < length:
            break
        index, distance = index + 1, distance - length
    yaw = math.atan2(route[index + 1].y - route[index].y, route[index + 1].x - route[index].x)
    return route[index].x + distance * math.cos(yaw), route[index].y + distance * math.sin(yaw), yaw


def acceleration(state, speed, here):
    wanted = (speed / SPEED) ** 4
    for agent in state.agents:
        pose, velocity = agent.states[-1].pose, agent.states[-1]
        index, _, aside = project(state.route, pose)
        gap = math.hypot(pose.x - here.x, pose.y - here.y) - (agent.size.x + state.ego_size.x) / 2
        if aside < CORRIDOR and index > project(state.route, here)[0]:
            closing = speed - velocity.velocity_x * math.cos(pose.theta) - velocity.velocity_y * math.sin(pose.theta)
            wish = MIN_GAP + max(0.0, speed * HEADWAY + speed * closing / (2 * math.sqrt(ACCELERATION * BRAKING)))
            wanted = max(wanted, (speed / SPEED) ** 4 + (wish / max(gap, 0.1)) ** 2)
    return max(-MAX_BRAKING, ACCELERATION * (1 - wanted))


def plan(state):
    here, speed = state.ego.pose.position, max(0.0, state.ego.speed)
    index, distance, _ = project(state.route, here)
    change = acceleration(state, speed, here)
    answer = PlannedTrajectory(header=state.header, test=state.test, points=[state.ego])
    for step in range(1, STEPS + 1):
        point = TrajectoryPoint(stamp=state.header.stamp + rospy.Duration(step * STEP), acceleration=change)
        distance, speed = distance + speed * STEP, max(0.0, speed + change * STEP)
        point.pose.position.x, point.pose.position.y, yaw = pose_ahead(state.route, index, distance)
        point.pose.orientation.z, point.pose.orientation.w, point.speed = math.sin(yaw / 2), math.cos(yaw / 2), speed
        answer.points.append(point)
    return answer


rospy.init_node('external_planner')
publisher = rospy.Publisher('planned_trajectory', PlannedTrajectory, queue_size=1, tcp_nodelay=True)
rospy.Subscriber('planning_state', PlanningState, lambda state: publisher.publish(plan(state)), tcp_nodelay=True)
rospy.spin()
