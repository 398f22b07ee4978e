#!/usr/bin/python3
"""planner_tester: built-in planners and planner nodes, tested with scenarios and trajectories."""
import copy
import json
import math
import subprocess
import time
from pathlib import Path

import rosgraph
import rospy

import live
import road
from collision_forge.msg import Attack, LaneMap, PlannerOutcome, PlannerParameter
from collision_forge.srv import TestPlanner, TestPlannerRequest, TestPlannerResponse
from live import until
from road import DATAROOT, VERSION
from geometry_msgs.msg import PolygonStamped
from nav_msgs.msg import Path as DrivenPath
from std_msgs.msg import Bool
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

ROOT = ('--dataroot', DATAROOT, '--version', VERSION)
PLANNERS = ['idm', 'rule_based', 'pdm', 'torchscript']
GOOD_TICKS = 5  # valid plans of odd_planner.py
SILENCE = 3.0  # s after which an external planner counts as silent; the good ticks take milliseconds
CODES = {value: name for name, value in vars(TestPlannerResponse).items() if name.isupper() and isinstance(value, int)}


def start(folder, *command):
    with open(str(folder / 'nodes.log'), 'a') as log:
        return subprocess.Popen([str(word) for word in command], stdout=log, stdin=subprocess.DEVNULL,
                                stderr=subprocess.STDOUT)


