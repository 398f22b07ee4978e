"""Shared by the rostests: the suite, started under the master of the test, and a bag player that plays exactly up to a
given time and then stops the clock."""
import cmath
import math
import os
import signal
import subprocess
import threading
import time
from xmlrpc.client import ServerProxy

import rosbag
import rosgraph
import rospy
from rosgraph_msgs.msg import Clock

import road
from collision_forge.msg import AgentArray, Attack, AttackMethods, AttackRequest, CollisionReport, EncodedScene
from collision_forge.srv import GenerateCollision
from nav_msgs.msg import Path
from visualization_msgs.msg import Marker, MarkerArray

TIMEOUT = 30.0  # s; on an idle machine a fraction of a second is enough
RATE = 10.0  # Hz of injected_agents while there is an attack
SAME_CONTACT = 0.02  # s; bag and node use different poses of the ego
SAME_SPEED = 0.1     # m/s
SAME_SLIDE = 0.3  # m, m/s; its effect on the motion after the contact
SAME_PLACE = 0.1  # m between the boxes shown 1 s after a contact
MOST_OVERLAP = 0.1  # m between two boxes shown in contact, beyond their deformation
ENGAGEMENT = 0.04   # s for which both keep their velocities after the contact, config/severity.yaml
MOST_GAP = 0.5      # m between the boxes half a second after the contact
CLOCK_LEAD = 0.5  # s from the first /clock to the first message: tf2 drops older transforms until time jumps back

# Per node of the suite: published topics, subscribed topics, services.
NODES = {
    'scene_encoder': (['/encoded_scene'], ['/agents', '/ego_vehicle', '/lane_map', '/tf', '/tf_static'], []),
    'pattern_predictor': ([], ['/lane_map'], ['/predict_pattern']),
    'trajectory_realizer': ([], ['/lane_map'], ['/realize_trajectory']),
    'attack_verifier': (['/tested_report'],
                        ['/agents', '/attack', '/attack_request', '/ego_vehicle', '/lane_map', '/tf', '/tf_static'], []),
    'planner_tester': (['/planner_markers', '/planner_outcome', '/planner_path', '/planner_scene_markers',
                        '/planner_test_shown', '/planning_state', '/shown_area', '/tested_map', '/tf_static'],
                       ['/attack', '/planned_trajectory'], ['/test_planner']),
    'collision_generator': (['/attack', '/attack_ego_path', '/attack_methods', '/attack_path', '/attack_request',
                             '/predicted_patterns'],
                            ['/encoded_scene', '/lane_map'],
                            ['/generate_collision', '/generate_collisions', '/list_collisions', '/reset']),
    'attacker_injector': (['/injected_agents', '/injected_objects'], ['/agents', '/attack', '/ego_vehicle', '/tf', '/tf_static'], []),
    'scene_visualizer': (['/attack_markers', '/map_markers', '/pattern_markers', '/scene_markers',
                          '/shown_area', '/traffic_light_markers'],
                         ['/attack', '/ego_vehicle', '/encoded_scene', '/lane_map', '/planner_test_shown',
                          '/predicted_patterns', '/tested_report', '/tf', '/tf_static', '/traffic_lights'], []),
}
MANAGER = 'collision_forge_manager'
PLAYED = ['/agents', '/lane_map', '/tf']  # topics of a bag to which the suite subscribes

TYPES = {'/agents': AgentArray, '/injected_agents': AgentArray, '/injected_objects': rospy.AnyMsg,
         '/encoded_scene': EncodedScene,
         '/attack': Attack, '/attack_methods': AttackMethods,
         '/attack_path': Path, '/attack_ego_path': Path,
         '/attack_request': AttackRequest, '/tested_report': CollisionReport,
         '/attack_markers': MarkerArray,
         '/map_markers': MarkerArray, '/pattern_markers': MarkerArray, '/planner_markers': MarkerArray,
         '/planner_scene_markers': MarkerArray,
         '/scene_markers': MarkerArray}


