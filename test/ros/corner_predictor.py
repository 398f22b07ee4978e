#!/usr/bin/python3
"""A pattern predictor in its own node: the first vehicle hits the ego's left rear corner with its right front corner.
All agents are predicted straight on."""
import math

import rospy

from collision_forge.msg import Agent, AgentTrack, CollisionPattern, Future, TrackState
from collision_forge.srv import PredictPattern, PredictPatternResponse
from geometry_msgs.msg import Pose2D

HEADING = -0.25  # rad, of the attacker seen from the ego
TAIL = 2.5       # s foretold beyond the impact
STEP = 0.5       # s
SPEED = 12.0     # m/s of the attacker at the impact


def straight_on(track, seconds):
    now = track.states[-1]
    ahead = AgentTrack(id=track.id, agent_class=track.agent_class, size=track.size)
    for i in range(int(seconds / STEP) + 1):
        state = TrackState(stamp=now.stamp + rospy.Duration(i * STEP), velocity_x=now.velocity_x, velocity_y=now.velocity_y)
        state.pose = Pose2D(now.pose.x + i * STEP * now.velocity_x, now.pose.y + i * STEP * now.velocity_y, now.pose.theta)
        ahead.states.append(state)
    return ahead


def left_rear_corner(ego, attacker):
    """Return the attacker's centre in the frame of the ego's centre."""
    cosine, sine = math.cos(HEADING), math.sin(HEADING)
    along, across = 0.5 * attacker.x, -0.5 * attacker.y  # its right front corner
    return Pose2D(-0.5 * ego.x - (along * cosine - across * sine), 0.5 * ego.y - (along * sine + across * cosine), HEADING)


def predict(message):
    tta = message.request.tta
    future = Future(ego=straight_on(message.scene.ego, tta + TAIL),
                    agents=[straight_on(track, tta + TAIL) for track in message.scene.agents])
    attacker = next(track for track in message.scene.agents if track.agent_class == Agent.CAR)
    now = message.scene.ego.states[-1]
    pattern = CollisionPattern(header=message.scene.header, collision_type=message.request.collision_type,
                               attacker_id=attacker.id, tta=tta, ego_size=message.scene.ego.size, attacker_speed=SPEED)
    pattern.ego = Pose2D(now.pose.x + tta * now.velocity_x, now.pose.y + tta * now.velocity_y, now.pose.theta)
    pattern.attacker_offset = left_rear_corner(message.scene.ego.size, attacker.size)
    return PredictPatternResponse(patterns=[pattern], future=future)


if __name__ == '__main__':
    rospy.init_node('corner_predictor')
    rospy.Service('predict_pattern', PredictPattern, predict)
    rospy.spin()
