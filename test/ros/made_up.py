"""Synthetic scenes, published to the running suite."""
import math

import live
import rospy
from geometry_msgs.msg import Point32, Pose2D, TransformStamped
from live import until
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

from collision_forge.msg import Agent, AgentArray, Lane, LaneMap, PolygonWithHoles

SPEED = 10.0    # m/s of the ego, eastwards along y = 0
PERIOD = 0.5    # s between frames
HISTORY = 8     # frames that the encoder keeps
LENGTH = 300.0  # m of road to either side


def lane_map():
    """A straight road from west to east with a lane each way, driven on the right."""
    message = LaneMap(location='made-up-right')
    message.header.frame_id = 'map'
    for name, y, yaw in (('east', 0.0, 0.0), ('west', 3.5, math.pi)):
        steps = [-LENGTH + 2.0 * step for step in range(int(LENGTH) + 1)]
        line = [Pose2D(x, y, yaw) for x in (steps if yaw == 0.0 else reversed(steps))]
        message.lanes.append(Lane(id=name, centerline=line))
    area = PolygonWithHoles()
    for x, y in ((-LENGTH, -2.0), (LENGTH, -2.0), (LENGTH, 5.5), (-LENGTH, 5.5)):
        area.exterior.points.append(Point32(x, y, 0.0))
    message.drivable_area.append(area)
    return message


def agent(name, x, y=0.0, yaw=0.0, agent_class=Agent.CAR):
    message = Agent(id=name, agent_class=agent_class)
    message.size.x, message.size.y, message.size.z = 4.6, 1.9, 1.5
    message.pose.position.x, message.pose.position.y, message.pose.position.z = x, y, 0.75
    message.pose.orientation.z, message.pose.orientation.w = math.sin(0.5 * yaw), math.cos(0.5 * yaw)
    return message


def transform_of(time, parent, child, x=0.0, y=0.0):
    transform = TransformStamped(child_frame_id=child)
    transform.header.stamp, transform.header.frame_id = time, parent
    transform.transform.translation.x, transform.transform.translation.y = x, y
    transform.transform.rotation.w = 1.0
    return transform


def traffic(seconds):
    """Return a car behind the ego, an oncoming car and a pedestrian."""
    return [agent('behind', -20.0 + 11.0 * seconds), agent('oncoming', 140.0 - 9.0 * seconds, 3.5, math.pi),
            agent('walker', 30.0 + seconds, -5.0, 0.0, Agent.PEDESTRIAN)]


def drive(frames, agents=traffic, speed=SPEED):
    """Return (seconds, x of the ego, agents) of each frame."""
    return [(i * PERIOD, speed * i * PERIOD, agents(i * PERIOD)) for i in range(frames)]


class MadeUpTest(live.LiveTest):
    """A test of the suite in synthetic scenes."""
    RECORDING = False
    MOVED = 'base_link'  # frame that /tf moves in the map
    HEARD = ['/encoded_scene', '/injected_agents']

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.publishers = {topic: rospy.Publisher(topic, message, queue_size=1000, latch=topic == '/lane_map')
                          for topic, message in (('/clock', Clock), ('/tf', TFMessage), ('/agents', AgentArray),
                                                 ('/lane_map', LaneMap))}
        for topic, publisher in cls.publishers.items():
            until(lambda: publisher.get_num_connections() > 0, 'a subscriber of ' + topic)
        for topic, listener in cls.heard.items():
            until(lambda: listener.subscriber.get_num_connections() > 0, 'a publisher of ' + topic)
        cls.start = 10000.0  # s; each scene starts earlier than the previous one, as a restarted replay

    def setUp(self):
        super().setUp()
        type(self).start -= 100.0

    def publish_transform(self, time, x):
        self.publishers['/tf'].publish(TFMessage([transform_of(time, 'map', self.MOVED, x)]))

    def publish(self, frames):
        """Publish the frames, the ego's poses at their times, and one earlier pose."""
        start = rospy.Time(self.start)
        self.publishers['/clock'].publish(Clock(start - rospy.Duration(1)))
        self.publish_transform(start - rospy.Duration(1), frames[0][1])
        for seconds, x, agents in frames:
            time = start + rospy.Duration(seconds)
            self.publishers['/clock'].publish(Clock(time))
            self.publish_transform(time, x)
            message = AgentArray(agents=agents)
            message.header.stamp, message.header.frame_id = time, 'map'
            self.publishers['/agents'].publish(message)

    def show(self, frames, left_out=0):
        """Publish until the encoder has received all frames: it drops messages while time jumps back."""
        self.publishers['/lane_map'].publish(lane_map())
        end = rospy.Time(self.start) + rospy.Duration(frames[-1][0])
        expected = min(len(frames) - left_out, HISTORY)
        listener = self.heard['/encoded_scene']

        def shown():
            listener.clear()
            self.publish(frames)
            try:
                return listener.wait(lambda scene: scene.header.stamp == end and len(scene.snapshot.ego.states) == expected,
                                     timeout=2.0)
            except AssertionError:
                return None
        return until(shown, lambda: '{} frames; last: {:.3000}'.format(expected, str(listener.last())))

    def assert_works(self):
        """Check that a valid scene gets an attack, whatever was published before."""
        type(self).start -= 50.0
        scene = self.show(drive(6))
        answer = self.ask_until(lambda answer: answer.code == 0 and answer.attack.pattern.header.stamp == scene.header.stamp,
                                'rear_end', 4.0)
        self.assertEqual(answer.attack.pattern.attacker_id, 'behind')
        self.assertTrue(answer.attack.report.verified)
        self.assertLess(abs((answer.attack.report.contact_time - scene.header.stamp).to_sec() - 4.0), 0.5)
