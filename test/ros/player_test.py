#!/usr/bin/python3
"""The node `player`: alone, and in replay.launch with the suite."""
import math
import os
import subprocess
import threading
import time

import rosbag
import rosgraph
import rospy
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Bool, Float64
from std_srvs.srv import SetBool, Trigger

import live
import road
from collision_forge import CollisionForge
from collision_forge.msg import AgentArray
from collision_forge.srv import Seek
from collision_forge.suite import Program
from live import until

SCENE, TYPE, NOW, TTA = 'scene-0007', 'lane_change', 4.0, 4.0
START_TIMEOUT = 60.0  # s
STOPPED = 4.0  # s after the contact, when the attacker is at rest
# A node that gets SIGINT while its main thread holds the lock of a message queue.
INTERRUPTED = """
import os, signal, sys, time
import rospy
from std_msgs.msg import Bool
from collision_forge.node import run_node

def work():
    publisher = rospy.Publisher('interrupted', Bool, queue_size=0)
    subscriber = rospy.Subscriber('interrupted', Bool, lambda message: None)
    while not publisher.impl.connections:
        time.sleep(0.01)
    with publisher.impl.connections[0]._lock:
        os.kill(os.getpid(), signal.{})
        time.sleep(10.0)
    return 1

sys.exit(run_node('interrupted', work))
"""


class Heard:
    """Messages of a topic received since the last clear()."""

    def __init__(self, topic, message_class):
        self.messages = []
        self.lock = threading.Lock()
        self.subscriber = rospy.Subscriber(topic, message_class, self.receive)

    def receive(self, message):
        with self.lock:
            self.messages.append(message)

    def all(self):
        with self.lock:
            return list(self.messages)

    def clear(self):
        with self.lock:
            self.messages.clear()


class PlayerTest(road.RoadTest):
    SCENES = [SCENE]

    def hear(self):
        self.clock, self.agents, self.paused = heard = [
            Heard('/clock', Clock), Heard('/agents', AgentArray), Heard('/player/paused', Bool)]
        for one in heard:
            self.addCleanup(one.subscriber.unregister)

    def times(self):
        return [message.clock for message in self.clock.all()]

    def wait_for_state(self, is_paused):
        until(lambda: self.paused.all() and self.paused.all()[-1].data == is_paused,
              'paused {}'.format(is_paused), START_TIMEOUT)

    @staticmethod
    def wait_until_still(look):
        """Wait until two successive calls of `look` are equal, so that pending messages have arrived."""
        def is_still():
            before = look()
            time.sleep(0.3)
            return look() == before
        until(is_still, 'no change', START_TIMEOUT)

    def frames(self):
        """Return (record time, stamp) of each frame of agents in the bag."""
        return [(time_of, message.header.stamp) for message, time_of in road.read(self.bag(SCENE), '/agents')]


