#!/usr/bin/python3
"""Every node as a process of its own: alone, all together, and killed."""
import os
import signal
import subprocess
import time

import live
import road
from live import NODES, ask, until

ANSWER_LIMIT = 10.0  # s within which the generator must notice that a node is missing
FROZEN_LIMIT = 30.0  # s; as above, for a node that runs but does not respond


class NodeAloneTest(road.RoadTest):
    """rosrun of one node: it has its topics and services, and ends on a signal."""

    def run_node(self, name, *arguments):
        with open(str(self.path('log')), 'w') as log:
            process = subprocess.Popen(['/usr/bin/rosrun', road.PACKAGE, name] + list(arguments), stdout=log,
                                       stdin=subprocess.DEVNULL, stderr=subprocess.STDOUT)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def check(self, name):
        process = self.run_node(name)
        until(lambda: process.poll() is not None or not live.missing_of([name]),
              lambda: '{}\n{}'.format(live.missing_of([name]), self.path('log').read_text()))
        self.assertIsNone(process.poll(), self.path('log').read_text())
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(live.TIMEOUT), 0, self.path('log').read_text())
        left = [(entry, node) for registered in live.graph() for entry, node in registered if node == name]
        self.assertEqual(left, [], 'it has said goodbye to the master')

    def test_unknown_configuration_is_refused(self):
        process = self.run_node('pattern_predictor', '_config_dir:=/nowhere')
        self.assertNotEqual(process.wait(live.TIMEOUT), 0)
        self.assertIn('/nowhere', self.path('log').read_text())

    def test_weights_that_are_not_there_are_named(self):
        config = self.path('config')
        config.mkdir()
        (config / 'models.yaml').write_text('models: {speed_model: gone.jsonl}\n')
        process = self.run_node('pattern_predictor', '_config_dir:={}'.format(config))
        self.assertNotEqual(process.wait(live.TIMEOUT), 0)
        self.assertIn('no prediction models: {}'.format(config), self.path('log').read_text())


def add_node_tests():
    for name in NODES:
        setattr(NodeAloneTest, 'test_' + name, lambda self, name=name: self.check(name))


add_node_tests()


class SeparateNodesTest(live.WholeRoadTest):
    SCENES = ['scene-0003']
    ARGUMENTS = {'nodelets': 'false'}

    def test_every_node_is_its_own_process(self):
        self.assertEqual(len({live.pid_of(name) for name in NODES}), len(NODES))

    def test_no_node_does_more_than_NODES_tells(self):
        of_roscpp = ['/rosout', '/clock']
        more = [(node, name) for i, registered in enumerate(live.graph()) for name, node in sorted(registered)
                if node in NODES and name not in NODES[node][i] + of_roscpp and not name.startswith('/' + node + '/')]
        self.assertEqual(more, [])

    def test_rear_end_as_offline(self):
        answer, attacked = self.play_and_ask('rear_end', 'replay', 3)
        self.assert_published(answer)
        self.assert_played_on(answer, attacked)

    def check_killed(self, name):
        """The response reports a missing node in bounded time; after its restart it has the same attack as before."""
        answer, attacked = self.play_and_ask('lane_change', 'history', 1)
        _, tta, _ = self.offline('lane_change', 'history', 1)
        self.suite.process.send_signal(signal.SIGSTOP)  # delays the restart of the node
        self.addCleanup(self.suite.process.send_signal, signal.SIGCONT)
        live.kill_node(name)
        start = time.monotonic()
        self.assertEqual(road.CODES[ask('lane_change', tta, seed=1).code], 'NODE_UNAVAILABLE')
        self.assertLess(time.monotonic() - start, ANSWER_LIMIT)
        self.assertIn(NODES[name][2][0], ask('lane_change', tta, seed=1).message)
        self.suite.process.send_signal(signal.SIGCONT)
        again = self.ask_for_code('OK', 'lane_change', tta, seed=1)
        self.assertEqual(again.attack.trajectory.points, answer.attack.trajectory.points)
        self.assert_answer(again, attacked)

    def check_frozen(self, name):
        """A node that does not respond does not block the caller, and is used again when it continues."""
        _, attacked = self.play_and_ask('lane_change', 'history', 1)
        _, tta, _ = self.offline('lane_change', 'history', 1)
        pid = live.pid_of(name)
        os.kill(pid, signal.SIGSTOP)
        self.addCleanup(os.kill, pid, signal.SIGCONT)
        start = time.monotonic()
        self.assertEqual(road.CODES[ask('lane_change', tta, seed=1).code], 'NODE_UNAVAILABLE')
        self.assertLess(time.monotonic() - start, FROZEN_LIMIT)
        os.kill(pid, signal.SIGCONT)
        self.assert_answer(self.ask_for_code('OK', 'lane_change', tta, seed=1), attacked)

    def test_frozen_pattern_predictor(self):
        self.check_frozen('pattern_predictor')

    def test_killed_pattern_predictor(self):
        self.check_killed('pattern_predictor')

    def check_restarted(self, name):
        """A killed node is restarted and connected to all others, and the pipeline works again."""
        pid = live.pid_of(name)
        live.kill_node(name)
        self.suite.wait_until_back(name, pid)
        self.player.connect(self.suite, self.heard)
        answer, attacked = self.play_and_ask('rear_end', 'history', 4)
        self.assert_published(answer)
        self.assert_played_on(answer, attacked)

    def test_restarted_collision_generator(self):
        self.check_restarted('collision_generator')


if __name__ == '__main__':
    live.main('nodes_test')
