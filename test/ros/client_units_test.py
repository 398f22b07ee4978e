#!/usr/bin/python3
"""The Python client's data, errors and programs, without a master."""
import math
import os
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import road
from collision_forge import (Answer, Attack, Code, Declined, Effect, ForgeError, NotReady, PlannerOutcome,
                             Report, Scene, msg, srv)
from collision_forge.controls import control_fields, fields_of
from collision_forge.results import Pose
from collision_forge.suite import Program
from collision_forge.waiting import wait_until
from genpy import Duration, Time

NOW = Time(1600000000, 500000000)


def at(seconds):
    return NOW + Duration.from_sec(seconds)


def report_message(**fields):
    message = msg.CollisionReport(
        attacker_id='ann', verified=True, contact=True, contact_time=at(3.5), ego_side='left', impact_speed=2.5,
        manoeuvre='cut_in', manoeuvre_begin=at(1.5), confidence=0.25)
    message.header.stamp = NOW
    message.ego_at_contact.x, message.attacker_at_contact.theta = 7.0, 0.5
    for name, value in fields.items():
        setattr(message, name, value)
    return message


def attack_message(**fields):
    message = msg.Attack(report=report_message(), method='search', **fields)
    message.header.stamp = NOW
    message.pattern.collision_type = 'lane_change'
    message.trajectory.attacker_id, message.trajectory.agent_class = 'ann', msg.Agent.TRUCK
    point = msg.TrajectoryPoint(stamp=at(0.1), speed=4.0)
    point.pose.orientation.z, point.pose.orientation.w = math.sin(0.6), math.cos(0.6)
    message.trajectory.points = [point]
    return message


def constants(response):
    return {name: value for name, value in vars(response).items() if name.isupper() and isinstance(value, int)}


class ErrorsTest(unittest.TestCase):
    def test_codes_are_those_of_the_services(self):
        expected = {**constants(srv.GenerateCollisionResponse), **constants(srv.TestPlannerResponse)}
        self.assertEqual({code.name: code.value for code in Code}, expected)

    def test_a_rejection_has_code_and_reason(self):
        refusal = Declined(6, 'nobody there')
        self.assertIs(refusal.code, Code.NO_CANDIDATE)
        self.assertEqual((refusal.reason, str(refusal)), ('nobody there', 'NO_CANDIDATE: nobody there'))
        self.assertIsInstance(refusal, ForgeError)

    def test_a_time_out_names_the_missing_parts(self):
        with self.assertRaises(NotReady) as raised:
            wait_until(lambda: ['a spoon', 'a fork'], 0.1)
        self.assertEqual(raised.exception.missing, ['a spoon', 'a fork'])
        self.assertEqual(str(raised.exception), 'waited 0.1 s in vain for a spoon; a fork')


class NoMasterTest(unittest.TestCase):
    """Without a master the client raises an error of one line that names the command to start one."""

    def said_at(self, uri):
        environment = {**os.environ, 'ROS_MASTER_URI': uri}
        said = subprocess.run(['/usr/bin/python3', '-c', 'from collision_forge import CollisionForge; CollisionForge()'],
                              env=environment, stderr=subprocess.PIPE, universal_newlines=True, timeout=60, check=False)
        self.assertNotEqual(said.returncode, 0)
        self.assertNotIn('xmlrpc', said.stderr)
        return said.stderr.splitlines()[-1]

    def test_names_the_address_and_what_to_start(self):
        for uri in ('http://localhost:1', 'nonsense'):
            line = self.said_at(uri)
            self.assertIn('no ROS master answers at ROS_MASTER_URI = ' + uri, line)
            self.assertIn('roslaunch collision_forge', line)

    def test_a_hanging_master_times_out(self):
        with socket.socket() as silent:
            silent.bind(('localhost', 0))
            silent.listen(1)
            self.assertIn('timed out', self.said_at('http://localhost:{}'.format(silent.getsockname()[1])))


