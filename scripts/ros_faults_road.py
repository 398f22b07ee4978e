"""A master, the suite and a player for scripts/ros_faults, and the results of their services without disturbance."""
import math
import os
import signal
import subprocess
import threading
import time
from pathlib import Path
from xmlrpc.client import Error, ServerProxy

import rosbag
import rosgraph
import rospy

from collision_forge import srv
from collision_forge.msg import CollisionRequest

RATE = 2              # speed of the replay
OK, LAST_CODE = 0, 16  # codes
RECOVERS_IN = 30.0    # s until the results are as before
ANSWERS_IN = 30.0     # s; longest duration of a call under any disturbance
ENDS_IN = 30.0        # s until a launch has ended
STARTS_IN = 60.0      # s
STAYS_FOR = 3.0       # s without a difference until the suite counts as recovered
STANDS_AFTER = 2.0    # s with the same frame, after which time counts as stopped


class Failure(Exception):
    """The suite did not behave as expected."""


def until(condition, seconds, what):
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            raise Failure('no {} within {:g} s'.format(what, seconds))
        time.sleep(0.1)


def children(parent):
    """Return (pid, command line) of the child processes of `parent`."""
    found = []
    for folder in Path('/proc').glob('[0-9]*'):
        try:
            if int((folder / 'stat').read_text().rsplit(')', 1)[1].split()[1]) == parent:
                found.append((int(folder.name), (folder / 'cmdline').read_bytes().decode().split('\0')))
        except OSError:
            pass  # it has ended meanwhile
    return found


def in_time(what, work):
    """Return the result of `work`; raise Failure if it takes longer than ANSWERS_IN."""
    results = []
    thread = threading.Thread(target=lambda: results.append(work()), daemon=True)
    thread.start()
    thread.join(ANSWERS_IN)
    if not results:
        raise Failure('{} neither responds nor fails within {:g} s'.format(what, ANSWERS_IN))
    return results[0]


def call(name, service, request):
    """Return the response of a service, None if the call fails; raise Failure after ANSWERS_IN."""
    def ask():
        try:
            return rospy.ServiceProxy(name, service)(request)
        except (rospy.ServiceException, rospy.ROSException, OSError):
            return None
    return in_time(name, ask)


def check(answer):
    """Raise Failure unless a response is OK or has a reason, and each attack is verified and begins at t0."""
    if answer.code > LAST_CODE or (answer.code != OK and not answer.message):
        raise Failure('code {} is unknown or message "{}" is empty'.format(answer.code, answer.message))
    for one in answer.answers:
        points = [number for point in one.attack.trajectory.points
                  for number in (point.pose.position.x, point.pose.position.y, point.speed)]
        good = one.attack.header.stamp == answer.now and one.attack.report.verified and len(points) > 0
        if one.code > LAST_CODE or not all(map(math.isfinite, points)) or (one.code == OK) != good:
            raise Failure('invalid result: {}'.format(one))


