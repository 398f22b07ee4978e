#!/usr/bin/python3
"""scripts/ros_faults: responses that it counts as invalid, and one round of two kinds of fault."""
import socket
import subprocess
import sys
import unittest
from pathlib import Path

import rospy

from collision_forge import srv
from collision_forge.msg import CollisionAnswer, TrajectoryPoint

SCRIPTS = Path(__file__).resolve().parents[2] / 'scripts'
sys.path.insert(0, str(SCRIPTS))
from ros_faults_road import LAST_CODE, OK, Failure, check  # noqa: E402

TIMEOUT = 400.0  # s; a round takes half a minute
NO_CANDIDATE = 6


def free_port():
    with socket.socket() as one:
        one.bind(('localhost', 0))
        return one.getsockname()[1]


def run(*arguments):
    return subprocess.run([str(SCRIPTS / 'ros_faults'), '--port', str(free_port()), '--seed', '1', *arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
                          universal_newlines=True, timeout=TIMEOUT, check=False)


def answers_of(code, stamp=5, verified=True, x=0.0):
    """An answer at 5 s with one collision of that code, and what there is of an attack."""
    one = CollisionAnswer(code=code)
    if code == OK:
        one.attack.header.stamp, one.attack.report.verified = rospy.Time(stamp), verified
        one.attack.trajectory.points = [TrajectoryPoint()]
        one.attack.trajectory.points[0].pose.position.x = x
    return srv.GenerateCollisionsResponse(answers=[one], now=rospy.Time(5), code=OK)


class CheckTest(unittest.TestCase):
    def test_attacks_and_refusals_make_sense(self):
        check(answers_of(OK))
        check(answers_of(NO_CANDIDATE))
        check(srv.GenerateCollisionsResponse(code=LAST_CODE, message='why'))

    def test_nonsense_is_found(self):
        for answer in (answers_of(OK, stamp=4), answers_of(OK, verified=False), answers_of(OK, x=float('nan')),
                       answers_of(LAST_CODE + 1), srv.GenerateCollisionsResponse(code=LAST_CODE)):
            self.assertRaises(Failure, check, answer)


class RoundTest(unittest.TestCase):
    def check(self, *arguments):
        result = run('--rounds', '1', *arguments)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(result.stdout.splitlines()[0], 'seed 1')
        self.assertEqual(result.stdout.splitlines()[-1], '1 rounds, 0 failures')

    def test_a_launch_ends_when_its_master_was_started_anew(self):
        self.check('--kind', 'master', '--nodelets', 'true')


if __name__ == '__main__':
    unittest.main()