class ControlsTest(unittest.TestCase):
    def test_controls_cover_all_fields_of_a_request(self):
        beside = {'collision_type', 'tta'}
        self.assertEqual(set(control_fields()), set(msg.CollisionRequest.__slots__) - beside)
        beside |= {'stamp', 'adaptive', 'method', 'alternative', 'name', 'text'}
        self.assertEqual(set(control_fields()), set(srv.GenerateCollisionRequest.__slots__) - beside)

    def test_ranges_and_booleans(self):
        fields = control_fields(impact_speed=(2, 5), overlap=(0.1, 0.4), believable=False)
        self.assertEqual((fields['min_impact_speed'], fields['max_impact_speed']), (2, 5))
        self.assertEqual((fields['min_overlap'], fields['max_overlap']), (0.1, 0.4))
        self.assertEqual(fields['believable'], 'false')
        self.assertEqual(control_fields(believable=True)['believable'], 'true')
        self.assertEqual(control_fields()['believable'], '')


class ResultsTest(unittest.TestCase):
    def test_numbers_are_shown_to_three_decimals(self):
        self.assertEqual(repr(Pose(1.23456, 2.0, -0.0004)), 'Pose(x=1.235, y=2.0, yaw=-0.0)')

    def test_a_report_counts_from_now(self):
        report = Report.of(report_message())
        self.assertEqual((report.now, report.attacker, report.verified), (NOW, 'ann', True))
        self.assertAlmostEqual(report.contact.t, 3.5)
        self.assertAlmostEqual(report.manoeuvre_begin, 1.5)
        self.assertEqual((report.contact.ego, report.contact.attacker), (Pose(7.0, 0.0, 0.0), Pose(0.0, 0.0, 0.5)))
        self.assertEqual(repr(report), '<Report verified: cut_in after 3.50 s on the left at 2.5 m/s>')

    def test_a_report_has_severity_and_careful_drivers(self):
        effect = msg.CrashEffect(delta_v=2.5, mais3=0.25, curve='a curve', most_class=2)
        report = Report.of(report_message(ego_effect=effect, careful_drivers=[
            msg.CarefulDrive(driver='cc_driver', avoids=True), msg.CarefulDrive(driver='rss')]))
        self.assertEqual(report.contact.ego_effect, Effect(2.5, 0.0, 0.0, 0.0, 0.25, 'a curve', 0, 2))
        self.assertEqual(report.avoided_by, ('cc_driver',))

    def test_an_attack(self):
        message, other = attack_message(), attack_message()
        attack = Attack.of(message, [other])
        self.assertEqual((attack.attacker, attack.attacker_class), ('ann', 'truck'))
        self.assertAlmostEqual(attack.trajectory[0].t, 0.1)
        self.assertIs(attack.message, message)
        self.assertEqual(attack.alternatives, (Attack.of(other),))
        self.assertEqual(repr(attack), '<Attack lane_change by truck ann: cut_in after 3.50 s on the left at 2.5 m/s, '
                                       'confidence 25 %>')

    def test_an_answer_has_an_attack_or_a_reason(self):
        self.assertEqual(Answer.of(msg.CollisionAnswer(collision_type='ltap', tta=4.0, attack=attack_message())).attack,
                         Attack.of(attack_message()))
        declined = Answer.of(msg.CollisionAnswer(collision_type='ltap', tta=4.0, code=6, message='nobody'))
        self.assertEqual((declined.code, declined.reason, declined.attack), (Code.NO_CANDIDATE, 'nobody', None))

    def test_an_outcome_with_contact(self):
        message = msg.PlannerOutcome(
            planner='idm', failure='none', collided=True, is_attacker=True, contact_time=at(4.25), other_id='ann',
            impact_speed=3.0, avoidable=True, last_manoeuvre='braking', last_moment=at(2.0), nuplan_score=0.5)
        message.header.stamp = NOW
        outcome = PlannerOutcome.of(message)
        self.assertTrue(outcome.hit)
        self.assertAlmostEqual(outcome.contact.t, 4.25)
        self.assertAlmostEqual(outcome.last_moment, 2.0)
        self.assertEqual(outcome.nuplan['score'], 0.5)
        self.assertEqual(len(outcome.nuplan), 8)
        self.assertEqual(outcome.summary(), 'touches the attacker ann after 4.25 s at 3.0 m/s, '
                                            'avoidable up to 2.0 s after t0 by braking')

    def test_an_outcome_says_how_a_hit_could_have_been_avoided(self):
        for manoeuvre, moment, policy, words in (
                ('braking', 0.0, 'fixed', 'avoidable at once by braking'),
                ('both', 2.5, 'fixed', 'avoidable up to 2.5 s after t0 by braking and steering'),
                ('keeping', 0.0, 'fixed', 'avoidable by driving as recorded'),
                ('keeping', 0.0, 'adaptive', 'avoidable by keeping its speed'),
                ('keeping', 1.5, 'adaptive', 'avoidable by keeping its speed from 1.5 s after t0 on')):
            message = msg.PlannerOutcome(failure='none', collided=True, is_attacker=True, avoidable=True,
                                         attacker_policy=policy, last_manoeuvre=manoeuvre, last_moment=at(moment))
            message.header.stamp = NOW
            self.assertTrue(PlannerOutcome.of(message).summary().endswith(', ' + words), words)

    def test_a_mistyped_control_is_named_with_those_that_are_known(self):
        with self.assertRaisesRegex(TypeError, "'manoeuver'; did you mean manoeuvre.*ego_side"):
            fields_of({'manoeuver': 'drift'})

    def test_a_malformed_range_is_named_with_its_value(self):
        with self.assertRaisesRegex(TypeError, r'impact_speed = 5.0 is not a pair \(least, greatest\)'):
            fields_of({'impact_speed': 5.0})

    def test_a_scene_contains_the_agents_present_at_t0(self):
        def track(name, stamp):
            return msg.AgentTrack(id=name, agent_class=msg.Agent.BUS,
                                  states=[msg.TrackState(stamp=stamp, velocity_x=3.0, velocity_y=4.0)])
        message = msg.EncodedScene()
        message.header.stamp = NOW
        message.snapshot.ego = track('ego', NOW)
        message.snapshot.agents = [track('gone', at(-0.5)), track('here', NOW)]
        scene = Scene.of(message)
        self.assertEqual([agent.id for agent in scene.agents], ['here'])
        self.assertEqual((scene.ego.speed, scene.agents[0].agent_class), (5.0, 'bus'))


