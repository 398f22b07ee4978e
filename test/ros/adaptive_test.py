#!/usr/bin/python3
"""Live adaptive attacks: the driven trajectory equals that of forge inject --mode adaptive for the same bag, and every
node follows its updates."""
import math
import time

import rospy
from rosgraph_msgs.msg import Clock

import live
import road
from live import until

TYPE, TTA, NOW = 'lane_change', 4.0, 4.0
ADAPTIVE_TTA = 5.0  # s; the adaptive attack of this request succeeds
FRAME = 0.5  # s
LOOK = 0.2  # s of the wall clock; more than an update step takes


def way_of(attack):
    return [(point.stamp, point.pose.position.x, point.pose.position.y, point.speed) for point in attack.trajectory.points]


def first_change(before, after):
    """Return the stamp of the first point that differs."""
    return next((new[0] for old, new in zip(way_of(before), way_of(after)) if old != new), after.trajectory.points[-1].stamp)


def place_at(attack, stamp):
    """Return the position at the stamp of a trajectory point."""
    return next((x, y) for at, x, y, _ in way_of(attack) if abs((at - stamp).to_sec()) < 1e-3)


class AdaptiveTest(live.LiveTest):
    SCENES = ['scene-0007']
    ARGUMENTS = {'keep_attack': 'true'}
    HEARD = ['/encoded_scene', '/attack', '/injected_agents', '/tested_report', '/attack_markers']

    def ask(self, tta=TTA, **controls):
        """Request the attack at NOW; return the response."""
        end = self.play_to(NOW).header.stamp
        for listener in self.heard.values():
            listener.clear()
        return self.ask_until(lambda answer: answer.code == 0 and answer.attack.header.stamp == end, TYPE, tta,
                              believable='true', **controls)

    def play_on(self, until_seconds):
        """Publish frame by frame, with time for an update step."""
        seconds = NOW
        while seconds < until_seconds:
            seconds += FRAME
            end = self.player.play_to(seconds)
            self.heard['/encoded_scene'].wait(lambda scene: scene.header.stamp == end)
            time.sleep(LOOK)

    def offline(self):
        """Return the attack and the tested report of forge inject."""
        out = self.path('adaptive.bag')
        result = road.inject(self.bag(self.SCENES[0]), out, TYPE, ADAPTIVE_TTA, NOW, '--mode', 'adaptive', '--believable', 'true')
        self.assertEqual(road.code_of(result), 'OK')
        return road.read_one(out, '/attack'), road.read_one(out, '/tested_report')

    def attacks(self):
        return self.heard['/attack'].all()

    def test_live_adaptive_attack_equals_offline_attack(self):
        expected, expected_report = self.offline()
        answer = self.ask(ADAPTIVE_TTA, adaptive=True)
        first = answer.attack
        self.assertEqual((first.adaptive, first.phase, first.decision, first.plans), (True, 'attacking', 'initial plan', 1))
        self.assertEqual(first.decided, first.header.stamp)
        self.play_on(NOW + 7.0)
        last = self.heard['/attack'].wait(lambda attack: attack.plans == expected.plans)
        self.assertEqual((last.phase, last.decision, last.decided), (expected.phase, expected.decision, expected.decided))
        self.assert_close(self.attacks()[-1].trajectory, expected.trajectory, tolerance=1e-3)
        self.check_published(first)
        self.check_injected(first)
        self.check_tested(expected_report)

    def check_published(self, first):
        """Check the updates of the attack: the driven part never changes."""
        attacks = self.attacks()
        self.assertEqual(attacks[0].plans, 1)
        self.assertGreater(len(attacks), 3)
        for before, after in zip(attacks, attacks[1:]):
            self.assertEqual((after.header.stamp, after.pattern, after.trajectory.attacker_id),
                             (first.header.stamp, first.pattern, first.trajectory.attacker_id))
            self.assertGreaterEqual(after.plans, before.plans)
            self.assertGreaterEqual(after.decided, before.decided)
            self.assertGreaterEqual(first_change(before, after), after.decided)
            self.assertEqual(after.report.decision, after.decision)
        self.assertGreater(attacks[-1].decided, first.header.stamp)

    def check_injected(self, first):
        """Check that up to the contact the attacker follows a published trajectory, at last the newest one."""
        attacks = self.attacks()
        tested = self.heard['/tested_report'].wait()
        end = tested.contact_time if tested.contact else first.trajectory.points[-1].stamp
        places = [(message.header.stamp, agent.pose.position) for message in self.heard['/injected_agents'].all()
                  for agent in message.agents
                  if agent.id == first.trajectory.attacker_id
                  and first.header.stamp < message.header.stamp < end]
        self.assertGreater(len(places), 15)
        away = []
        for stamp, place in places:
            distances = [math.hypot(place.x - x, place.y - y)
                         for x, y in (place_at(attack, stamp) for attack in attacks)]
            self.assertLess(min(distances), 1e-3)
            away.append(distances[0])
        self.assertLess(distances[-1], 1e-3)
        self.assertGreater(max(away), 0.1, 'it has left its first plan')

    def check_tested(self, expected):
        """Check that the report is published once."""
        tested = self.heard['/tested_report'].wait()
        self.assertEqual((tested.attacker_id, tested.contact), (expected.attacker_id, expected.contact))
        self.assertLess(abs((tested.contact_time - expected.contact_time).to_sec()), 0.05)
        self.assertIn(tested.decision, {attack.decision for attack in self.attacks()})
        self.assertEqual(len(self.heard['/tested_report'].all()), 1)

    def test_attack_restarts_when_the_replay_restarts(self):
        first = self.ask(adaptive=True).attack
        self.play_on(NOW + 5.0)
        self.heard['/attack'].wait(lambda attack: attack.plans > 1)
        driven = self.attacks()[-1]
        for topic in ('/attack', '/tested_report'):
            self.heard[topic].clear()
        self.play_to(1.0)
        self.assert_close(self.heard['/attack'].wait(), first, tolerance=0.0)
        self.player.play_to(NOW)
        self.play_on(NOW + 5.0)
        self.heard['/attack'].wait(lambda attack: attack.plans == driven.plans)
        self.assert_close(self.attacks()[-1].trajectory, driven.trajectory)
        self.heard['/tested_report'].wait()
        self.assertEqual(len(self.heard['/tested_report'].all()), 1, 'it is tested again, once')

    def test_aborts_when_scenes_stop_arriving(self):
        self.ask(adaptive=True)
        self.play_on(NOW + 1.0)
        clock = self.player.start + rospy.Duration(NOW + 1.0)

        def is_lost():
            nonlocal clock
            clock += rospy.Duration(0.1)
            self.player.publishers['/clock'].publish(Clock(clock))
            return self.heard['/attack'].last(lambda attack: attack.decision == 'the ego is no longer observed')
        until(is_lost, 'the attacker to give up', interval=0.1)
        self.assertEqual(self.attacks()[-1].phase, 'driving_on')

    def test_markers_show_the_driven_path(self):
        self.ask(adaptive=True)
        self.play_on(NOW + 2.0)
        self.heard['/attack_markers'].wait(lambda array: 'driven' in {marker.ns for marker in array.markers})

    def test_a_fixed_attack_replaces_an_adaptive_one(self):
        self.ask(adaptive=True)
        fixed = self.ask().attack
        self.assertFalse(fixed.adaptive)
        self.assertEqual((fixed.phase, fixed.decision, fixed.report.decision, fixed.plans), ('', '', '', 0))
        self.heard['/attack'].wait(lambda attack: not attack.adaptive)
        self.play_on(NOW + 3.0)
        self.assertFalse(self.attacks()[-1].adaptive)

    def test_adaptive_requests_that_are_rejected(self):
        self.play_to(NOW)
        for controls, named in (({'mode': 'replay'}, ('adaptive', 'mode')), ({'limits': 'strict'}, ('limits',)),
                                ({'alternatives': 2}, ('alternatives',))):
            answer = self.ask_for_code('INVALID_INPUT', TYPE, TTA, adaptive=True, **controls)
            for field in named:
                self.assertIn(field, answer.message)


if __name__ == '__main__':
    live.main('adaptive_test')
