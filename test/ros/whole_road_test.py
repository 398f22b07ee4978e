#!/usr/bin/python3
"""End-to-end live test: a bag is played into the suite (nodelets in one process), and every collision type is requested
in both modes. Attacks, topics and injected agents equal those of forge inject for the same bag."""
import subprocess
import threading
import zlib

import rospy
from genpy.dynamic import generate_dynamic

import live
import road
from live import Listener, ask, until
from std_msgs.msg import Bool


class JunctionTest(live.WholeRoadTest):
    SCENES = ['scene-0003']
    ARGUMENTS = {'keep_attack': 'true'}

    def test_history_rear_end(self):
        self.check('rear_end', 'history', 2)

    def test_history_junction_crossing(self):
        self.check('junction_crossing', 'history', 3)

    def test_replay_lane_change(self):
        self.check('lane_change', 'replay', 4)

    def test_replay_opposite_direction(self):
        self.check('opposite_direction', 'replay', 5)

    def test_crash_with_an_ego_that_does_not_drive_as_predicted_is_shown_as_in_the_bag(self):
        answer, attacked = self.play_and_ask('opposite_direction', 'history', 3, nows=(4.0,), ttas=(4.0,))
        self.assertFalse(road.read_one(attacked, '/tested_report').verified)
        self.assert_crash_shown(attacked)

    def test_objects_are_the_injected_agents_by_the_definition_that_comes_with_them(self):
        listener = Listener('/injected_objects')
        until(lambda: live.living_connections(listener.subscriber) > 0, 'attacker_injector')
        self.play_to(2.0)
        raw = listener.wait()
        listener.close()
        header = raw._connection_header
        self.assertEqual(header['type'], 'derived_object_msgs/ObjectArray')
        kind = generate_dynamic(header['type'], header['message_definition'])[header['type']]
        self.assertEqual(kind._md5sum, header['md5sum'])
        objects = kind().deserialize(raw._buff)
        agents = self.heard['/injected_agents'].wait(lambda message: message.header.stamp == objects.header.stamp)
        self.assertEqual([(one.id, one.pose.position.x, one.shape.dimensions[0]) for one in objects.objects],
                         [(zlib.crc32(agent.id.encode()), agent.pose.position.x, agent.size.x) for agent in agents.agents])
        self.assertGreater(len(objects.objects), 0)

    def test_markers(self):
        self.play_to(3.0)
        for topic, latched in (('/map_markers', True), ('/scene_markers', False)):
            self.assertGreater(len(self.heard[topic].wait().markers), 1, topic)
            self.assertIn(latched, self.heard[topic].latched, topic)
        late = Listener('/map_markers')
        self.assertGreater(len(late.wait().markers), 1)
        late.close()

    def test_the_test_of_a_planner_takes_the_place_of_the_scene_while_it_is_shown(self):
        self.play_to(3.0)
        scene = self.heard['/scene_markers']
        scene.wait(lambda array: len(array.markers) > 1)
        publisher = rospy.Publisher('/planner_test_shown', Bool, queue_size=1, latch=True)
        self.addCleanup(publisher.unregister)
        publisher.publish(True)
        until(lambda: len(scene.all()[-1].markers) == 1, 'the scene to go')
        scene.clear()
        publisher.publish(False)
        scene.wait(lambda array: len(array.markers) > 1)

    def test_markers_are_published_again_while_time_stands_still(self):
        """RViz drops all markers where time jumps back, and by its button Reset."""
        self.play_and_ask('rear_end', 'history', 0)
        for topic in ('/map_markers', '/pattern_markers', '/attack_markers'):
            heard = self.heard[topic]
            shown = heard.wait(lambda markers: len(markers.markers) > 1)
            heard.clear()
            until(lambda: len(heard.all()) > 1, 'markers on ' + topic)
            self.assertEqual([len(markers.markers) for markers in heard.all()[:2]], 2 * [len(shown.markers)], topic)

    def test_attack_markers_go_when_the_replay_is_restarted(self):
        answer, _ = self.play_and_ask('rear_end', 'history', 0)
        listener = self.heard['/attack_markers']
        predicted = self.heard['/pattern_markers']
        for markers in (listener, predicted):
            markers.wait(lambda markers: len(markers.markers) > 1 and
                         markers.markers[-1].header.stamp == answer.attack.pattern.header.stamp)
        self.play_to(1.0)
        until(lambda: len(listener.all()[-1].markers) <= 1, 'the attack markers to go')
        until(lambda: len(predicted.all()[-1].markers) <= 1, 'the predicted patterns to go')

    def test_restarted_replay_starts_history_anew(self):
        self.assertEqual(len(self.play_to(8.0).snapshot.ego.states), 8)
        scene = self.play_to(1.5)
        self.assertEqual([round((state.stamp - self.player.start).to_sec(), 3) for state in scene.snapshot.ego.states],
                         [0.0, 0.5, 1.0, 1.5])
        for track in scene.snapshot.agents:
            self.assertLessEqual(track.states[-1].stamp, scene.header.stamp)
            self.assertGreaterEqual(track.states[0].stamp, self.player.start)
        now, tta, attacked = self.offline('rear_end', 'history', nows=(1.5,))
        answer = self.ask_until(lambda answer: answer.code == 0 and answer.attack.pattern.header.stamp == scene.header.stamp,
                                'rear_end', tta)
        self.assertEqual(now, 1.5)
        self.assert_answer(answer, attacked)

    def test_replay_that_comes_by_again_is_tested_again(self):
        answer, attacked = self.play_and_ask('rear_end', 'replay', 3)
        first = self.assert_played_on(answer, attacked)
        self.play_to(1.0)
        self.heard['/tested_report'].clear()
        self.player.play_to((answer.attack.trajectory.points[-1].stamp - self.player.start).to_sec())
        self.assert_close(self.heard['/tested_report'].wait(), first)

    def test_beyond_recording(self):
        self.play_to(18.0)
        for controls in ({'mode': 'replay'}, {'mode': 'history'}, {'adaptive': True}, {'choice': 'new'}):
            answer = self.ask_for_code('BEYOND_RECORDING', 'rear_end', 6.0, **controls)
            self.assertIn('tta = 6.0 s, but the recording', answer.message)
            self.assertIn('ends 2.0 s after t0', answer.message)

    def test_attacker_equals_that_of_forge_inject_recorded_or_added(self):
        added = set()
        for mode in ('history', 'replay'):
            for collision_type in ('lane_change', 'opposite_direction', 'rear_end', 'junction_crossing', 'ltap'):
                out = self.path('any_{}_{}.bag'.format(collision_type, mode))
                code = road.code_of(road.inject(self.bag(self.SCENES[0]), out, collision_type, 4.0, 6.0, '--mode', mode))
                end = self.play_to(6.0).header.stamp
                answer = self.ask_until(lambda answer: road.CODES[answer.code] not in ('NO_SCENE', 'NO_RECORDING'),
                                        collision_type, 4.0, mode=mode, believable='')
                self.assertEqual(road.CODES[answer.code], code, (collision_type, mode, answer.message))
                if code == 'OK':
                    self.assertEqual(answer.attack.header.stamp, end)
                    self.assert_answer(answer, out)
                    added.add(answer.attack.trajectory.added)
        self.assertEqual(added, {False, True})

    def test_killed_manager(self):
        """The nodelets are loaded again and the next replay gives the same results."""
        pid = live.pid_of(live.MANAGER)
        live.kill_node(live.MANAGER)
        self.suite.wait_until_back(live.MANAGER, pid)
        self.player.connect(self.suite, self.heard)
        self.check('rear_end', 'history', 4)

    def test_nodelets_that_are_killed_during_the_replay(self):
        """The manager survives; the nodelets are loaded again and the next replay gives the same results."""
        pid = live.pid_of(live.MANAGER)
        gone = threading.Event()

        def play():
            while not gone.is_set():
                self.player.restart()
                self.player.play_to(15.0)
        player = threading.Thread(target=play)
        self.addCleanup(player.join)
        self.addCleanup(gone.set)
        player.start()
        for name in live.NODES:
            subprocess.run(['/usr/bin/rosrun', 'nodelet', 'nodelet', 'unload', '/' + name, '/' + live.MANAGER],
                           stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=True, timeout=live.TIMEOUT)
            self.suite.wait_until_ready()
        gone.set()
        player.join()
        self.assertEqual(live.pid_of(live.MANAGER), pid)
        self.player.connect(self.suite, self.heard)
        self.check('rear_end', 'history', 4)

    def test_two_callers_at_once(self):
        requests = {}
        for collision_type in ('rear_end', 'lane_change'):
            for seed in range(3):
                now, tta, attacked = self.offline(collision_type, 'history', seed, nows=(6.0,))
                kept = attacked.with_name('{}_{}'.format(seed, attacked.name))
                attacked.rename(kept)
                requests[(collision_type, tta, '', 'history', seed)] = kept
        scene = self.play_to(6.0)
        self.ask_until(lambda answer: answer.attack.pattern.header.stamp == scene.header.stamp, *next(iter(requests)))
        answers = {}

        def call(request):
            answers[request] = ask(*request)
        threads = [threading.Thread(target=call, args=(request,)) for request in requests]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(live.TIMEOUT)
        self.assertEqual(len(answers), len(requests), 'everybody is answered')
        for request, attacked in requests.items():
            self.assertEqual(answers[request].code, 0, answers[request].message)
            self.assert_answer(answers[request], attacked)


