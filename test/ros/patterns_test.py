#!/usr/bin/python3
"""The attack realises the pattern of a predictor that runs in its own node."""
import math
import signal
import subprocess
import sys
from pathlib import Path

import live
import road
import rospy
from corner_predictor import left_rear_corner, predict
from made_up import MadeUpTest, agent, drive

from collision_forge.msg import Future
from collision_forge.srv import PredictPattern, RealizeTrajectory, RealizeTrajectoryRequest

NEAR = 0.3  # m


def beside(seconds):
    """Return a car in the left lane, a little behind the ego and faster."""
    return [agent('beside', -22.0 + 11.0 * seconds, 3.5)]


def seen_from(base, pose):
    """Return x, y and heading of `pose` in the frame of `base`."""
    dx, dy = pose.x - base.x, pose.y - base.y
    cosine, sine = math.cos(base.theta), math.sin(base.theta)
    return dx * cosine + dy * sine, dy * cosine - dx * sine, math.remainder(pose.theta - base.theta, math.tau)


class PatternsTest(MadeUpTest):
    ARGUMENTS = {'predictor': 'false'}

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.start_predictor()
        cls.addClassCleanup(cls.end_predictor)

    @classmethod
    def start_predictor(cls):
        cls.predictor = subprocess.Popen([sys.executable, str(Path(__file__).parent / 'corner_predictor.py')])
        live.until(lambda: ('/predict_pattern', 'corner_predictor') in live.graph()[2], 'the predictor')

    @classmethod
    def end_predictor(cls):
        cls.predictor.kill()
        cls.predictor.wait()

    def corner_miss(self, attack, size):
        """Return the distance (m) of the attacker's right front corner from the ego's left rear one at contact."""
        x, y, heading = seen_from(attack.report.ego_at_contact, attack.report.attacker_at_contact)
        along, across = 0.5 * attack.trajectory.size.x, -0.5 * attack.trajectory.size.y
        corner = (x + along * math.cos(heading) - across * math.sin(heading),
                  y + along * math.sin(heading) + across * math.cos(heading))
        return math.dist(corner, (-0.5 * size.x, 0.5 * size.y))

    def test_attack_names_the_pattern_and_how_far_the_contact_is_from_it(self):
        scene = self.show(drive(8, beside)).snapshot
        attack = self.ask_for_code('OK', 'lane_change', 4.0, believable='false').attack
        self.assertTrue(attack.report.verified)
        asked = left_rear_corner(scene.ego.size, attack.trajectory.size)
        self.assertAlmostEqual(attack.pattern.attacker_offset.x, asked.x, places=6)
        x, y, heading = seen_from(attack.report.ego_at_contact, attack.report.attacker_at_contact)
        self.assertAlmostEqual(attack.miss_distance, math.dist((x, y), (asked.x, asked.y)), places=6)
        self.assertAlmostEqual(attack.miss_heading, abs(heading - asked.theta), places=6)
        self.assertLess(self.corner_miss(attack, scene.ego.size), NEAR)

    def realize_exactly(self, change):
        """Call realize_trajectory with a changed pattern of the predictor; return the response."""
        scene = self.show(drive(8, beside)).snapshot
        request = RealizeTrajectoryRequest(scene=scene, exact=True)
        request.request.collision_type, request.request.tta, request.request.mode = 'lane_change', 4.0, 'history'
        request.request.believable = 'false'
        predicted = rospy.ServiceProxy('predict_pattern', PredictPattern)(scene, request.request, Future())
        request.patterns, request.future = predicted.patterns, predicted.future
        change(request.patterns[0])
        return rospy.ServiceProxy('realize_trajectory', RealizeTrajectory)(request)

    def test_contact_is_at_the_corner_that_is_asked_for_exactly(self):
        answer = self.realize_exactly(lambda pattern: None)
        self.assertEqual(road.CODES[answer.code], 'OK', answer.message)
        self.assertLess(answer.attack.miss_distance, NEAR)
        self.assertLess(self.corner_miss(answer.attack, answer.attack.pattern.ego_size), NEAR)

    def test_a_node_that_does_not_answer_is_asked_again_over_another_connection(self):
        self.show(drive(8, beside))
        self.ask_for_code('OK', 'lane_change', 4.0)
        self.predictor.send_signal(signal.SIGSTOP)
        self.addCleanup(self.start_predictor)
        self.addCleanup(self.end_predictor)
        another = rospy.Service('predict_pattern', PredictPattern, predict)
        self.addCleanup(another.shutdown)
        answer = live.ask('lane_change', 4.0)
        self.assertEqual(road.CODES[answer.code], 'OK', answer.message)


if __name__ == '__main__':
    live.main('patterns_test')