def until(condition, what, timeout=TIMEOUT, interval=0.05):
    """Return the first true result of `condition`; fail after the timeout."""
    deadline = time.monotonic() + timeout
    while True:
        result = condition()
        if result:
            return result
        if time.monotonic() > deadline or rospy.is_shutdown():
            raise AssertionError('waited {} s in vain for {}'.format(timeout, what() if callable(what) else what))
        time.sleep(interval)


def graph():
    """Return sets of (topic, node) for publishers and for subscribers, and of (service, node); nodes without slash."""
    return [{(name, node.lstrip('/')) for name, nodes in entries for node in nodes}
            for entries in rosgraph.Master(rospy.get_name()).getSystemState()]


def missing_of(nodes, owner=lambda node: node):
    """Return the entries of NODES that the master does not know; `owner` returns the process that hosts a node."""
    actual = graph()
    missing = []
    for node in nodes:
        for expected, registered, verb in zip(NODES[node], actual, ('publishes', 'hears', 'answers')):
            missing += ['{} {} {}'.format(node, verb, name) for name in expected
                        if (name, owner(node)) not in registered]
    return missing


def unconnected_of(nodes):
    """Return the topics of the suite to which a subscriber among NODES is not yet connected."""
    master = rosgraph.Master(rospy.get_name())
    publishers = {topic: node for node, (published, _, _) in NODES.items() for topic in published}
    missing = []
    for node in nodes:
        links = ServerProxy(master.lookupNode('/' + node)).getBusInfo(rospy.get_name())[2]
        heard = {(link[4], link[1]) for link in links if link[2] == 'i'}
        for topic in NODES[node][1]:
            if topic in publishers and (topic, master.lookupNode('/' + publishers[topic])) not in heard:
                missing.append('{} is connected to {}'.format(node, topic))
    return missing