class PlayerAloneTest(PlayerTest):
    def setUp(self):
        rospy.set_param('/use_sim_time', True)
        self.forget_parameters()
        self.hear()

    @staticmethod
    def forget_parameters():
        """Delete the parameters of the previous test's player."""
        if rospy.has_param('/player'):
            rospy.delete_param('/player')

    def command(self, *arguments):
        return ['/usr/bin/rosrun', road.PACKAGE, 'player', '_delay:=0.5'] + list(arguments)

    def refusal(self, *arguments):
        result = subprocess.run(self.command(*arguments), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                stdin=subprocess.DEVNULL, universal_newlines=True, timeout=START_TIMEOUT, check=False)
        self.forget_parameters()
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertEqual(len(result.stdout.strip().splitlines()), 1, result.stdout)
        return result.stdout

    def test_a_bag_that_cannot_be_played_is_named_in_one_line(self):
        text = self.path('text.bag')
        text.write_text('no bag\n')
        empty = self.path('empty.bag')
        road.copy_bag(self.bag(SCENE), empty, lambda topic, message: None if topic == '/agents' else message)
        self.assertIn('/nowhere.bag cannot be read', self.refusal('_bag:=/nowhere.bag'))
        self.assertIn('text.bag cannot be read', self.refusal('_bag:={}'.format(text)))
        self.assertIn('empty.bag has no frame of /agents', self.refusal('_bag:={}'.format(empty)))
        self.assertIn('the parameter bag is empty', self.refusal())

    def test_a_bag_that_is_cut_while_it_plays_is_named_in_one_line(self):
        cut = self.path('cut.bag')
        with rosbag.Bag(str(self.bag(SCENE))) as bag, rosbag.Bag(str(cut), 'w', chunk_threshold=20000) as chunks:
            for topic, message, stamp in road.messages_of(bag):
                chunks.write(topic, message, stamp)

        def truncate():
            until(self.agents.all, 'the first frame of agents')
            os.truncate(str(cut), cut.stat().st_size // 2)
        thread = threading.Thread(target=truncate)
        thread.start()
        self.addCleanup(thread.join)
        self.assertIn('cut.bag cannot be read', self.refusal('_bag:={}'.format(cut)))

    def test_pauses_at_the_end_and_restarts_when_resumed(self):
        frames = self.frames()
        with Program(self.command('_bag:={}'.format(self.bag(SCENE)), '_rate:=10', '_loop:=false'), self.path('log')):
            self.wait_for_state(False)
            self.wait_for_state(True)
            until(lambda: self.times()[-1] >= frames[-1][0], 'the end')
            self.assertEqual([message.header.stamp for message in self.agents.all()], [stamp for _, stamp in frames])
            self.clock.clear()
            self.agents.clear()
            self.assertFalse(rospy.ServiceProxy('/player/step', Trigger)().success)
            self.assertTrue(rospy.ServiceProxy('/player/pause', SetBool)(False).success)
            until(lambda: len(self.agents.all()) > 1, 'frames of agents')
            self.assertEqual(self.agents.all()[0].header.stamp, frames[0][1])

    def test_ends_when_interrupted_while_publishing(self):
        for number in ('SIGINT', 'SIGTERM'):
            result = subprocess.run(['/usr/bin/python3', '-c', INTERRUPTED.format(number)], stdin=subprocess.DEVNULL,
                                    timeout=START_TIMEOUT, check=False)
            self.assertEqual(result.returncode, 0, number)

    def test_begins_anew_at_the_end_with_loop(self):
        with Program(self.command('_bag:={}'.format(self.bag(SCENE)), '_rate:=10', '_loop:=true'), self.path('log')):
            first = self.frames()[0][1]
            until(lambda: [message.header.stamp for message in self.agents.all()].count(first) == 2, 'the second time')
            self.assertEqual(len([stamp for stamp in self.agents.all()[:len(self.frames())]
                                  if stamp.header.stamp == first]), 1)

    def test_a_start_outside_the_bag_is_refused_with_the_bags_length(self):
        said = self.refusal('_bag:={}'.format(self.bag(SCENE)), '_start:=20.5')
        self.assertIn('the parameter start is', said)
        self.assertIn('0 to 20', said)


class ReplayStartTest(PlayerTest):
    """replay.launch with only a bag."""

    def test_waits_at_a_time_with_history_and_logs_how_to_continue(self):
        self.hear()
        start = next(stamp for time_of, stamp in self.frames() if (time_of - self.frames()[0][0]).to_sec() > 4.99)
        with Program(['roslaunch', road.PACKAGE, 'replay.launch', 'bag:={}'.format(self.relative()), 'rviz:=false'],
                     self.path('log')) as suite, CollisionForge(START_TIMEOUT) as forge:
            self.wait_for_state(True)
            until(lambda: self.agents.all()[-1].header.stamp == start, 'the frame at the start')
            until(lambda: 'paused at 5.0 s of scene-0007.bag of 20.0 s' in suite.output(), 'a line on the terminal')
            self.assertIn('rosservice call /player/pause false', suite.output())
            forge.wait_until_ready()
            attack = forge.generate(TYPE, TTA, believable='false')
            self.assertEqual(attack.now, start)

    def relative(self):
        """Return the bag's path relative to the folder of the launch."""
        return os.path.relpath(str(self.bag(SCENE)), os.environ.setdefault('PWD', os.getcwd()))


class AttackedReplayTest(PlayerTest):
    """replay.launch with a bag that has an attack."""

    def setUp(self):
        self.hear()
        self.attacked = self.path('attacked.bag')
        result = road.inject(self.bag(SCENE), self.attacked, TYPE, TTA, NOW, '--mode', 'history')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.suite = Program(['roslaunch', road.PACKAGE, 'replay.launch', 'bag:={}'.format(self.attacked),
                              'rviz:=false', 'rate:=2'], self.path('log'))
        self.addCleanup(self.suite.stop)
        self.wait_for_state(True)

    def publishers_of(self, topic):
        publishers = dict(rosgraph.Master(rospy.get_name()).getSystemState()[0])
        return publishers[topic]

    def test_the_attack_of_the_bag_is_shown_once_with_its_report_and_stays_the_only_one(self):
        for topic in ('/attack_markers', '/map_markers', '/tested_report'):
            self.assertEqual(len(self.publishers_of(topic)), 1, topic)
        attacks, reports = live.Listener('/attack'), live.Listener('/tested_report')
        for listener in (attacks, reports):
            self.addCleanup(listener.close)
        attack = attacks.wait()
        self.assert_close(attack, road.read_one(self.attacked, '/attack'))
        answer = live.ask(TYPE, TTA)
        self.assertEqual(road.CODES[answer.code], 'NO_RECORDING')
        self.assertIn('already has an attack', answer.message)
        self.assertIn('scene-0007.bag', answer.message)
        rospy.ServiceProxy('/player/pause', SetBool)(False)
        self.assert_close(reports.wait(), road.read_one(self.attacked, '/tested_report'))
        self.assertEqual(attacks.all()[-1].trajectory.attacker_id, attack.trajectory.attacker_id)


class ReplayTest(PlayerTest):
    """replay.launch, controlled as by a user."""

    def setUp(self):
        self.hear()
        self.suite = Program(['roslaunch', road.PACKAGE, 'replay.launch', 'bag:={}'.format(self.bag(SCENE)),
                              'start:=0', 'rviz:=false', 'rate:=2'], self.path('log'))
        self.addCleanup(self.suite.stop)
        self.wait_for_state(True)
        self.forge = CollisionForge(START_TIMEOUT)
        self.addCleanup(self.forge.close)

    def call(self, name, *arguments):
        kind = SetBool if name == 'pause' else Trigger
        return rospy.ServiceProxy('/player/' + name, kind)(*arguments)

    def step_to(self, seconds):
        """Step to the first frame after `seconds`; return its stamp."""
        end = next(frame for frame in self.frames() if (frame[0] - self.frames()[0][0]).to_sec() > seconds - 0.01)
        until(lambda: self.call('step').success and self.times()[-1] >= end[0], 'the frame', interval=0.1)
        return end[1]

    def test_services_step_seek_and_play(self):
        self.check_steps()
        self.check_seeks()
        self.check_plays()

    def check_steps(self):
        """Steps lead from the first frame, which is shown at the start, to the next ones."""
        frames = self.frames()
        self.assertEqual(self.agents.all()[-1].header.stamp, frames[0][1])
        for time_of, stamp in frames[1:4]:
            answer = self.call('step')
            self.assertTrue(answer.success)
            self.assertIn('paused at', answer.message)
            until(lambda: self.agents.all()[-1].header.stamp == stamp, 'the next frame')
            until(lambda: self.times()[-1] == time_of, 'its time')
        self.assertTrue(self.paused.all()[-1].data)
        time.sleep(0.3)
        self.assertEqual(self.times()[-1], frames[3][0], 'time stands still')

    def check_seeks(self):
        """Seeks forwards and backwards, and publishes the position."""
        position = Heard('/player/position', Float64)
        self.addCleanup(position.subscriber.unregister)
        seek = rospy.ServiceProxy('/player/seek', Seek)
        frames = self.frames()
        length = rospy.wait_for_message('/player/length', Float64, START_TIMEOUT).data
        self.assertAlmostEqual(length, (frames[-1][0] - frames[0][0]).to_sec(), places=6)
        for instant in (6.0, 2.25):
            answer = seek(instant)
            self.assertTrue(answer.success, answer.message)
            self.assertIn('paused at', answer.message)
            until(lambda: position.all() and abs(position.all()[-1].data - instant) < 1e-6, 'the position')
            self.assertAlmostEqual((self.times()[-1] - frames[0][0]).to_sec(), instant, places=6)
            shown = [stamp for time_of, stamp in frames if (time_of - frames[0][0]).to_sec() <= instant]
            until(lambda: self.agents.all()[-1].header.stamp == shown[-1], 'the newest frame')
        for instant in (-1.0, length + 1.0, math.nan):
            answer = seek(instant)
            self.assertFalse(answer.success)
            self.assertIn('is outside the bag: 0 to', answer.message)

    def check_plays(self):
        """Plays with an even clock until it is paused."""
        self.assertTrue(self.call('pause', False).success)
        self.wait_for_state(False)
        self.clock.clear()
        time.sleep(2.0)
        times = self.times()
        self.call('pause', True)
        self.wait_for_state(True)
        self.assertEqual(times, sorted(times))
        self.assertAlmostEqual((times[-1] - times[0]).to_sec(), 4.0, delta=1.0)  # at twice the speed
        self.assertGreater(len(times), 60)
        steps = sorted((after - before).to_sec() for before, after in zip(times, times[1:]))
        self.assertLess(steps[len(steps) * 9 // 10], 0.1)
        self.wait_until_still(lambda: self.times()[-1])
        stands = self.times()[-1]
        time.sleep(0.3)
        self.assertEqual(self.times()[-1], stands)

    def test_back_to_now_republishes_the_attack_and_accepts_a_new_request(self):
        now = self.step_to(NOW)
        first = self.forge.generate(TYPE, TTA, at=now)
        self.call('pause', False)
        report = self.forge.tested(first)
        self.agents.clear()
        answer = self.call('back_to_now')
        self.assertTrue(answer.success, answer.message)
        self.assertIn('paused at {:.1f} s'.format(NOW), answer.message)
        until(lambda: self.agents.all() and self.agents.all()[-1].header.stamp == now, 'the frame of now')
        self.assertEqual(self.forge.scene.message.header.stamp, now)
        self.assertEqual(self.times()[-1], dict((stamp, time_of) for time_of, stamp in self.frames())[now])
        self.wait_for_state(True)
        self.assertEqual(self.forge.attack, first, 'it is still shown')
        again = self.forge.generate(TYPE, TTA)
        self.assert_close(again.message.trajectory, first.message.trajectory, tolerance=0.0)
        self.call('pause', False)
        self.assertEqual(self.forge.tested(again).verified, report.verified)

    def test_an_attack_after_seeking_back_is_injected_and_tested_again(self):
        now = self.step_to(NOW)
        first = self.forge.generate(TYPE, TTA, at=now)
        reports = live.Listener('/tested_report')
        injected = live.Listener('/injected_agents')
        for listener in (reports, injected):
            self.addCleanup(listener.close)
        self.call('pause', False)
        reports.wait()
        reports.clear()
        self.call('back_to_now')
        self.call('pause', False)
        report = reports.wait()
        self.assertEqual(report.attacker_id, first.attacker)
        points = {point.stamp: point.pose.position for point in first.message.trajectory.points}
        driven = [(agent.pose.position, points[message.header.stamp]) for message in self.gone_back(injected, now)
                  if message.header.stamp in points for agent in message.agents if agent.id == first.attacker]
        self.assertGreater(len(driven), 5)
        for actual, planned in driven[:5]:
            self.assertLess(abs(actual.x - planned.x) + abs(actual.y - planned.y), 0.01)
        until(lambda: injected.all()[-1].header.stamp > report.contact_time + rospy.Duration(STOPPED), 'more frames')
        self.check_rate(injected, now)
        self.check_stands(injected, report, now)

    @staticmethod
    def gone_back(injected, now):
        """Return the messages after the player's step back to `now`: before it the attack was played once."""
        messages = injected.all()
        return messages[max(index for index, message in enumerate(messages) if message.header.stamp == now):]

    def check_stands(self, injected, report, now):
        """Check that the attacker leaves its trajectory at the contact and decelerates to a stop."""
        self.assertTrue(report.contact)
        driven = [(message.header.stamp, agent) for message in self.gone_back(injected, now)
                  for agent in message.agents if agent.id == report.attacker_id]
        speeds = [math.hypot(agent.velocity.x, agent.velocity.y) for stamp, agent in driven
                  if stamp > report.contact_time]
        self.assertEqual(speeds, sorted(speeds, reverse=True))
        self.assertLess(speeds[-1], 1e-6)
        self.assertEqual(driven[-1][1].pose, driven[-2][1].pose)

    def check_rate(self, injected, now):
        """Check that frames come at 10 Hz of the bag's time from t0 on, and none during a pause."""
        self.call('pause', True)
        self.wait_for_state(True)
        self.wait_until_still(lambda: len(injected.all()))
        stamps = [message.header.stamp for message in self.gone_back(injected, now)]
        self.assertEqual(stamps, sorted(set(stamps)))
        self.assertAlmostEqual((len(stamps) - 1) / (stamps[-1] - stamps[0]).to_sec(), 10.0, delta=0.5)
        self.assertLess(max(after - before for before, after in zip(stamps, stamps[1:])).to_sec(), 0.151)
        count = len(injected.all())
        time.sleep(0.5)
        self.assertEqual(len(injected.all()), count)


if __name__ == '__main__':
    live.main('player_test')