class Road:
    """The running processes: a master, the suite and a player."""

    def __init__(self, bag, port):
        self.bag, self.log, self.port = bag, bag.parent / 'log', port
        self.running, self.nodelets, self.suite_is = {}, 'true', None
        self.expected, self.graph = {}, set()  # responses by stamp; registrations of the nodes
        with rosbag.Bag(str(self.bag)) as bag:
            self.stamps = [message.header.stamp for _, message, _ in bag.read_messages('/agents')]

    def start(self, name, *words):
        self.stop(name)
        with open(str(self.log), 'a') as log:
            self.running[name] = subprocess.Popen([str(word) for word in words], stdin=subprocess.DEVNULL, stdout=log,
                                                  stderr=log, start_new_session=True)

    def stop(self, name, how=signal.SIGINT):
        process = self.running.pop(name, None)
        if process is None or process.poll() is not None:
            return
        started = [pid for pid, _ in children(process.pid)]
        for pid in [process.pid] + (started if how == signal.SIGKILL else []):
            os.killpg(os.getpgid(pid), how)
        process.wait(ENDS_IN)

    def stop_all(self):
        self.suite_is = None
        for name in ('player', 'suite', 'core'):
            self.stop(name)

    def start_core(self):
        self.start('core', 'roscore', '-p', self.port)
        until(rosgraph.is_master_online, STARTS_IN, 'master')

    def start_player(self, bag=None, words=()):
        """Start the suite's player, which publishes /clock; with wall time, start rosbag play."""
        bag = bag or self.bag
        if rospy.get_param('/use_sim_time') is False:
            self.start('player', 'rosbag', 'play', '--quiet', '--loop', '--delay', 3, '--rate', RATE, bag)
        else:
            self.start('player', 'rosrun', 'collision_forge', 'player', '_bag:={}'.format(bag), '_loop:=true',
                       '_rate:={}'.format(RATE), '_wait_for_suite:=true', *words)

    def start_suite(self, sim_time='true'):
        """Start the suite and a player, unless they run already."""
        if self.suite_is == (self.nodelets, sim_time) and self.running['suite'].poll() is None:
            return
        self.stop_all()
        self.start_core()
        self.graph = set()
        self.start('suite', 'roslaunch', '-p', self.port, 'collision_forge', 'collision_forge.launch',
                   'nodelets:=' + self.nodelets, 'sim_time:=' + sim_time, 'recording:={}'.format(self.bag))
        for name in ('generate_collisions', 'test_planner', 'predict_pattern', 'realize_trajectory'):
            rospy.wait_for_service(name, STARTS_IN)
        self.start_player()
        self.suite_is = self.nodelets, sim_time
        if not self.expected:
            self.learn()
        self.recover()
        self.graph = in_time('a node', self.registrations)[1]

    def processes(self):
        """Return the pids of the launch's processes by node name, without master_watch, whose end ends the launch."""
        named = [(word[len('__name:='):], pid) for pid, words in children(self.running['suite'].pid)
                 for word in words if word.startswith('__name:=')]
        return {name: pid for name, pid in named if name != 'master_watch'}

    def ask(self, stamp=None):
        request = srv.GenerateCollisionsRequest(collision_types=['rear_end', 'lane_change'], ttas=[4.0],
                                                request=CollisionRequest(choice='existing', believable='false'))
        request.stamp = stamp or rospy.Time()
        answer = call('generate_collisions', srv.GenerateCollisions, request)
        if answer is not None:
            check(answer)
        return answer

    def learn(self):
        """Store the response at every frame of the bag, and of a planner test."""
        def is_known(stamp):
            answer = self.ask(stamp)
            if answer is not None and answer.code == OK:
                self.expected[answer.now] = answer
            return stamp in self.expected
        for stamp in self.stamps:
            until(lambda: is_known(stamp), STARTS_IN, 'answer at {}'.format(stamp))
        self.attack = next(one.attack for answer in self.expected.values() for one in answer.answers if one.code == OK)
        self.drive = self.test()
        if self.drive is None or self.drive.code != OK:
            raise Failure('the planner test failed without disturbance: {}'.format(self.drive))

    def test(self):
        """Return the response of test_planner for the first attack, without its run times; None if the call fails."""
        request = srv.TestPlannerRequest(planner='idm', trajectory=self.attack.trajectory,
                                         collision_type=self.attack.pattern.collision_type)
        answer = call('test_planner', srv.TestPlanner, request)
        if answer is not None:
            answer.outcome.mean_call_time = answer.outcome.max_call_time = 0.0
        return answer

    def is_same(self, answer):
        return answer is not None and answer.code == OK and str(answer) == str(self.expected[answer.now])

    def recover(self):
        """Return the seconds until all results are as before, and stay so for STAYS_FOR while time advances."""
        begin = last_bad = moved = time.monotonic()
        now, attacks = None, 0
        while time.monotonic() - last_bad < STAYS_FOR or attacks == 0:
            answer = self.ask()
            if answer is not None and answer.now != now:
                now, moved = answer.now, time.monotonic()
            stands = time.monotonic() - moved > STANDS_AFTER
            if not stands and self.is_same(answer) and str(self.test()) == str(self.drive) and self.is_registered():
                attacks += OK in [one.code for one in answer.answers]
            else:
                last_bad, attacks = time.monotonic(), 0
            if last_bad - begin > RECOVERS_IN:
                raise Failure('not recovered within {:g} s: {}'.format(RECOVERS_IN, answer and answer.message))
            time.sleep(0.1)
        return last_bad - begin

    def registrations(self):
        """Return pids by node, and the nodes' registrations at the master; both are empty if a node is gone."""
        master = rosgraph.Master('/ros_faults')
        try:
            pids = {name: ServerProxy(master.lookupNode('/' + name)).getPid('/ros_faults')[2]
                    for name in self.processes()}
            return pids, {(kind, name, node) for kind, entries in enumerate(master.getSystemState())
                          for name, nodes in entries for node in nodes if node[1:] in pids}
        except (OSError, Error, rosgraph.MasterException):
            return {}, set()

    def is_registered(self):
        """Return True if every node is a live process with all its first publishers, subscribers and services."""
        pids, graph = in_time('a node', self.registrations)
        return pids == self.processes() and graph >= self.graph
