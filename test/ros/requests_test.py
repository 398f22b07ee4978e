#!/usr/bin/python3
"""The services beside generate_collision, requests for a stamp, stale scenes, and sources of other rates and frames."""
import threading

import live
import road
import rospy
from live import ask, until
from made_up import HISTORY, SPEED, MadeUpTest, agent, drive, traffic, transform_of
from rosgraph_msgs.msg import Clock
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage

from collision_forge.msg import AgentArray, Attack, CollisionRequest
from collision_forge.srv import GenerateCollisions, ListCollisions

NOW = 2.5  # s after the first frame: the last of drive(6)


def call(name, service, **fields):
    fields.setdefault('request', CollisionRequest(believable='false', seed=3))
    return rospy.ServiceProxy(name, service)(**fields)


def list_collisions(**fields):
    return call('/list_collisions', ListCollisions, **fields)


def generate_collisions(**fields):
    return call('/generate_collisions', GenerateCollisions, **fields)


class AttackedTest(MadeUpTest):
    HEARD = ['/encoded_scene', '/injected_agents', '/attack', '/attack_path', '/attack_ego_path', '/tested_report',
             '/attack_markers', '/pattern_markers']

    def time(self, seconds):
        return rospy.Time(self.start) + rospy.Duration(seconds)

    def attacked(self):
        """Publish a scene and request an attack; return the response."""
        self.show(drive(6))
        answer = self.ask_until(lambda answer: answer.code == 0 and answer.attack.header.stamp == self.time(NOW))
        self.heard['/attack'].wait(lambda attack: attack.trajectory == answer.attack.trajectory)
        self.heard['/attack_markers'].wait(lambda array: len(array.markers) > 1)
        for topic in ('/attack_path', '/attack_ego_path'):
            self.heard[topic].wait(lambda path: path.header.stamp == self.time(NOW))
        self.heard['/pattern_markers'].wait(lambda array: len(array.markers) > 1)
        for topic in ('/attack', '/attack_path', '/attack_ego_path', '/attack_markers', '/pattern_markers'):
            self.heard[topic].clear()
        return answer

    def assert_tested_by(self, publish_pose):
        """Check that tested_report uses the poses of `publish_pose`, the ego's motion after t0."""
        answer = self.attacked()
        self.heard['/tested_report'].clear()
        self.heard['/injected_agents'].clear()
        for i in range(1, 71):
            seconds = NOW + 0.1 * i
            self.publishers['/clock'].publish(Clock(self.time(seconds)))
            publish_pose(self.time(seconds), seconds)
            if i % 5 == 0:
                message = AgentArray(agents=traffic(seconds))
                message.header.stamp, message.header.frame_id = self.time(seconds), 'map'
                self.publishers['/agents'].publish(message)
        tested = self.heard['/tested_report'].wait()
        self.assertTrue(tested.contact)
        self.assertLess(abs((tested.contact_time - answer.attack.report.contact_time).to_sec()), 0.3)
        self.heard['/injected_agents'].wait(lambda agents: agents.header.stamp > tested.contact_time)


class FixedBaseTest(AttackedTest):
    """/tf moves base_footprint, and /tf_static fixes base_link to it."""
    MOVED = 'base_footprint'

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        fixed = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        cls.addClassCleanup(fixed.unregister)
        fixed.publish(TFMessage([transform_of(rospy.Time(), 'base_footprint', 'base_link')]))
        until(lambda: fixed.get_num_connections() > 0, 'the suite, a process, hears /tf_static')

    def test_the_ego_is_tested_where_it_is(self):
        self.assert_tested_by(lambda time, seconds: self.publish_transform(time, SPEED * seconds))