def is_running(pid):
    try:
        return Path('/proc/{}/stat'.format(pid)).read_text().split()[2] != 'Z'
    except OSError:
        return False


class ProgramTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.log = Path(folder.name) / 'log'

    def test_stops_with_all_that_it_started(self):
        with Program(['bash', '-c', 'sleep 1000 & echo $!; wait'], self.log) as program:
            wait_until(lambda: [] if program.output().strip() else ['a process'], 10.0)
            child = int(program.output())
        wait_until(lambda: ['the end of the child'] if is_running(child) else [], 10.0)

    def test_ends_with_its_parent_process(self):
        starter = ('import pathlib, sys, time; from collision_forge.suite import Program; '
                   'program = Program(["bash", "-c", "echo $$; exec sleep 1000"], pathlib.Path(sys.argv[1])); '
                   'time.sleep(1000)')
        with subprocess.Popen(['/usr/bin/python3', '-c', starter, str(self.log)]) as process:
            wait_until(lambda: [] if self.log.exists() and self.log.read_text().strip() else ['a process'], 10.0)
            child = int(self.log.read_text())
            self.assertTrue(is_running(child))
            process.kill()
        wait_until(lambda: ['the end of the child'] if is_running(child) else [], 10.0)

    def test_error_contains_the_output_of_an_ended_program(self):
        program = Program(['bash', '-c', 'echo no luck; exit 3'], self.log)
        deadline = time.monotonic() + 10.0
        with self.assertRaisesRegex(ForgeError, 'no luck'):
            while time.monotonic() < deadline:
                program.check()
                time.sleep(0.05)
        program.stop()


if __name__ == '__main__':
    road.main()
