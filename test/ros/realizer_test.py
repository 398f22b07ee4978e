#!/usr/bin/python3
"""An external realiser node takes part in every request, and its attacks are verified like built-in ones."""
import live
import road
import rospy
from geometry_msgs.msg import Vector3
from made_up import MadeUpTest, agent, drive

from collision_forge.msg import Agent, AttackerTrajectory, TrajectoryPoint
from collision_forge.srv import RealizeTrajectory, RealizeTrajectoryResponse

STEP = 0.1      # s
DURATION = 6.5  # s
SPEED = 11.5    # m/s of the vehicle behind
JERK = 0.5      # m/s3 of a drive that hits the ego after 4 s


def straight_on(message, jerk=JERK):
    """Return a drive of the first pattern's vehicle along its lane with this jerk (m/s3)."""
    pattern = message.patterns[0]
    track = next(track for track in message.scene.agents if track.id == pattern.attacker_id)
    now = track.states[-1]
    answer = RealizeTrajectoryResponse()
    answer.attack.pattern = pattern
    trajectory = AttackerTrajectory(header=message.scene.header, attacker_id=track.id, agent_class=track.agent_class,
                                    size=track.size)
    for i in range(int(DURATION / STEP) + 1):
        seconds = i * STEP
        point = TrajectoryPoint(stamp=now.stamp + rospy.Duration(seconds), speed=SPEED + jerk * seconds ** 2 / 2.0,
                                acceleration=jerk * seconds)
        point.pose.position.x = now.pose.x + SPEED * seconds + jerk * seconds ** 3 / 6.0
        point.pose.position.y = now.pose.y
        point.pose.orientation.w = 1.0
        trajectory.points.append(point)
    answer.attack.trajectory = trajectory
    answer.attack.report.contact = True
    answer.attack.report.verified = True
    answer.attack.report.contact_time = now.stamp + rospy.Duration(message.request.tta)
    answer.attack.report.ego_at_contact = pattern.ego
    return answer


class RealizerTest(MadeUpTest):
    ARGUMENTS = {'realizer': 'false'}

    asked = []     # requests received since the last request
    answer = None  # the realiser

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        service = rospy.Service('realize_trajectory', RealizeTrajectory, cls.realize)  # its connections are kept
        cls.addClassCleanup(service.shutdown)

    @classmethod
    def realize(cls, message):
        cls.asked.append(message)
        return cls.answer(message)

    def ask(self, answer, collision_type='rear_end', **fields):
        """Request a collision 4 s from t0 with this realiser; return the response."""
        type(self).answer, type(self).asked = staticmethod(answer), []
        self.show(drive(8, lambda seconds: [agent('behind', -20.0 + SPEED * seconds)]))
        fields.setdefault('believable', 'false')
        return live.ask(collision_type, 4.0, **fields)

    def assert_code(self, answer, code):
        self.assertEqual(road.CODES[answer.code], code, answer.message)

    def test_its_attack_is_verified_though_its_report_is_empty(self):
        def bare(message):
            answer = straight_on(message)
            answer.attack.report.manoeuvre = ''
            return answer
        answer = self.ask(bare, choice='existing', alternatives=2)
        self.assert_code(answer, 'OK')
        self.assertEqual(answer.attack.report.manoeuvre, 'follower_closes')
        self.assertTrue(answer.attack.report.verified)
        self.assertGreater(answer.attack.report.impact_speed, 1.0)

    def test_its_attack_is_rejected_if_it_violates_a_limit(self):
        def leap(message):
            answer = straight_on(message)
            for point in answer.attack.trajectory.points[5:]:
                point.pose.position.x += 20.0
            return answer
        answer = self.ask(leap, choice='existing')
        self.assert_code(answer, 'NO_ATTACK_WITHIN_LIMITS')

    def test_class_and_size_are_those_of_the_scene(self):
        def truck(message):
            answer = straight_on(message)
            answer.attack.trajectory.agent_class = Agent.TRUCK
            answer.attack.trajectory.size = Vector3(12.0, 2.5, 3.0)
            return answer
        answer = self.ask(truck, choice='existing')
        self.assert_code(answer, 'OK')
        self.assertEqual(answer.attack.trajectory.agent_class, Agent.CAR)
        self.assertAlmostEqual(answer.attack.trajectory.size.x, 4.6, places=6)

    def test_an_unknown_attacker_is_rejected_by_name(self):
        def stranger(message):
            answer = straight_on(message)
            answer.attack.trajectory.attacker_id = 'stranger'
            return answer
        answer = self.ask(stranger, choice='existing')
        self.assertIn('"stranger"', answer.message)
        self.assertNotEqual(answer.code, 0)

    def test_it_receives_added_vehicles_with_their_paths(self):
        def decline(message):
            return RealizeTrajectoryResponse(code=road.CODES.index('NO_ATTACK_WITHIN_LIMITS'), message='not I')
        answer = self.ask(decline, 'opposite_direction', choice='new', believable='true')
        self.assert_code(answer, 'NO_ATTACK_WITHIN_LIMITS')
        ways = [way for message in self.asked for way in message.ways]
        self.assertTrue(ways)
        for message in self.asked:
            known = {track.id for track in message.scene.agents}
            self.assertLessEqual({way.attacker_id for way in message.ways}, known)
        self.assertTrue(all(len(way.points) >= 4 and way.spacing > 0.0 for way in ways))


if __name__ == '__main__':
    live.main('realizer_test')