class PlannerTesterTest(road.RoadTest):
    SCENES = ['scene-0001']

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        requests, cls.scenarios = cls.folder / 'requests.jsonl', cls.folder / 'crashes.jsonl'
        for result in (road.run('requests', *ROOT, '--out', requests, '--scene', 'scene-0001', 'scene-0007',
                                '--stride', 8, '--tta', 2, 4),
                       road.run('generate', *ROOT, '--requests', requests, '--out', cls.scenarios, '--mode', 'replay'),
                       road.run('test', *ROOT, '--scenarios', cls.scenarios, '--planners', ','.join(PLANNERS),
                                '--attacker-policy', 'fixed,adaptive', '--out', cls.folder / 'bulk', '--worst', 0)):
            assert result.returncode == 0, result.stderr
        cls.lines = cls.scenarios.read_text().splitlines()
        cls.bulk = [json.loads(line) for line in (cls.folder / 'bulk' / 'results.jsonl').read_text().splitlines()]
        cls.tested = [number for number, result in enumerate(cls.bulk, 1) if result['status'] == 'OK']
        cls.node = start(cls.folder, '/usr/bin/rosrun', road.PACKAGE, 'planner_tester', '_source:={}'.format(DATAROOT),
                         '_version:=' + VERSION, '_scenarios:={}'.format(cls.scenarios),
                         '_recording:={}'.format(cls.folder / 'scene-0001.bag'))
        cls.addClassCleanup(cls.node.wait)
        cls.addClassCleanup(cls.node.terminate)
        until(lambda: not live.missing_of(['planner_tester']), lambda: (cls.folder / 'nodes.log').read_text())

    def ask(self, code='OK', parameters=(), **fields):
        request = TestPlannerRequest(parameters=[PlannerParameter(*entry) for entry in parameters], **fields)
        answer = rospy.ServiceProxy('/test_planner', TestPlanner)(request)
        self.assertEqual(CODES[answer.code], code, answer.message)
        self.assertEqual(answer.message == '', code == 'OK')
        return answer

    def outcome(self, **fields):
        return self.ask(**fields).outcome

    def attack(self):
        """Return an attack of forge inject on the recording."""
        attacked = self.path('attacked.bag')
        if not attacked.exists():
            result = road.inject(self.bag('scene-0001'), attacked, 'rear_end', 4, 8, '--mode', 'replay')
            self.assertEqual(result.returncode, 0, result.stderr)
        return road.read_one(attacked, '/attack')

    def run_external(self, *command):
        """Run a planner node until the test ends."""
        name = self.id().rsplit('.', 1)[-1]
        node = start(self.folder, *command, '__name:=' + name)
        self.addCleanup(node.wait)
        self.addCleanup(self.forget, name)
        self.addCleanup(node.wait)
        self.addCleanup(node.terminate)
        until(lambda: all(entry in registered for entry, registered in zip(
            (('/planned_trajectory', name), ('/planning_state', name)), live.graph())), name)

    @staticmethod
    def forget(name):
        """Unregister a node that may have been killed."""
        master = rosgraph.Master('/' + name)
        if ('/planned_trajectory', name) in live.graph()[0]:
            uri = master.lookupNode('/' + name)
            master.unregisterPublisher('/planned_trajectory', uri)
            master.unregisterSubscriber('/planning_state', uri)

    # Planners of the suite.

    def test_every_planner_drives_as_in_bulk(self):
        contacts, escaped = 0, 0
        for number in self.tested[:6]:
            result = self.bulk[number - 1]
            for row in result['planners']:
                policy = row['attacker']['policy']
                outcome = self.outcome(scenario=str(number), planner=row['planner'], attacker_policy=policy)
                self.assertEqual(outcome.planner, row['planner'])
                self.assertEqual(outcome.attacker_policy, policy)
                self.assertEqual(outcome.attacker_phase, row['attacker']['phase'])
                self.assertEqual(outcome.attacker_plans, row['attacker']['plans'])
                self.assertEqual(outcome.failure, row['failure'])
                self.assertEqual(outcome.collided, row['contact'] is not None)
                for name in ('duration', 'max_braking', 'hard_braking', 'off_road_share', 'progress', 'recorded_progress'):
                    self.assertAlmostEqual(getattr(outcome, name), row[name], 6, name)
                self.assertEqual(outcome.ticks, row['plans'])
                known = result['avoidability'] if policy == 'fixed' else row['evasion']
                if known is not None:
                    self.assertEqual(outcome.avoidable, known['avoidable'])
                    self.assertEqual(outcome.avoided_by, known['from_now'])
                    escaped += policy == 'adaptive' and known['avoidable']
                if known is not None and outcome.avoidable:
                    last = known['last']
                    self.assertEqual(outcome.last_manoeuvre, last['manoeuvre'])
                    self.assertAlmostEqual((outcome.last_moment - outcome.header.stamp).to_sec(), last['start_t'], 5)
                if row['contact'] is not None:
                    contacts += 1
                    self.assert_contact(outcome, row['contact'])
                self.assertEqual(outcome.driven[0].stamp, outcome.header.stamp)
                self.assertAlmostEqual((outcome.driven[-1].stamp - outcome.header.stamp).to_sec(), row['duration'], 6)
                self.assertGreater(outcome.mean_call_time, 0.0)
                self.assertGreaterEqual(outcome.max_call_time, outcome.mean_call_time)
        self.assertGreater(contacts, 3)
        self.assertGreater(escaped, 0)

    def assert_contact(self, outcome, contact):
        self.assertEqual((outcome.other_id, outcome.is_attacker, outcome.collision_type or None, outcome.ego_side,
                          outcome.other_side, outcome.cause, outcome.at_fault),
                         (contact['other'], contact['attacker'], contact['type'], contact['ego_side'],
                          contact['other_side'], contact['cause'], contact['at_fault']))
        self.assertAlmostEqual((outcome.contact_time - outcome.header.stamp).to_sec(), contact['t'], 5)
        self.assertAlmostEqual(outcome.impact_speed, contact['impact_speed'], 6)
        self.assertAlmostEqual(outcome.relative_heading, contact['relative_heading'], 6)

    def test_parameters_and_background_change_the_drive(self):
        number = self.tested[0]
        default = self.outcome(scenario=str(number), planner='idm')
        slow = self.outcome(scenario=str(number), planner='idm', parameters=[('idm.standard.time_headway', 20.0)])
        self.assertLess(slow.progress, default.progress - 0.5)
        again = self.outcome(scenario=str(number), planner='idm', background='replay')
        self.assert_close(again.driven, default.driven, 0.0)
        self.outcome(scenario=str(number), planner='idm', background='idm')

    def test_trajectories_are_tested_over_the_recording(self):
        attack = self.attack()
        trajectory = attack.trajectory
        outcome = self.outcome(trajectory=trajectory, collision_type='RE', planner='idm')
        self.assertEqual(outcome.header.stamp, trajectory.header.stamp)
        self.assertEqual(outcome.attacker_id, trajectory.attacker_id)
        self.ask('UNKNOWN_TYPE', trajectory=trajectory, collision_type='magic', planner='idm')
        self.ask('NO_SCENARIO', planner='idm')
        answer = self.ask('INVALID_INPUT', trajectory=trajectory, collision_type='RE', planner='idm',
                          attacker_policy='adaptive')
        self.assertIn('attacker_policy = adaptive', answer.message)
        publisher = rospy.Publisher('/attack', Attack, latch=True, queue_size=1)
        self.addCleanup(publisher.unregister)
        publisher.publish(attack)
        until(lambda: publisher.get_num_connections() > 0, 'planner_tester to hear')
        newest = []

        def is_answered():
            newest.append(rospy.ServiceProxy('/test_planner', TestPlanner)(TestPlannerRequest(planner='idm')))
            return CODES[newest[-1].code] == 'OK'
        until(is_answered, lambda: newest[-1].message)
        self.assert_close(newest[-1].outcome.driven, outcome.driven, 0.0)
        self.assertGreater(self.outcome(planner='idm', attacker_policy='adaptive').attacker_plans, 0)

    def test_what_was_tested_is_published_latched(self):
        number = self.tested[0]
        outcome = self.outcome(scenario=str(number), planner='pdm')
        self.assert_close(self.latched('/planner_outcome', PlannerOutcome), outcome, 0.0)
        path = self.latched('/planner_path', DrivenPath)
        self.assertEqual((path.header.frame_id, path.header.stamp), ('map', outcome.header.stamp))
        self.assertEqual([(pose.header.stamp, pose.pose.position) for pose in path.poses],
                         [(point.stamp, point.pose.position) for point in outcome.driven])
        markers = self.latched('/planner_markers', MarkerArray).markers
        names = {marker.ns for marker in markers}
        self.assertLessEqual({'ego_path', 'recorded_ego_path', 'attacker_path', 'proposals'}, names)
        ends = [marker for marker in markers if marker.ns == 'proposal_ends']
        self.assertEqual(len(ends), 15)
        lane_map = self.latched('/tested_map', LaneMap)
        self.assertGreater(len(lane_map.lanes), 0)
        frames = self.latched('/tf_static', TFMessage).transforms
        self.assertEqual(frames[0].child_frame_id, 'tested_ego')
        self.assertLess(math.hypot(frames[0].transform.translation.x - outcome.driven[0].pose.position.x,
                                   frames[0].transform.translation.y - outcome.driven[0].pose.position.y), 1.0)

    def test_the_rollout_is_shown_in_motion_with_its_outcome_at_the_end(self):
        drawn = live.Listener('/planner_scene_markers')
        self.addCleanup(drawn.close)
        outcome = self.outcome(scenario=str(self.tested[0]), planner='idm')
        self.assertTrue(self.latched('/planner_test_shown', Bool).data)
        drawn.wait(lambda array: any(marker.ns == 'report' and 'idm: ' in marker.text for marker in array.markers))
        egos = [(marker.pose.position.x, marker.pose.position.y) for array in drawn.all() for marker in array.markers
                if marker.ns == 'ego']
        for shown, driven in ((egos[0], outcome.driven[0]), (egos[-1], outcome.driven[-1])):
            self.assertLess(math.dist(shown, (driven.pose.position.x, driven.pose.position.y)), 3.0)
        self.assertGreater(len(set(egos)), 10)
        area = self.latched('/shown_area', PolygonStamped).polygon.points
        self.assertLess(min(point.x for point in area), egos[-1][0])
        self.assertGreater(max(point.x for point in area), egos[-1][0])

    @staticmethod
    def latched(topic, message_class):
        return rospy.wait_for_message(topic, message_class, live.TIMEOUT)

    # Requests that cannot be met.

    def test_bad_parameters(self):
        for parameters, words in (([('pdm.idm.magic', 1.0)], ['pdm.idm.magic', 'planners.yaml']),
                                  ([('pdm.idm.min_gap', -1.0)], ['pdm.idm.min_gap', '-1']),
                                  ([('pdm.idm.min_gap', math.nan)], ['pdm.idm.min_gap']),
                                  ([('pdm.idm', 1.0)], ['pdm.idm', 'not a number']),
                                  ([('pdm.idm.min_gap', 1.0), ('pdm.idm.min_gap', 2.0)], ['pdm.idm.min_gap', 'twice'])):
            answer = self.ask('BAD_PARAMETER', scenario=str(self.tested[0]), planner='pdm', parameters=parameters)
            for word in words:
                self.assertIn(word, answer.message)
        self.ask(scenario=str(self.tested[0]), planner='pdm', parameters=[('pdm.idm.min_gap', 2.0)])

    def test_bad_lines(self):
        line = self.lines[self.tested[0] - 1]
        scene = json.loads(line)['scene']
        for code, scenario, word in (('UNREADABLE', line.replace('"version":7', '"version":8'), 'version'),
                                     ('UNREADABLE', line.replace(scene, 'scene-9999'), 'scene-9999'),
                                     ('UNREADABLE', line[:100], 'scenario'),
                                     ('UNREADABLE', line + 16000000 * ' ', 'scenario: length = 160'),
                                     ('NO_SCENE', line.replace('"now":16', '"now":17'), 'frame'),
                                     ('NO_SCENARIO', '0', '1 to {}'.format(len(self.lines))),
                                     ('NO_SCENARIO', str(len(self.lines) + 1), '1 to {}'.format(len(self.lines))),
                                     ('NO_SCENARIO', 'third', 'third')):
            self.assertIn(word, self.ask(code, scenario=scenario, planner='idm').message)

    def test_a_relative_path_is_refused_at_start(self):
        for parameter in ('source', 'scenarios'):
            result = subprocess.run(['/usr/bin/rosrun', road.PACKAGE, 'planner_tester', '__name:=relative_' + parameter,
                                     '_{}:=data/here'.format(parameter)], stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT, universal_newlines=True, timeout=60, check=False)
            self.assertNotEqual(result.returncode, 0, result.stdout)
            self.assertIn('parameter {} = "data/here" is not an absolute path'.format(parameter), result.stdout)

    def test_declined_answers_keep_their_status(self):
        number, result = next((number, result) for number, result in enumerate(self.bulk, 1)
                              if result['status'] not in ('OK', 'NO_SCENE', 'INVALID_INPUT'))
        request = TestPlannerRequest(scenario=str(number), planner='idm')
        answer = rospy.ServiceProxy('/test_planner', TestPlanner)(request)
        self.assertEqual(road.CODES[answer.code], result['status'])
        self.assertIn(result['message'], answer.message)
        first = next(number for number, line in enumerate(self.lines, 1) if json.loads(line)['status']['code'] == 'OK')
        self.assertIn('the first line with an attack is {}'.format(first), answer.message)

    def test_bad_trajectories(self):
        trajectory = self.attack().trajectory

        def changed(change):
            message = copy.deepcopy(trajectory)
            change(message)
            return message

        def move_onto_the_ego(message):
            ego = min(road.read(self.bag('scene-0001'), '/odom'),
                      key=lambda entry: abs((entry[0].header.stamp - message.header.stamp).to_sec()))[0]
            message.points[0].pose = ego.pose.pose

        def shift(message):
            for point in message.points:
                point.stamp += rospy.Duration(0.1)
        for code, change, word in (
                ('UNFIT', move_onto_the_ego, 'touches the ego'),
                ('UNFIT', lambda message: message.points.__delitem__(slice(1, None)), 'two points'),
                ('NO_SCENE', shift, 'frame'),
                ('INVALID_INPUT', lambda message: setattr(message.size, 'x', 0.0), 'size'),
                ('INVALID_INPUT', lambda message: setattr(message.points[4].pose.position, 'x', math.nan), 'points[4]'),
                ('INVALID_INPUT', lambda message: setattr(message, 'agent_class', 77), '77')):
            answer = self.ask(code, trajectory=changed(change), collision_type='RE', planner='idm')
            self.assertIn(word, answer.message)

    # Planners in a node of their own.

    def ask_external(self, timeout=live.TIMEOUT, **fields):
        return self.outcome(scenario=str(self.tested[0]), planner='external',
                            parameters=[('external.timeout', timeout)], **fields)

    def odd(self, mode, **fields):
        self.run_external(Path(__file__).resolve().parent / 'odd_planner.py', mode)
        return self.ask_external(SILENCE if mode == 'never' else live.TIMEOUT, **fields)

    def assert_failed(self, outcome, failure, word):
        """The test ends with this failure after the valid plans, and the next test is not affected."""
        self.assertEqual(outcome.failure, failure, outcome.failure_message)
        self.assertIn(word, outcome.failure_message)
        self.assertFalse(outcome.collided)
        self.assertEqual(outcome.ticks, GOOD_TICKS + 1)
        self.assertAlmostEqual(outcome.duration, 0.1 * GOOD_TICKS, 6)
        self.assertEqual(self.outcome(scenario=str(self.tested[0]), planner='idm').failure, 'none')

    def test_external_planner_and_an_attacker_that_reacts_go_in_lock_step(self):
        self.run_external('/usr/bin/rosrun', road.PACKAGE, 'external_planner.py')
        first, second = (self.ask_external(attacker_policy='adaptive') for _ in range(2))
        self.assertEqual(first.failure, 'none', first.failure_message)
        self.assertGreater(first.attacker_plans, 1, 'it plans anew for an ego that brakes')
        self.assert_close(second.driven, first.driven, 0.0)
        self.assertEqual(second.attacker_decision, first.attacker_decision)

    def test_planner_that_dies_against_an_adaptive_attacker(self):
        outcome = self.odd('dies', attacker_policy='adaptive')
        self.assert_failed(outcome, 'timed_out', '/planned_trajectory is gone')
        self.assertEqual(outcome.attacker_phase, 'attacking')
        self.assertFalse(outcome.avoidable)

    def test_external_planner_without_reason_drives_straight(self):
        outcome = self.odd('straight')
        self.assertEqual(outcome.failure, 'none', outcome.failure_message)
        self.assertLess(outcome.max_braking, 0.5)

    def test_missing_external_planner_times_out(self):
        began = time.monotonic()
        outcome = self.ask_external(0.3)
        self.assertEqual((outcome.failure, outcome.ticks, outcome.duration), ('timed_out', 0, 0.0))
        self.assertIn('planned_trajectory', outcome.failure_message)
        self.assertLess(time.monotonic() - began, live.TIMEOUT)

    def test_external_planner_that_stops_publishing(self):
        self.assert_failed(self.odd('never'), 'timed_out', 'no response')

    def test_external_planner_that_dies(self):
        self.assert_failed(self.odd('dies'), 'timed_out', '/planned_trajectory is gone')

    def test_external_planner_that_sends_nan(self):
        self.assert_failed(self.odd('nan'), 'not_finite', 'point 3')

    def test_external_planner_that_sends_an_older_stamp(self):
        self.assert_failed(self.odd('late'), 'late', 'the stamps of planned_trajectory and planning_state differ by -0.1 s')

    def test_trajectories_for_another_test_or_a_repeated_state_are_ignored(self):
        for mode in ('stranger', 'twice'):
            outcome = self.odd(mode)
            self.assertEqual(outcome.failure, 'none', mode + ': ' + outcome.failure_message)
            self.doCleanups()

    def test_first_state_is_repeated(self):
        outcome = self.odd('deaf')
        self.assertEqual(outcome.failure, 'none', outcome.failure_message)
        self.assertGreater(outcome.max_call_time, 0.1)


if __name__ == '__main__':
    live.main('planner_tester_test')