class RequestsTest(AttackedTest):

    def assert_forgotten(self):
        """Check that all nodes have dropped the attack: no markers, and agents pass unchanged."""
        self.assertEqual(self.heard['/attack'].wait().trajectory.attacker_id, '')
        self.heard['/attack_markers'].wait(lambda array: len(array.markers) == 1)
        self.heard['/pattern_markers'].wait(lambda array: len(array.markers) == 1)
        for topic in ('/attack_path', '/attack_ego_path'):
            self.heard[topic].wait(lambda path: not path.poses)
        message = AgentArray(agents=traffic(NOW + 1.0))
        message.header.stamp, message.header.frame_id = self.time(NOW + 1.0), 'map'
        self.publishers['/agents'].publish(message)
        injected = self.heard['/injected_agents'].wait(lambda agents: agents.header.stamp == message.header.stamp)
        self.assertEqual(injected.agents, message.agents)

    # Services

    def test_listed_collisions_equal_generated_ones(self):
        self.attacked()
        listed = list_collisions()
        self.assertEqual((listed.code, listed.message, listed.now), (0, '', self.time(NOW)))
        given = generate_collisions()
        self.assertEqual(len(given.answers), 25)
        self.assertEqual(len({(answer.collision_type, answer.tta) for answer in given.answers}), 25)
        possible = [answer for answer in given.answers if answer.code == 0]
        self.assertEqual([(one.collision_type, one.tta, one.attacker_id, one.confidence) for one in listed.collisions],
                         [(one.collision_type, one.tta, one.attack.trajectory.attacker_id, one.attack.report.confidence)
                          for one in possible])
        self.assertGreater(len(possible), 3)
        for answer in given.answers:
            single = ask(answer.collision_type, answer.tta, seed=3)
            self.assertEqual((single.code, single.message, single.summary),
                             (answer.code, answer.message, answer.summary))
            self.assertEqual(single.summary.startswith(answer.collision_type + ' by '), answer.code == 0)
            self.assert_close(single.attack, answer.attack, tolerance=0.0)

    def test_alternatives_are_listed_by_falling_confidence(self):
        self.show(drive(6, lambda seconds: traffic(seconds) + [agent('beside', -12.0 + 10.5 * seconds, 3.5)]))
        self.ask_for_code('OK', attacker='beside')
        wanted = CollisionRequest(believable='false', alternatives=8)
        listed = list_collisions(collision_types=['RE'], ttas=[3.0, 4.0], request=wanted).collisions
        self.assertEqual({one.collision_type for one in listed}, {'rear_end'})
        for tta in (3.0, 4.0):
            sure = [one.confidence for one in listed if one.tta == tta]
            self.assertGreater(len(sure), 1)
            self.assertEqual(sure, sorted(sure, reverse=True))
        for row in listed:
            attack = ask(row.collision_type, row.tta, alternatives=8, alternative=row.alternative).attack
            self.assertEqual((attack.trajectory.attacker_id, attack.report.confidence),
                             (row.attacker_id, row.confidence))
            self.assertAlmostEqual((attack.report.contact_time - attack.header.stamp).to_sec(), row.contact_after)

    def test_a_missing_alternative_is_rejected(self):
        self.attacked()
        answer = self.ask_for_code('NO_ATTACK_WITHIN_LIMITS', alternatives=16, alternative=16)
        self.assertIn('alternative = 16: there are', answer.message)

    def test_lists_leave_the_patterns_of_the_attack(self):
        self.attacked()
        list_collisions()
        generate_collisions(collision_types=['rear_end'], ttas=[3.0])
        shown = self.heard['/pattern_markers']
        shown.clear()
        until(lambda: len(shown.all()) > 2, 'the markers, which come again every second')
        self.assertNotIn(1, [len(array.markers) for array in shown.all()])

    def test_a_name_or_words_request_an_attack(self):
        self.show(drive(6))
        name = 'nhtsa/22_following_vehicle_making_manoeuvre'
        named = self.ask_until(lambda answer: answer.code == 0, '', 4.0, name=name)
        self.assertEqual((named.name, named.attack.report.manoeuvre), (name, 'follower_closes'))
        told = ask('', 0.0, text='a purple car runs into the back of us in 4 s')
        self.assertEqual((told.code, told.attack.report.manoeuvre), (0, 'follower_closes'), told.message)
        self.assertIn('"in 4 s": tta = 4 s', told.understood)
        self.assertEqual(told.not_understood, ['purple'])
        refused = ask('', 4.0, name='CCRx')
        self.assertEqual(road.CODES[refused.code], 'INVALID_INPUT')
        self.assertIn('did you mean CCRb?', refused.message)

    def test_lists_name_what_is_wrong(self):
        self.attacked()
        for fields, code, words in (
                (dict(collision_types=['sideswipe']), 'UNKNOWN_TYPE', '"sideswipe"'),
                (dict(ttas=[99.0]), 'TTA_OUT_OF_RANGE', '99'),
                (dict(request=CollisionRequest(tta=4.0)), 'INVALID_INPUT', 'request.tta'),
                (dict(request=CollisionRequest(attacker_id='nobody')), 'UNKNOWN_ATTACKER', 'nobody'),
                (dict(method='magic'), 'INVALID_INPUT', 'magic')):
            answer = list_collisions(**fields)
            self.assertEqual(road.CODES[answer.code], code)
            self.assertIn(words, answer.message)
        answer = generate_collisions(request=CollisionRequest(mode='adaptive'))
        self.assertEqual(road.CODES[answer.code], 'INVALID_INPUT')

    # An attack that is over

    def test_reset_forgets_the_attack(self):
        self.attacked()
        reset = rospy.ServiceProxy('/reset', Trigger)
        self.assertTrue(reset().success)
        self.assert_forgotten()
        self.assertIn('no attack', reset().message)

    def test_reset_ends_an_attack_of_another_publisher(self):
        answer = self.attacked()
        rospy.ServiceProxy('/reset', Trigger)()
        self.assert_forgotten()
        other = rospy.Publisher('/attack', Attack, queue_size=1)
        self.addCleanup(other.unregister)
        until(lambda: other.get_num_connections() >= 2, 'the suite and this test hear it')
        other.publish(answer.attack)
        self.heard['/attack_markers'].wait(lambda array: len(array.markers) > 1)
        self.heard['/attack'].clear()
        self.heard['/attack_markers'].clear()
        self.assertIn('no attack', rospy.ServiceProxy('/reset', Trigger)().message)
        self.heard['/attack_markers'].wait(lambda array: len(array.markers) == 1)

    def test_a_rejected_request_clears_the_previous_attack(self):
        self.attacked()
        self.ask_for_code('ROAD_DOES_NOT_ALLOW', 'ltap', believable='true')
        self.assert_forgotten()

    def test_an_invalid_request_keeps_the_attack(self):
        self.attacked()
        self.ask_for_code('UNKNOWN_TYPE', 'rear_ned')
        self.ask_for_code('UNKNOWN_ATTACKER', attacker='nobody')
        self.ask_for_code('INVALID_INPUT', mode='hystory')
        self.assertIn('removed', rospy.ServiceProxy('/reset', Trigger)().message)
        self.assert_forgotten()  # after the reset only
        self.assertEqual(len(self.heard['/attack'].all()), 1)

    # Scenes: which, and how old

    def test_a_dead_source_is_reported(self):
        self.attacked()
        self.publishers['/clock'].publish(Clock(self.time(NOW + 30.0)))
        message = self.ask_for_code('STALE_SCENE').message
        self.assertIn('/tf', message)
        listed = list_collisions()
        self.assertEqual(road.CODES[listed.code], 'STALE_SCENE')
        self.assert_works()

    def test_a_request_names_a_scene_by_its_stamp(self):
        self.attacked()
        answer = ask(stamp=self.time(2.2))
        self.assertEqual((answer.code, answer.attack.header.stamp), (0, self.time(2.0)))
        self.assertEqual(list_collisions(stamp=self.time(2.0)).now, self.time(2.0))
        old = ask(stamp=self.time(-5.0))
        self.assertEqual(road.CODES[old.code], 'NO_SCENE')

    def test_a_request_waits_for_a_scene_that_is_to_come(self):
        self.attacked()
        answers = []
        asker = threading.Thread(target=lambda: answers.append(ask(stamp=self.time(3.5))))
        asker.start()
        for seconds in (3.0, 3.5):
            asker.join(0.3)
            self.assertEqual(answers, [])
            self.publishers['/clock'].publish(Clock(self.time(seconds)))
            self.publish_transform(self.time(seconds), SPEED * seconds)
            message = AgentArray(agents=traffic(seconds))
            message.header.stamp, message.header.frame_id = self.time(seconds), 'map'
            self.publishers['/agents'].publish(message)
        asker.join(live.TIMEOUT)
        self.assertEqual((answers[0].code, answers[0].attack.header.stamp), (0, self.time(3.5)))

    # Sources of other rates and frames

    def test_frames_at_ten_hertz_are_a_history_of_three_and_a_half_seconds(self):
        scene = self.show_at([0.1 * i for i in range(51)])
        stamps = [(state.stamp - self.time(0.0)).to_sec() for state in scene.snapshot.ego.states]
        self.assertEqual(len(stamps), HISTORY)
        for stamp, expected in zip(stamps, [1.5 + 0.5 * i for i in range(HISTORY)]):
            self.assertAlmostEqual(stamp, expected, places=6)
        self.ask_until(lambda answer: answer.code == 0 and answer.attack.header.stamp == self.time(5.0))

    def test_agents_in_another_frame_are_refused(self):
        self.attacked()
        message = AgentArray(agents=traffic(3.0))
        message.header.stamp, message.header.frame_id = self.time(3.0), 'odom'
        self.publish_transform(self.time(3.0), SPEED * 3.0)
        self.publishers['/agents'].publish(message)
        until(lambda: self.suite.output().count('agents: header.frame_id = "odom"') >= 3,
              'the message of encoder, verifier and injector about the frame')
        self.assertNotIn(message.header.stamp,
                         [frame.header.stamp for frame in self.heard['/injected_agents'].all()])

    def test_the_ego_is_tested_where_tf_has_it_though_odometry_drifts(self):
        """map -> odom compensates a drift of odom -> base_link, 0.3 m/s sideways."""
        self.assert_tested_by(self.publish_drifting)

    def publish_drifting(self, time, seconds):
        for parent, child, x, y in (('map', 'odom', 0.0, -0.3 * seconds),
                                    ('odom', 'base_link', SPEED * seconds, 0.3 * seconds)):
            self.publishers['/tf'].publish(TFMessage([transform_of(time, parent, child, x, y)]))

    def show_at(self, times):
        """Publish frames at these seconds, in this order; return the scene of the last one."""
        def shown():
            self.heard['/encoded_scene'].clear()
            self.publish([(seconds, SPEED * seconds, traffic(seconds)) for seconds in times])
            try:
                return self.heard['/encoded_scene'].wait(lambda scene: scene.header.stamp == self.time(times[-1]),
                                                         timeout=2.0)
            except AssertionError:
                type(self).start -= 50.0
                return None
        self.show(drive(6))  # a map, and all connections
        type(self).start -= 50.0
        return until(shown, 'the scene of the last frame')


if __name__ == '__main__':
    live.main('requests_test')