class RoundaboutTest(live.WholeRoadTest):
    SCENES = ['scene-0007']

    def test_replay_ltap(self):
        self.check('ltap', 'replay', 1)

    def test_the_bag_of_another_scene_is_not_the_recording(self):
        other = self.folder / 'scene-0001.bag'
        self.assertEqual(road.convert(self.folder, '--scene', 'scene-0001').returncode, 0)
        player = live.Player(other)
        self.addCleanup(player.unregister)
        player.connect(self.suite, self.heard)
        end = player.play_to(4.0)
        self.heard['/encoded_scene'].wait(lambda scene: scene.header.stamp == end)
        answer = self.ask_for_code('NO_RECORDING', 'rear_end', 4.0, mode='replay')
        self.assertIn('scene-0007', answer.message)

class DriveOnTest(live.WholeRoadTest):
    SCENES = ['scene-0005']
    ARGUMENTS = {'after_contact': 'drive_on'}

    def test_markers_show_both_vehicles_driving_on_after_the_contact(self):
        answer, _ = self.play_and_ask('rear_end', 'replay', 0)
        report = answer.attack.report
        seconds = (report.contact_time - self.player.start).to_sec() + 0.5
        picture = self.play_clock_to(seconds)
        for name, namespace, at_contact in (('ego', 'ego', report.ego_at_contact),
                                            ('attacker', 'attacker', report.attacker_at_contact)):
            place, _, _ = live.shown_box(picture, namespace)
            driven = abs(place - complex(at_contact.x, at_contact.y))
            self.assertGreater(driven, 0.5, name)
        stamp = self.player.start + rospy.Duration(seconds)
        point = min(answer.attack.trajectory.points, key=lambda point: abs((point.stamp - stamp).to_sec()))
        place, _, _ = live.shown_box(picture, 'attacker')
        self.assertLess(abs(place - complex(point.pose.position.x, point.pose.position.y)), 0.1 * 15.0)
        self.assertEqual([marker for marker in picture.markers if marker.ns == 'contact'], [])


if __name__ == '__main__':
    live.main('whole_road_test')