class Suite:
    """Runs launch/collision_forge.launch with some arguments, until stop()."""

    def __init__(self, folder, **arguments):
        self.nodelets = arguments.get('nodelets', 'true') == 'true'
        foreign = {node for argument, node in (('predictor', 'pattern_predictor'), ('realizer', 'trajectory_realizer'))
                   if arguments.get(argument) == 'false'}
        self.nodes = [node for node in NODES if node not in foreign]
        self.log = folder / 'roslaunch.log'
        with open(str(self.log), 'w') as log:
            self.process = subprocess.Popen(
                ['/usr/bin/roslaunch', road.PACKAGE, 'collision_forge.launch'] +
                ['{}:={}'.format(*argument) for argument in arguments.items()],
                stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT)
        try:
            self.wait_until_ready()
        except AssertionError:
            self.stop()
            raise

    def missing(self):
        assert self.process.poll() is None, 'roslaunch ended: ' + self.output()
        if not self.nodelets:
            return missing_of(self.nodes) or unconnected_of(self.nodes)
        # A node that loads a nodelet ties itself to the manager when it is done.
        bonds = [node for node in self.nodes if ('/' + MANAGER + '/bond', node) not in graph()[1]]
        return missing_of(self.nodes, lambda node: MANAGER) + ['{} is loaded'.format(node) for node in bonds]

    def wait_until_ready(self):
        until(lambda: not self.missing(), lambda: '{}\n{}'.format(self.missing(), self.output()), timeout=60.0)

    def wait_until_back(self, name, old_pid):
        """Wait until a killed process has been restarted and the suite is complete again."""
        def is_back():
            try:
                return pid_of(name) != old_pid and not self.missing()
            except (OSError, rosgraph.MasterException):
                return False  # registered, but not running
        until(is_back, lambda: '{}: {}'.format(name, self.missing()), timeout=60.0)

    def output(self):
        return self.log.read_text(errors='replace')

    def stop(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        try:
            self.process.wait(timeout=60.0)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise


def shown_box(markers, name):
    """Return centre, heading and size of the box in a namespace of scene_markers."""
    marker = next(marker for marker in markers.markers if marker.ns == name and marker.type == Marker.CUBE)
    position = marker.pose.position
    return complex(position.x, position.y), road.yaw_of(marker.pose.orientation), (marker.scale.x, marker.scale.y)


def depth_between(first, second):
    """Return the overlap of two boxes, m, along the axis of the least overlap; negative: the gap between them."""
    def corners(box):
        middle, yaw, (length, width) = box
        return [middle + complex(ahead * length / 2, left * width / 2) * cmath.rect(1.0, yaw)
                for ahead, left in ((1, 1), (-1, 1), (-1, -1), (1, -1))]

    def depth_along(yaw):
        spans = [[(corner * cmath.rect(1.0, -yaw)).real for corner in corners(box)] for box in (first, second)]
        return min(max(spans[0]), max(spans[1])) - max(min(spans[0]), min(spans[1]))
    return min(depth_along(box[1] + quarter) for box in (first, second) for quarter in (0.0, math.pi / 2))


def living_connections(end):
    """Return the number of connections of a publisher or subscriber, without those of killed processes (check())."""
    end.impl.check()
    return end.get_num_connections()


class Player:
    """Publishes /clock and the messages of a bag, in their order, up to a given time."""

    def __init__(self, path):
        with rosbag.Bag(str(path)) as bag:
            self.messages = sorted(road.messages_of(bag, PLAYED),
                                   key=lambda entry: (entry[2], entry[0] == '/agents'))
            self.latched = {connection.topic: connection.header.get('latching') == b'1'
                            for connection in bag._get_connections()}
        self.start = self.messages[0][2]
        self.next = 0
        types = {topic: type(message) for topic, message, _ in self.messages}
        self.publishers = {topic: rospy.Publisher(topic, types[topic], queue_size=1000, latch=self.latched[topic])
                           for topic in types}
        self.publishers['/clock'] = rospy.Publisher('/clock', Clock, queue_size=1000)

    def connect(self, suite, listeners):
        """Wait until the suite, the listeners and the player are all connected."""
        for topic, publisher in self.publishers.items():
            hearers = 1 if suite.nodelets else sum(topic in heard or topic == '/clock' for _, heard, _ in NODES.values())
            hearers += topic in listeners
            until(lambda: living_connections(publisher) >= hearers, lambda: '{} subscribers of {}; {} came'.format(
                hearers, topic, publisher.get_num_connections()))
        for topic, listener in listeners.items():
            until(lambda: living_connections(listener.subscriber) > 0, 'a publisher of ' + topic)

    def play_to(self, seconds):
        """Play up to `seconds` after the first message; restart if that time is in the past."""
        end = self.start + rospy.Duration(seconds)
        if self.next > 0 and self.messages[self.next - 1][2] > end:
            self.restart()
        if self.next == 0:
            self.publishers['/clock'].publish(Clock(self.start))
            time.sleep(CLOCK_LEAD)
        while self.next < len(self.messages) and self.messages[self.next][2] <= end:
            topic, message, stamp = self.messages[self.next]
            if self.next == 0 or self.messages[self.next - 1][2] != stamp:
                self.publishers['/clock'].publish(Clock(stamp))
            self.publishers[topic].publish(message)
            self.next += 1
        return end

    def restart(self):
        self.next = 0

    def unregister(self):
        for publisher in self.publishers.values():
            publisher.unregister()


class Listener:
    """Records all messages of a topic."""

    def __init__(self, topic):
        self.topic = topic
        self.messages = []
        self.latched = []
        self.lock = threading.Lock()
        self.subscriber = rospy.Subscriber(topic, TYPES[topic], self.receive)

    def receive(self, message):
        with self.lock:
            self.messages.append(message)
            self.latched.append(message._connection_header.get('latching') == '1')

    def all(self):
        with self.lock:
            return list(self.messages)

    def last(self, condition=lambda message: True):
        return next((message for message in reversed(self.all()) if condition(message)), None)

    def wait(self, condition=lambda message: True, timeout=TIMEOUT):
        """Wait for a message that meets the condition; return the newest one."""
        return until(lambda: self.last(condition), lambda: 'such a message on {}; {} came, the last: {:.2000}'.format(
            self.topic, len(self.all()), str(self.last())), timeout)

    def clear(self):
        with self.lock:
            self.messages.clear()
            self.latched.clear()

    def close(self):
        self.subscriber.unregister()


def ask(collision_type='rear_end', tta=4.0, attacker='', mode='history', seed=0, method='', believable='false', **controls):
    """Call /generate_collision. `controls`: further fields of the request, by name. By default plausibility is not
    required: the embedded scenes have few vehicles that could attack plausibly."""
    return rospy.ServiceProxy('/generate_collision', GenerateCollision)(
        collision_type=collision_type, tta=tta, attacker_id=attacker, mode=mode, seed=seed, method=method,
        believable=believable, **controls)


class LiveTest(road.RoadTest):
    """A test of the suite, launched with ARGUMENTS; the bag of SCENES[0] is the parameter `recording` and is played."""
    ARGUMENTS = {}
    RECORDING = True
    HEARD = ['/encoded_scene']

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        arguments = dict(cls.ARGUMENTS)
        if cls.RECORDING:
            arguments['recording'] = cls.folder / (cls.SCENES[0] + '.bag')
        cls.heard = {topic: Listener(topic) for topic in cls.HEARD}
        for listener in cls.heard.values():
            cls.addClassCleanup(listener.close)
        cls.suite = Suite(cls.folder, **arguments)
        cls.addClassCleanup(cls.suite.stop)
        if cls.SCENES:
            cls.player = Player(cls.folder / (cls.SCENES[0] + '.bag'))
            cls.addClassCleanup(cls.player.unregister)
            cls.player.connect(cls.suite, cls.heard)

    def setUp(self):
        self.assertIsNone(self.suite.process.poll(), 'roslaunch has ended:\n' + self.suite.output())

    def play_to(self, seconds):
        """Play, and wait until the encoder has published the frame at that time; again if it was published before."""
        listener = self.heard['/encoded_scene']
        listener.clear()
        self.player.restart()
        end = self.player.play_to(seconds)
        return listener.wait(lambda scene: scene.header.stamp == end)

    def ask_until(self, expected, *arguments, **named):
        """Repeat the request until the response is as expected (the generator may receive a scene late), or fail."""
        answers = []

        def once():
            answers.append(ask(*arguments, **named))
            return expected(answers[-1])
        until(once, lambda: 'such an answer to {} {}; the last: {} {}'.format(
            arguments, named, road.CODES[answers[-1].code], answers[-1].message))
        return answers[-1]

    def ask_for_code(self, code, *arguments, **named):
        return self.ask_until(lambda answer: road.CODES[answer.code] == code, *arguments, **named)

    def assert_answer(self, answer, attacked):
        """Check that the response has the attack that forge inject wrote to a bag."""
        self.assert_close(answer.attack, road.read_one(attacked, '/attack'))

    def offline(self, collision_type, mode, seed=0, nows=(6.0, 4.0, 8.0, 10.0), ttas=(4.0, 6.0, 2.0),
                believable='false'):
        """Return t0, TTA and bag of the first request that forge inject solves with a recorded vehicle."""
        out = self.path('{}_{}.bag'.format(collision_type, mode))
        for now in nows:
            for tta in ttas:
                result = road.inject(self.bag(self.SCENES[0]), out, collision_type, tta, now, '--mode', mode,
                                     '--seed', seed, '--believable', believable, '--attacker', 'existing')
                if road.code_of(result) == 'OK':
                    return now, tta, out
        raise AssertionError('no {} in {} mode in {}'.format(collision_type, mode, self.SCENES[0]))


class WholeRoadTest(LiveTest):
    """Checks that responses and topics of the suite equal the output of forge inject for the same bag."""
    HEARD = ['/encoded_scene', '/agents', '/injected_agents', '/tested_report', '/map_markers', '/scene_markers',
             '/pattern_markers', '/attack_markers']

    def play_and_ask(self, collision_type, mode, seed, believable='false', **instants):
        """Request the attack of offline() live; return the response and the attacked bag."""
        now, tta, attacked = self.offline(collision_type, mode, seed, believable=believable, **instants)
        end = self.play_to(now).header.stamp
        answer = self.ask_until(lambda answer: answer.code == 0 and answer.attack.pattern.header.stamp == end, collision_type,
                                tta, mode=mode, seed=seed, believable=believable, choice='existing')
        self.assertEqual(answer.message, '')
        self.assert_answer(answer, attacked)
        self.assertTrue(answer.attack.report.verified)
        self.assert_request_published(answer, attacked)
        self.assert_paths_published(answer, road.read_one(attacked, '/attack_ego_path'), mode)
        return answer, attacked

    def assert_request_published(self, answer, attacked):
        """Check that attack_request equals the message in the bag, except for the fields about the bag."""
        listener = Listener('/attack_request')
        message = listener.wait(lambda message: message.header.stamp == answer.attack.header.stamp)
        listener.close()
        offline = road.read_one(attacked, '/attack_request')
        for field in ('request', 'method', 'version', 'configuration'):
            self.assert_close(getattr(message, field), getattr(offline, field), 0.0, field)

    def newest_path(self, topic, now):
        """Return the latched path of the attack at `now`."""
        listener = Listener(topic)
        path = listener.wait(lambda path: path.header.stamp == now)
        self.assertEqual(set(listener.latched), {True})
        listener.close()
        self.assertEqual({pose.header.frame_id for pose in path.poses} | {path.header.frame_id}, {'map'})
        return path

    def assert_paths_published(self, answer, recorded, mode):
        """Check the paths: the attacker's trajectory; the ego's recorded path in replay mode, else a predicted one."""
        now, points = answer.attack.header.stamp, answer.attack.trajectory.points
        path = self.newest_path('/attack_path', now)
        self.assertEqual([(pose.header.stamp, pose.pose.position) for pose in path.poses],
                         [(point.stamp, point.pose.position) for point in points])
        ego = self.newest_path('/attack_ego_path', now)
        if mode == 'replay':
            self.assert_close(ego, recorded)
        else:
            self.assert_close(ego.poses[0].pose, recorded.poses[0].pose, tolerance=1e-3)
            self.assertLess(abs((ego.poses[-1].header.stamp - points[-1].stamp).to_sec()), 0.11)

    def assert_published(self, answer):
        """Check that late subscribers receive the attack, too."""
        listener = Listener('/attack')
        message = listener.wait(lambda message: message.header.stamp == answer.attack.header.stamp)
        self.assert_close(message, answer.attack, tolerance=0.0)
        self.assertEqual(listener.latched, [True])
        listener.close()

    def assert_played_on(self, answer, attacked):
        """Continue the replay: the attacker is replaced in injected_agents, and tested_report has the outcome."""
        now, end = answer.attack.trajectory.points[0].stamp, answer.attack.trajectory.points[-1].stamp
        self.heard['/attack_markers'].wait(
            lambda markers: len(markers.markers) > 1 and markers.markers[-1].header.stamp == now)
        for topic in ('/injected_agents', '/tested_report'):
            self.heard[topic].clear()
        self.player.play_to((end - self.player.start).to_sec() + 1.0)
        last = min(end + rospy.Duration(1), self.player.messages[-1][2])
        recorded = {message.header.stamp for message, _ in road.read(self.bag(self.SCENES[0]), '/agents')}
        expected = {message.header.stamp: message for message, time in road.read(attacked, '/agents')
                    if now < time <= last and message.header.stamp in recorded}
        injected = self.heard['/injected_agents']
        until(lambda: expected.keys() <= {message.header.stamp for message in injected.all()}, 'the injected agents')
        tested = self.heard['/tested_report'].wait()
        offline = road.read_one(attacked, '/tested_report')
        for message in injected.all():
            if message.header.stamp in expected:
                self.assert_injected(message, expected.pop(message.header.stamp), offline)
        self.assertEqual(expected, {})
        self.assert_steady([now] + [message.header.stamp for message in injected.all()])

        self.assertEqual(tested.header.stamp, offline.header.stamp)
        self.assertEqual((tested.attacker_id, tested.contact), (offline.attacker_id, offline.contact))
        self.assertEqual(tested.limits_kept, offline.limits_kept)
        if offline.contact:
            self.assertLess(abs((tested.contact_time - offline.contact_time).to_sec()), SAME_CONTACT)
            self.assertLess(abs(road.angle_between(tested.relative_heading, offline.relative_heading)), 0.01)
            self.assertEqual((tested.ego_side, tested.attacker_side), (offline.ego_side, offline.attacker_side))
            self.assertAlmostEqual(tested.impact_speed, offline.impact_speed, delta=SAME_SPEED)
            self.assertAlmostEqual(tested.overlap, offline.overlap, delta=0.02)
        return tested

    def play_clock_to(self, seconds):
        """Play, stop the clock, and return the second scene_markers message after that."""
        self.player.play_to(seconds)
        self.player.publishers['/clock'].publish(Clock(self.player.start + rospy.Duration(seconds)))
        pictures = self.heard['/scene_markers']
        pictures.clear()
        until(lambda: len(pictures.all()) > 1, 'two pictures')
        return pictures.all()[1]

    def assert_crash_shown(self, attacked):
        """Check during playback that the boxes touch, deform as far as the engagement, then move as in the bag."""
        report = road.read_one(attacked, '/tested_report')
        self.assertTrue(report.contact)
        contact = (report.contact_time - self.player.start).to_sec()
        depths = []
        for step in range(-15, 25):
            picture = self.play_clock_to(contact + 0.02 * step)
            depths.append(depth_between(shown_box(picture, 'ego'), shown_box(picture, 'attacker')))
        self.assertLess(max(depths), ENGAGEMENT * report.impact_speed + MOST_OVERLAP, depths)
        self.assertGreater(min(depths[16:]), -MOST_GAP, depths)
        second_after = report.contact_time + rospy.Duration(1.0)
        markers = min((message for message, _ in road.read(attacked, '/attack_markers')),
                      key=lambda message: abs(message.markers[-1].header.stamp - second_after))
        picture = self.play_clock_to((markers.markers[-1].header.stamp - self.player.start).to_sec())
        for name in ('ego', 'attacker'):
            (place, yaw, _), (expected, expected_yaw, _) = shown_box(picture, name), shown_box(markers, name)
            self.assertLess(abs(place - expected), SAME_PLACE, name)
            self.assertLess(abs(road.angle_between(yaw, expected_yaw)), 0.05, name)

    def assert_injected(self, actual, expected, report):
        """Check that a frame equals that in the bag, after the contact within the tolerance of the contact time."""
        self.assert_close(actual.header, expected.header)
        self.assertEqual(len(actual.agents), len(expected.agents))
        is_after = report.contact and actual.header.stamp.to_sec() > report.contact_time.to_sec() - SAME_CONTACT
        for agent, other in zip(actual.agents, expected.agents):
            slides = is_after and agent.id == report.attacker_id
            self.assert_close(agent, other, tolerance=SAME_SLIDE if slides else 1e-6)

    def assert_steady(self, stamps):
        """Check that stamps increase by the frame interval; before a recorded frame by 0.5 to 1.5 of it."""
        for before, after in zip(stamps, stamps[1:]):
            self.assertGreater(after, before)
            self.assertLess((after - before).to_sec(), 1.5 / RATE + 1e-3)

    def check(self, collision_type, mode, seed, believable='false'):
        answer, attacked = self.play_and_ask(collision_type, mode, seed, believable)
        self.assert_published(answer)
        tested = self.assert_played_on(answer, attacked)
        if mode == 'replay':
            self.assertTrue(tested.verified, 'the recorded ego is hit as foreseen:\n{}'.format(tested))


def kill_node(name):
    """Kill a node (SIGKILL), so that it cannot sign off."""
    os.kill(pid_of(name), signal.SIGKILL)


def pid_of(name):
    """Return the process of a registered node; OSError if it does not respond."""
    _, _, pid = ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode('/' + name)).getPid(rospy.get_name())
    return pid


def main(name):
    """Run the tests of the calling script; `name`: of the node, and test-name in the rostest file."""
    import rostest
    os.environ.pop('PYTHONUNBUFFERED', None)  # with it, a node whose output stays in a buffer would not be detected
    rospy.init_node(name)
    rostest.rosrun(road.PACKAGE, name, '__main__')
