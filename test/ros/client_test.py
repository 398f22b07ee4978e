#!/usr/bin/python3
"""The Python client with the real nodes."""
import math
import os
import subprocess
import threading
import time
import unittest.mock

import rospy
from rosgraph_msgs.msg import Clock

import live
import road
from collision_forge import Attack, Code, CollisionForge, Declined, ForgeError, NotReady
from collision_forge.suite import Suite
from collision_forge.waiting import wait_until

SCENE, TYPE, NOW, TTA = 'scene-0007', 'lane_change', 4.0, 4.0
TIMEOUT = 60.0  # s
IN_A_NAMESPACE = """
import rospy
from collision_forge import CollisionForge
forge = CollisionForge(60.0)
forge.play('{bag}').until({now})
attack = forge.generate('{type}', {tta})
print(rospy.resolve_name('generate_collision'), forge.tested(attack).contact is not None)
"""


class ClientTest(road.RoadTest):
    SCENES = [SCENE]

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.refused = cls.refusal()
        cls.suite = Suite(cls.folder, cls.folder / (SCENE + '.bag'))
        cls.addClassCleanup(cls.suite.stop)

    @staticmethod
    def refusal():
        """Return the error of the client while the suite is missing."""
        try:
            CollisionForge(timeout=0.3)
        except NotReady as error:
            return error
        raise AssertionError('ready without a suite')

    def setUp(self):
        self.suite.check()
        self.forge = CollisionForge(TIMEOUT)
        self.addCleanup(self.forge.close)
        self.forge.reset()

    def play(self, instant=NOW):
        return self.forge.play(self.bag(SCENE)).until(instant)

    def offline(self, *arguments, tta=TTA):
        out = self.path('offline.bag')
        result = road.inject(self.bag(SCENE), out, TYPE, tta, NOW, *(arguments or ('--mode', 'history')))
        self.assertEqual(road.code_of(result), 'OK')
        return road.read_one(out, '/attack'), road.read_one(out, '/tested_report')

    # Readiness.

    def test_says_which_services_are_missing(self):
        for name in ('generate_collision', 'list_collisions', 'generate_collisions', 'test_planner', 'reset'):
            self.assertIn('the service ' + name, self.refused.missing)

    def test_says_which_sources_are_missing(self):
        with CollisionForge(TIMEOUT) as fresh:
            with self.assertRaises(NotReady) as raised:
                fresh.wait_until_ready(0.3)
            self.assertEqual(raised.exception.missing,
                             ['a publisher of ' + topic for topic in ('agents', 'lane_map', '/tf', '/clock')])
            fresh.play(self.bag(SCENE)).until(0.0)
            self.assertEqual(fresh.wait_until_ready().missing(), [])

    # The player.

    def test_plays_exactly_up_to_the_given_time(self):
        heard = []
        clock = rospy.Subscriber('/clock', Clock, heard.append)
        self.addCleanup(clock.unregister)
        player = self.play(4.25)
        frames = road.read(self.bag(SCENE), '/agents')
        end = frames[0][1] + rospy.Duration(4.25)
        wait_until(lambda: [] if heard and heard[-1].clock == end else ['the clock'], 10.0)
        self.assertEqual(player.stamp, max(message.header.stamp for message, stamp in frames if stamp <= end))
        self.assertEqual(self.forge.scene.now, player.stamp)
        time.sleep(0.5)
        self.assertEqual(heard[-1].clock, end, 'time stands still')
        self.assertEqual((player.now, player.is_at_end), (4.25, False))

    def test_steps_and_continues(self):
        player = self.play(2.0)
        stamps = [message.header.stamp for message, _ in road.read(self.bag(SCENE), '/agents')]
        self.assertEqual(player.step().stamp, stamps[5])
        self.assertEqual(player.step(3).stamp, stamps[8])
        begin = time.monotonic()
        self.assertEqual(player.go_on(1.0, rate=2.0).now, 5.0)
        self.assertGreater(time.monotonic() - begin, 0.4)
        self.assertEqual([player.now for _ in player.every(6.0)], [5.0, 11.0, 17.0])
        self.assertTrue(player.go_on().is_at_end)
        with self.assertRaisesRegex(ForgeError, 'ends'):
            player.step()

    def test_a_time_after_the_end_of_the_bag_is_rejected(self):
        with self.assertRaisesRegex(ForgeError, r'until\(25\.0\): the last frame .* is at 20\.0 s'):
            self.play().until(25.0)

    def test_stamps_may_be_finer_than_those_of_the_suite(self):
        fine = self.path('fine.bag')

        def finer(topic, message):
            if topic == '/agents':
                message.header.stamp -= rospy.Duration(0, 211)
            return message
        road.copy_bag(self.bag(SCENE), fine, finer)
        player = self.forge.play(fine).until(NOW)
        self.assertEqual(player.stamp.nsecs % 1000, 789)
        attack = self.forge.generate(TYPE, TTA)
        self.assertAlmostEqual(player.instant_of(attack.now), NOW, 6)
        self.forge.tested(attack)

    def test_a_name_or_words_replace_the_type(self):
        self.play(NOW)
        told = self.forge.generate(text='{} in {} s'.format(TYPE, TTA))
        self.assert_close(told.message, self.forge.generate(TYPE, TTA).message)
        with self.assertRaisesRegex(Declined, 'did you mean CCRb'):
            self.forge.generate(name='CCRx', tta=TTA)
        with self.assertRaisesRegex(TypeError, 'one of them only'):
            self.forge.generate(TYPE, TTA, name='CCRb')

    def test_plays_and_requests_in_a_namespace(self):
        with unittest.mock.patch.dict(os.environ, ROS_NAMESPACE='front'):
            self.path('front').mkdir()
            suite = Suite(self.path('front'), nodelets='false')
            self.addCleanup(suite.stop)
            said = subprocess.run(['/usr/bin/python3', '-c', IN_A_NAMESPACE.format(bag=self.bag(SCENE), now=NOW,
                                                                                   type=TYPE, tta=TTA)],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                                  timeout=2 * TIMEOUT, check=False)
        self.assertEqual((said.returncode, said.stderr), (0, ''))
        self.assertEqual(said.stdout, '/front/generate_collision True\n')

    def test_rejects_a_second_publisher_of_clock(self):
        self.play()
        other = subprocess.Popen(['rostopic', 'pub', '/clock', 'rosgraph_msgs/Clock', '{}'], stdout=subprocess.DEVNULL)
        self.addCleanup(other.wait)
        self.addCleanup(other.terminate)
        def is_refused():
            try:
                self.forge.play(self.bag(SCENE))
            except ForgeError as error:
                return 'publishes /clock already' in str(error)
            return False
        wait_until(lambda: [] if is_refused() else ['the refusal'], 20.0)

    # Attacks.

    def test_generates_the_same_attack_as_forge_inject(self):
        expected, expected_report = self.offline()
        self.play()
        attack = self.forge.generate(TYPE, TTA)
        self.assert_close(attack.message, expected)
        self.assertEqual(self.forge.attack, attack)
        report = self.forge.tested(attack)
        self.assertEqual((report.verified, report.attacker), (expected_report.verified, expected_report.attacker_id))
        contact_after = (expected_report.contact_time - expected_report.header.stamp).to_sec()
        self.assertAlmostEqual(report.contact.t, contact_after, 2)

    def test_lock_step_is_reproducible(self):
        self.play()
        first = self.forge.generate(TYPE, TTA)
        reports = [self.forge.tested(first)]
        self.forge.player.until(NOW)
        again = self.forge.generate(TYPE, TTA)
        reports.append(self.forge.tested(again))
        self.assert_close(again.message, first.message, tolerance=0.0)
        self.assert_close(reports[1].message, reports[0].message, tolerance=0.0)

    def test_an_adaptive_attack_equals_the_offline_one(self):
        expected, expected_report = self.offline('--mode', 'adaptive', tta=5.0)
        self.play()
        drive = self.forge.adaptive(TYPE, 5.0)
        seen = list(drive)
        self.assertEqual((seen[0].decision, seen[0].plans), ('initial plan', 1))
        self.assertGreater(len(seen), 3)
        self.assertEqual(seen[-1], drive.newest)
        self.assertEqual((drive.report.verified, drive.report.attacker),
                         (expected_report.verified, expected.trajectory.attacker_id))
        # What it decides after the contact may come later than the report.
        driven = [[point for point in attack.trajectory if point.t < drive.report.contact.t]
                  for attack in (drive.newest, Attack.of(expected))]
        self.assertGreater(len(driven[0]), 30)
        for point, other in zip(*driven):
            self.assertLess(math.hypot(point.pose.x - other.pose.x, point.pose.y - other.pose.y), 1e-3)
        self.assertLess(self.forge.player.now, self.forge.player.duration)

    def test_works_with_an_external_source(self):
        player = self.play()
        with CollisionForge(TIMEOUT) as other:
            drive = other.adaptive(TYPE, TTA, at=player.stamp)
            source = threading.Thread(target=player.go_on, kwargs={'seconds': 8.0, 'rate': 2.0})
            source.start()
            self.addCleanup(source.join)
            seen = list(drive)
        self.assertGreater(len(seen), 1)
        self.assertEqual((drive.report.attacker, drive.report.now), (drive.first.attacker, drive.first.now))

    def test_plays_a_bag_that_contains_an_attack(self):
        expected, expected_report = self.offline()
        self.forge.play(self.path('offline.bag')).until(NOW + 1.0)
        wait_until(lambda: [] if self.forge.attack else ['the attack'], 10.0)
        self.assert_close(self.forge.attack.message, expected)
        self.assertEqual(expected_report.attacker_id, self.forge.attack.attacker)

    def test_raises_declined_with_the_code(self):
        self.play()
        for code, arguments in ((Code.UNKNOWN_TYPE, ('magic', TTA)), (Code.TTA_OUT_OF_RANGE, (TYPE, 100.0))):
            with self.assertRaises(Declined) as raised:
                self.forge.generate(*arguments)
            self.assertIs(raised.exception.code, code)
        with self.assertRaises(Declined) as raised:
            self.forge.test_planner('magic', self.forge.generate(TYPE, TTA))
        self.assertIs(raised.exception.code, Code.UNKNOWN_PLANNER)
        for arguments in (dict(seed=-1), dict(alternatives='many'), dict(attacker=5)):
            with self.assertRaisesRegex(ForgeError, 'does not fit its message field'):
                self.forge.generate(TYPE, TTA, **arguments)

    def test_possible_collisions_can_be_generated(self):
        self.play()
        possible = self.forge.possible([TYPE, 'rear_end'], [TTA], alternatives=8)
        self.assertGreater(max(collision.alternative for collision in possible), 1)
        self.assertGreater(len(possible), 0)
        self.assertIsNone(self.forge.attack, 'nothing is published')
        for collision in possible:
            attack = self.forge.generate(collision)
            self.assertEqual((attack.collision_type, attack.attacker, attack.report.manoeuvre, attack.report.confidence),
                             (collision.collision_type, collision.attacker, collision.manoeuvre, collision.confidence))
            self.assertAlmostEqual(attack.report.contact.t, collision.contact_after)

    def test_generates_for_each_type_and_time(self):
        self.play()
        answers = self.forge.generate_all([TYPE, 'ltap'], [3.0, TTA])
        self.assertEqual([(answer.collision_type, answer.tta) for answer in answers],
                         [(TYPE, 3.0), (TYPE, TTA), ('ltap', 3.0), ('ltap', TTA)])
        self.assert_close(answers[1].attack.message, self.forge.generate(TYPE, TTA).message)
        self.assertTrue(all((answer.attack is None) == (answer.code != Code.OK) for answer in answers))

    def test_requests_of_a_scene(self):
        self.play(0.0)
        found = list(self.forge.requests(8.0, ['rear_end', TYPE], [TTA]))
        start = road.read(self.bag(SCENE), '/agents')[0][0].header.stamp
        self.assertGreater(len(found), 0)
        self.assertLessEqual({round((one.now - start).to_sec(), 3) for one in found}, {0.0, 8.0, 16.0})


if __name__ == '__main__':
    live.main('client_test')
