#!/usr/bin/python3
"""The running suite on synthetic scenes, most of them invalid: errors name the fault and the next request works."""
import math

import live
import road
import rospy
from live import ask, until
from made_up import HISTORY, PERIOD, SPEED, MadeUpTest, agent, drive, lane_map, traffic

from collision_forge.msg import Attack


class BadInputTest(MadeUpTest):
    HEARD = MadeUpTest.HEARD + ['/map_markers']

    # The order matters: the first tests need a suite that has received nothing yet.

    def test_0_before_any_scene(self):
        answer = ask('rear_end', 4.0)
        self.assertEqual(road.CODES[answer.code], 'NO_SCENE')
        for topic in ('agents', 'lane_map', 'tf'):
            self.assertIn(topic, answer.message)
        self.assertEqual(road.CODES[ask('rear_end', 4.0, mode='replay').code], 'NO_SCENE')

    def test_1_without_a_map(self):
        self.publish(drive(6))
        until(lambda: 'no usable lane_map' in self.suite.output(), 'the warning that there is no map')
        self.heard['/injected_agents'].wait()
        self.assertEqual(road.CODES[ask('rear_end', 4.0).code], 'NO_SCENE')

    def test_2_map_that_is_not_a_number(self):
        broken = lane_map()
        broken.lanes[0].centerline[7].x = math.nan
        broken.location += '\x1b[2J'  # clears a terminal
        self.publishers['/lane_map'].publish(broken)
        until(lambda: r'lane_map of made-up-right\x1b[2J is not usable' in self.suite.output(),
              'the message about the map')
        until(lambda: 'lane_map not shown: ' in self.suite.output(), 'the message that it is not shown')
        self.assertEqual(self.heard['/map_markers'].all(), [])
        self.assertEqual(road.CODES[ask('rear_end', 4.0).code], 'NO_SCENE')

    def test_3_map_that_comes_after_the_frames(self):
        frames = drive(6)
        end = rospy.Time(self.start) + rospy.Duration(frames[-1][0])
        self.publish(frames)
        self.heard['/injected_agents'].wait(lambda agents: agents.header.stamp == end)
        self.publishers['/lane_map'].publish(lane_map())
        scene = self.heard['/encoded_scene'].wait(lambda scene: scene.header.stamp == end)
        self.assertEqual(len(scene.snapshot.ego.states), len(frames))
        self.assertEqual(road.CODES[ask('rear_end', 4.0, stamp=end).code], 'OK', 'whoever needs the map waits for it')
        self.assert_works()

    def test_good_scene(self):
        self.assert_works()

    def test_unknown_type(self):
        self.show(drive(6))
        for name in ('sideswipe', '', 'rear end', 'REAR_END '):
            answer = self.ask_for_code('UNKNOWN_TYPE', name)
            self.assertIn('collision_type = "{}"'.format(name), answer.message)

    def test_replay_without_a_recording(self):
        self.show(drive(6))
        self.assertIn('recording', self.ask_for_code('NO_RECORDING', mode='replay').message)

    def test_scene_without_agents(self):
        scene = self.show(drive(6, lambda seconds: []))
        self.assertEqual(scene.snapshot.agents, [])
        self.assertEqual(tuple(scene.agent_features.shape), (1, HISTORY, 8))
        self.ask_for_code('NO_CANDIDATE')
        self.assert_works()

    def test_agents_that_are_not_numbers(self):
        """Invalid agents are dropped, the other agents stay."""
        def agents(seconds):
            broken = [agent('nan_{}'.format(i), -10.0 * i) for i in range(4)]
            broken[0].pose.position.x = math.nan
            broken[1].pose.position.y = math.inf
            broken[2].pose.orientation.w = math.nan
            broken[3].size.x = math.nan
            return broken + traffic(seconds)
        scene = self.show(drive(6, agents))
        self.assertEqual([track.id for track in scene.snapshot.agents], ['behind', 'oncoming', 'walker'])
        self.assertFalse(any(math.isnan(value) for value in scene.agent_features.data))
        self.ask_for_code('OK', 'rear_end', 4.0)
        self.ask_for_code('UNKNOWN_ATTACKER', attacker='nan_0')

    def test_agent_class_that_does_not_exist(self):
        """An invalid frame is ignored; the next one is used."""
        frames = drive(6)
        frames[4][2].append(agent('alien', 10.0, agent_class=42))
        scene = self.show(frames, left_out=1)
        self.assertEqual([round(state.stamp.to_sec() - self.start, 3) for state in scene.snapshot.ego.states],
                         [0.0, 0.5, 1.0, 1.5, 2.5])
        self.assertIn('agent_class = 42', self.suite.output())
        self.ask_for_code('OK', 'rear_end', 4.0)

    def test_trajectory_that_is_not_a_number(self):
        """An invalid attack of another publisher is reported and ignored."""
        self.show(drive(6))
        answer = self.ask_for_code('OK', 'rear_end', 4.0)
        answer.attack.trajectory.points[3].speed = math.nan
        publisher = rospy.Publisher('/attack', Attack, queue_size=1, latch=True)
        self.addCleanup(publisher.unregister)
        publisher.publish(answer.attack)
        until(lambda: self.suite.output().count('attack ignored: attacker behind: points[3] is not finite') >= 2,
              'the injector and the verifier to ignore it')
        self.assert_works()

    def test_numbers_beyond_the_limits(self):
        """A box of 1 km and a position out of range are dropped; a trajectory of several years is rejected."""
        def agents(seconds):
            broken = [agent('long', -10.0), agent('far', 160000.0)]
            broken[0].size.x = 1000.0
            return broken + traffic(seconds)
        scene = self.show(drive(6, agents))
        self.assertEqual([track.id for track in scene.snapshot.agents], ['behind', 'oncoming', 'walker'])
        answer = self.ask_for_code('OK', 'rear_end', 4.0)
        answer.attack.trajectory.points[-1].stamp += rospy.Duration(100000)
        publisher = rospy.Publisher('/attack', Attack, queue_size=1, latch=True)
        self.addCleanup(publisher.unregister)
        publisher.publish(answer.attack)
        until(lambda: self.suite.output().count('time from the first point = 10000') >= 2,
              'the injector and the verifier to ignore it')
        self.assert_works()

    def test_ego_pose_that_is_not_a_number(self):
        """tf drops the transform and interpolates the ego's pose between its neighbours."""
        frames = drive(6)
        frames[4] = (frames[4][0], math.nan, frames[4][2])
        scene = self.show(frames)
        states = scene.snapshot.ego.states
        self.assertAlmostEqual(states[4].pose.x - states[3].pose.x, SPEED * PERIOD, places=6)
        self.ask_for_code('OK', 'rear_end', 4.0)

    def test_ego_that_never_moves(self):
        """The request ends with an attack or with a reason."""
        for agents in (traffic, lambda seconds: traffic(0.0)):
            self.show(drive(9, agents, speed=0.0))
            for collision_type in ('lane_change', 'opposite_direction', 'rear_end', 'junction_crossing', 'ltap'):
                answer = ask(collision_type, 4.0)
                self.assertIn(road.CODES[answer.code],
                              ('OK', 'NO_CANDIDATE', 'NO_ATTACK_WITHIN_LIMITS', 'LOW_CONFIDENCE', 'NOT_BELIEVABLE',
                               'ROAD_DOES_NOT_ALLOW'))
                self.assertEqual(answer.message == '', answer.code == 0)
                if answer.code == 0:
                    self.assertTrue(answer.attack.report.verified)
            type(self).start -= 20.0
        self.assert_works()


if __name__ == '__main__':
    live.main('bad_input_test')
