#!/usr/bin/python3
"""forge inject: what it changes in a bag and what not, and what it answers to impossible requests and bad bags."""
import math
import os
import resource
import stat
import struct
import subprocess
import zlib

import rosbag
import rospy

import road

SCENE = 'scene-0003'
NOW = 6.0  # s from the first frame
CENTER_OFFSET = 1.385  # m, of config/ego_vehicle.yaml
ASKED = ('--mode', 'replay', '--attacker', 'existing')  # against the recorded ego: there is a contact in the bag
TYPES = ['lane_change', 'opposite_direction', 'rear_end', 'junction_crossing']


class InjectionTest(road.RoadTest):
    """One attack, and the bag that it was put into against the bag that came out."""
    SCENES = [SCENE]

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.source = cls.folder / (SCENE + '.bag')
        cls.attacked = cls.folder / 'attacked.bag'
        cls.drawing = cls.folder / 'attack'
        cls.ended = cls.folder / 'ended.bag'
        cls.result = road.inject(cls.source, cls.ended, 'rear_end', 4.0, NOW, *ASKED, '--seed', 5,
                                 '--draw', cls.drawing)
        assert cls.result.returncode == 0, cls.result.stderr
        # As long as the recording.
        result = road.inject(cls.source, cls.attacked, 'rear_end', 4.0, NOW, *ASKED, '--seed', 5,
                             '--seconds-after-stand', 60)
        assert result.returncode == 0, result.stderr
        cls.trajectory = road.read_one(cls.attacked, '/attack').trajectory
        cls.driven_on = cls.folder / 'driven_on.bag'
        result = road.inject(cls.source, cls.driven_on, 'rear_end', 4.0, NOW, *ASKED, '--seed', 5,
                             '--after-contact', 'drive_on')
        assert result.returncode == 0, result.stderr
        tested = road.read_one(cls.attacked, '/tested_report')
        assert tested.contact
        cls.contact = tested.contact_time
        cls.attacker = cls.trajectory.attacker_id
        cls.now = cls.trajectory.header.stamp
        cls.end = cls.trajectory.points[-1].stamp

    def test_all_other_topics_are_copied_byte_for_byte(self):
        before = road.read_raw(self.source)
        for bag, changed in ((self.attacked, road.ATTACKED_TOPICS + road.EGO_TOPICS),
                             (self.driven_on, road.ATTACKED_TOPICS)):
            after = road.read_raw(bag)
            self.assertEqual(sorted(after), sorted(list(before) + road.ATTACK_TOPICS))
            for topic in set(before) - set(changed):
                self.assertEqual(after[topic], before[topic], topic)

    def test_messages_up_to_the_change_are_copied_byte_for_byte(self):
        """Of the agents up to now, of the ego up to the contact, where there is one message more."""
        before, after = road.read_raw(self.source), road.read_raw(self.attacked)
        nearly = self.contact - rospy.Duration(nsecs=1000)
        for topics, change in ((road.ATTACKED_TOPICS, self.now), (road.EGO_TOPICS, nearly)):
            for topic in topics:
                first, last = ([message for message in messages[topic] if message[0] <= change.to_nsec()]
                               for messages in (before, after))
                self.assertEqual(last, first)
                self.assertGreater(len(before[topic]), len(first), topic)
                self.assertNotEqual(after[topic][-1], before[topic][-1], topic)
        for topic in road.EGO_TOPICS:
            times = [time for time, _ in after[topic]]
            made = set(times) - {time for time, _ in before[topic]}
            self.assertEqual([time for time in times if time not in made], [time for time, _ in before[topic]])
            self.assertEqual(len(made), 1, topic)
            self.assertAlmostEqual(made.pop() / 1e9, self.contact.to_sec(), delta=2e-3)

    def test_the_bag_ends_three_seconds_after_both_stand_unless_more_is_asked_for(self):
        self.assertIn('the bag ends 3 s after both stand', self.result.stdout)
        speeds = [(message.header.stamp.to_sec(), math.hypot(agent.velocity.x, agent.velocity.y))
                  for message, _ in road.read(self.attacked, '/agents')
                  for agent in message.agents if agent.id == self.attacker]
        stand = next(stamp for stamp, speed in speeds if stamp > self.contact.to_sec() and speed < 1e-6)
        with rosbag.Bag(str(self.ended)) as ended, rosbag.Bag(str(self.attacked)) as attacked:
            self.assertAlmostEqual(ended.get_end_time(), stand + 3.0, delta=0.2)
            with rosbag.Bag(str(self.source)) as source:
                self.assertAlmostEqual(attacked.get_end_time(), source.get_end_time(), places=6)

    def test_the_ego_is_where_it_is_hit_for_who_interpolates_its_poses(self):
        tested = road.read_one(self.attacked, '/tested_report')
        poses = [message.transforms[0] for message, _ in road.read(self.attacked, '/tf')]
        at_contact = min(poses, key=lambda pose: abs((pose.header.stamp - self.contact).to_sec()))
        self.assertLess(abs((at_contact.header.stamp - self.contact).to_sec()), 2e-3)
        yaw = road.yaw_of(at_contact.transform.rotation)
        place, expected = at_contact.transform.translation, tested.ego_at_contact
        self.assertAlmostEqual(place.x + CENTER_OFFSET * math.cos(yaw), expected.x, places=5)
        self.assertAlmostEqual(place.y + CENTER_OFFSET * math.sin(yaw), expected.y, places=5)
        self.assertAlmostEqual(road.angle_between(yaw, expected.theta), 0.0, places=6)

    def test_frames_come_ten_times_a_second_from_now_on(self):
        """Recorded ones at their stamps among them."""
        stamps = [message.header.stamp.to_sec() for message, _ in road.read(self.attacked, '/agents')]
        recorded = [message.header.stamp.to_sec() for message, _ in road.read(self.source, '/agents')]
        self.assertLessEqual(set(recorded), set(stamps))
        later = [stamp for stamp in stamps if stamp >= self.now.to_sec()]
        self.assertLess(max(end - start for start, end in zip(later, later[1:])), 0.1 + 1e-6)
        self.assertEqual([stamp for stamp in stamps if stamp < later[0]],
                         [stamp for stamp in recorded if stamp < later[0]])
        self.assertLess(min(abs(stamp - self.contact.to_sec()) for stamp in stamps), 2e-3)

    def test_others_move_linearly_between_recorded_frames(self):
        recorded = [message for message, _ in road.read(self.source, '/agents')]
        between = 0
        for message, _ in road.read(self.attacked, '/agents'):
            stamp = message.header.stamp
            after = next(frame for frame in recorded if frame.header.stamp >= stamp)
            if after.header.stamp == stamp:
                continue
            before = next(frame for frame in reversed(recorded) if frame.header.stamp < stamp)
            ratio = (stamp - before.header.stamp) / (after.header.stamp - before.header.stamp)
            places = [{agent.id: agent.pose.position for agent in frame.agents} for frame in (before, after)]
            moved = {agent.id: agent.pose.position for agent in message.agents if agent.id != self.attacker}
            self.assertEqual(set(moved), set(places[0]) & set(places[1]) - {self.attacker})
            for agent, place in moved.items():
                first, second = places[0][agent], places[1][agent]
                self.assertAlmostEqual(place.x, first.x + ratio * (second.x - first.x), places=6)
                self.assertAlmostEqual(place.y, first.y + ratio * (second.y - first.y), places=6)
                between += 1
        self.assertGreater(between, 100)

    def test_connections_keep_type_definition_and_latching(self):
        headers = []
        for path in (self.source, self.attacked):
            with rosbag.Bag(str(path)) as bag:
                headers.append({connection.topic: (connection.datatype, connection.md5sum, connection.msg_def,
                                                   connection.header.get('latching'))
                                for connection in bag._get_connections()})
        for topic, header in headers[0].items():
            self.assertEqual(headers[1][topic], header)
        for topic in road.ATTACK_TOPICS:
            self.assertEqual(headers[1][topic][3], b'1', topic)

    def test_attack_is_recorded_once_and_at_now(self):
        start = road.read(self.source, '/agents')[0][1]
        self.assertEqual((self.now - start).to_sec(), NOW)
        for topic in road.TOPICS_AT_NOW:
            (message, time), = road.read(self.attacked, topic)
            self.assertEqual(time, self.now, topic)
            self.assertEqual(message.header.stamp, self.now, topic)
            self.assertEqual(message.header.frame_id, 'map', topic)
        self.assertEqual(road.read_one(self.attacked, '/attack').report.attacker_id, self.attacker)

    def test_the_tested_report_is_recorded_at_the_contact(self):
        (message, time), = road.read(self.attacked, '/tested_report')
        self.assertEqual(time, self.contact)
        self.assertEqual((message.attacker_id, message.header.stamp), (self.attacker, self.now))

    def test_map_markers_come_every_second_to_the_end(self):
        times = [time.to_sec() for _, time in road.read(self.attacked, '/map_markers')]
        end = road.read(self.attacked, '/tf')[-1][1].to_sec()
        self.assertLess(max(later - earlier for earlier, later in zip(times, times[1:] + [end])), 1.2)

    def test_paths_go_from_now_to_the_trajectorys_end(self):
        path = road.read_one(self.attacked, '/attack_path')
        self.assertEqual([(pose.header.stamp, pose.pose.position) for pose in path.poses],
                         [(point.stamp, point.pose.position) for point in self.trajectory.points])
        driven = {message.header.stamp: message.pose.pose.position for message, _ in road.read(self.source, '/odom')}
        ego = road.read_one(self.attacked, '/attack_ego_path')
        self.assertEqual((ego.poses[0].header.stamp, ego.poses[-1].header.stamp), (self.now, self.end))
        recorded = [pose for pose in ego.poses if pose.header.stamp in driven]
        self.assertGreater(len(recorded), 10)
        for pose in recorded:
            base, middle, yaw = driven[pose.header.stamp], pose.pose.position, road.yaw_of(pose.pose.orientation)
            ahead = (middle.x - base.x) * math.cos(yaw) + (middle.y - base.y) * math.sin(yaw)
            self.assertAlmostEqual(ahead, math.hypot(middle.x - base.x, middle.y - base.y), places=4)
            self.assertAlmostEqual(ahead, CENTER_OFFSET, places=4)

    def test_objects_are_the_agents_of_every_frame(self):
        agents, objects = road.read(self.attacked, '/agents'), road.read(self.attacked, '/agent_objects')
        self.assertEqual([time for _, time in objects], [time for _, time in agents])
        for (frame, _), (message, _) in zip(agents, objects):
            self.assertEqual([(one.id, one.pose.position.x) for one in message.objects],
                             [(zlib.crc32(agent.id.encode()), agent.pose.position.x) for agent in frame.agents])

    def expected_state(self, stamp):
        """Where the trajectory has the attacker: x, y, yaw and speed."""
        points = self.trajectory.points
        after = next(index for index, point in enumerate(points) if point.stamp >= stamp)
        first, second = points[after - 1], points[after]
        ratio = (stamp - first.stamp) / (second.stamp - first.stamp)
        yaws = [road.yaw_of(point.pose.orientation) for point in (first, second)]

        def between(start, end):
            return start + ratio * (end - start)
        return (between(first.pose.position.x, second.pose.position.x),
                between(first.pose.position.y, second.pose.position.y),
                yaws[0] + ratio * road.angle_between(*yaws), between(first.speed, second.speed))

    def test_attacker_drives_its_trajectory_and_others_are_as_recorded(self):
        driven = 0
        last_seen = None
        frames = {message.header.stamp: message for message, _ in road.read(self.driven_on, '/agents')}
        for before, _ in road.read(self.source, '/agents'):
            after = frames[before.header.stamp]
            recorded = {agent.id: agent for agent in before.agents}
            attacked = {agent.id: agent for agent in after.agents}
            self.assertEqual(len(attacked), len(after.agents), 'an agent is there twice')
            self.assertEqual(after.header, before.header)
            if before.header.stamp <= self.now:
                last_seen = recorded.get(self.attacker, last_seen)
                continue
            recorded.pop(self.attacker, None)
            attacker = attacked.pop(self.attacker, None)
            self.assertEqual(attacked, recorded)
            self.assertIsNotNone(attacker, 'it stays in the scene')
            if before.header.stamp > self.end:
                continue
            driven += 1
            x, y, yaw, speed = self.expected_state(before.header.stamp)
            self.assertAlmostEqual(attacker.pose.position.x, x, places=6)
            self.assertAlmostEqual(attacker.pose.position.y, y, places=6)
            self.assertEqual(attacker.pose.position.z, last_seen.pose.position.z)
            self.assertAlmostEqual(road.angle_between(yaw, road.yaw_of(attacker.pose.orientation)), 0.0, places=6)
            self.assertAlmostEqual(attacker.velocity.x, speed * math.cos(yaw), places=6)
            self.assertAlmostEqual(attacker.velocity.y, speed * math.sin(yaw), places=6)
            self.assertEqual((attacker.size, attacker.agent_class), (last_seen.size, last_seen.agent_class))
        self.assertGreater(driven, 5)

    def test_annotation_markers_show_the_attacked_agents(self):
        for (agents, _), (markers, _) in zip(road.read(self.attacked, '/agents'),
                                             road.read(self.attacked, '/annotation_markers')):
            places = {(round(marker.pose.position.x, 6), round(marker.pose.position.y, 6))
                      for marker in markers.markers}
            for agent in agents.agents:
                self.assertIn((round(agent.pose.position.x, 6), round(agent.pose.position.y, 6)), places)

    def test_the_attacker_stands_after_its_trajectory(self):
        attacker, = [agent for agent in road.read(self.driven_on, '/agents')[-1][0].agents if agent.id == self.attacker]
        self.assertAlmostEqual(math.hypot(attacker.velocity.x, attacker.velocity.y), 0.0)
        end = self.trajectory.points[-1]
        yaw = road.yaw_of(end.pose.orientation)
        ahead = (math.cos(yaw) * (attacker.pose.position.x - end.pose.position.x) +
                 math.sin(yaw) * (attacker.pose.position.y - end.pose.position.y))
        self.assertAlmostEqual(ahead, end.speed ** 2 / 2 / 8.0, places=3, msg='a car brakes with 8 m/s2')

    def test_ego_and_attacker_come_to_a_stand_together(self):
        transforms = [message.transforms[0] for message, _ in road.read(self.attacked, '/tf')]
        places = {}
        for transform in transforms:
            place = transform.transform.translation
            places[transform.header.stamp] = (place.x, place.y)
        self.assertEqual(places[transforms[-1].header.stamp], places[transforms[-2].header.stamp])
        gaps = set()
        for message, _ in road.read(self.attacked, '/agents'):
            stamp = message.header.stamp
            if stamp <= self.contact or stamp not in places:
                continue
            attacker, = [agent for agent in message.agents if agent.id == self.attacker]
            gaps.add((round(attacker.pose.position.x - places[stamp][0], 4),
                      round(attacker.pose.position.y - places[stamp][1], 4)))
        self.assertEqual(len(gaps), 1, gaps)

    def test_the_bag_may_end_after_the_contact(self):
        out = self.path('out.bag')
        result = road.inject(self.source, out, 'rear_end', 4.0, NOW, *ASKED, '--seed', 5, '--after-contact', 'end')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('after the contact: the bag ends 0.5 s later', result.stdout)
        with rosbag.Bag(str(out)) as bag:
            self.assertAlmostEqual(bag.get_end_time(), self.contact.to_sec() + 0.5, delta=0.11)

    def test_what_was_asked_for_is_in_the_bag(self):
        message = road.read_one(self.attacked, '/attack_request')
        self.assertEqual((message.request.collision_type, message.request.tta, message.request.seed,
                          message.request.mode), ('rear_end', 4.0, 5, 'replay'))
        self.assertEqual((message.now, message.alternative, message.after_contact), (NOW, 1, 'stop'))
        self.assertEqual(message.method, road.read_one(self.attacked, '/attack').method)
        self.assertEqual(message.bag, self.source.name)
        package = (road.PACKAGE_FOLDER / 'package.xml').read_text()
        self.assertIn('<version>{}</version>'.format(message.version), package)
        self.assertRegex(message.configuration, '^[0-9a-f]{16}$')

    def test_a_bag_with_an_attack_is_refused(self):
        out = self.path('out.bag')
        result = road.inject(self.attacked, out, 'rear_end', 4.0, 2.0)
        self.assertEqual(result.returncode, 1, result.stderr)
        for text in (str(self.attacked), '/attack'):
            self.assertIn(text, result.stderr)
        self.assertFalse(out.exists())

    def test_trajectory_starts_at_the_attacker_and_touches_when_reported(self):
        agents = {message.header.stamp: message for message, _ in road.read(self.source, '/agents')}
        attacker, = [agent for agent in agents[self.now].agents if agent.id == self.attacker]
        first = self.trajectory.points[0]
        self.assertEqual(first.stamp, self.now)
        self.assertAlmostEqual(first.pose.position.x, attacker.pose.position.x, places=6)
        self.assertAlmostEqual(first.pose.position.y, attacker.pose.position.y, places=6)
        report = road.read_one(self.attacked, '/attack').report
        self.assertTrue(report.verified)
        x, y, yaw, _ = self.expected_state(report.contact_time)
        self.assertAlmostEqual(report.attacker_at_contact.x, x, places=3)
        self.assertAlmostEqual(report.attacker_at_contact.y, y, places=3)
        self.assertLess(abs((report.contact_time - self.now).to_sec() - 4.0), 0.5)
        self.assertLess(abs(report.relative_heading), math.radians(10.0))
        heading = road.angle_between(report.ego_at_contact.theta, yaw)
        self.assertAlmostEqual(road.angle_between(heading, report.relative_heading), 0.0, places=3)

    def test_tested_report_is_of_the_recorded_ego(self):
        report = road.read_one(self.attacked, '/tested_report')
        if not report.contact:
            return
        poses = {}
        for message, _ in road.read(self.source, '/odom'):
            poses[message.header.stamp] = message.pose.pose
        nearest = min(poses, key=lambda stamp: abs((stamp - report.contact_time).to_sec()))
        pose = poses[nearest].position
        self.assertLess(math.hypot(pose.x - report.ego_at_contact.x, pose.y - report.ego_at_contact.y), 3.0)

    def test_pictures_are_drawn(self):
        png = (self.folder / 'attack.png').read_bytes()
        gif = (self.folder / 'attack.gif').read_bytes()
        self.assertEqual(png[:8], b'\x89PNG\r\n\x1a\n')
        width, height = struct.unpack('>II', png[16:24])
        self.assertGreater(min(width, height), 200)
        self.assertEqual((gif[:6], gif[-1:]), (b'GIF89a', b';'))
        self.assertGreater(len(png), 10000)
        self.assertGreater(len(gif), 10000)

    def test_answer_is_printed(self):
        for text in ('rear_end by ' + self.attacker, 'crash as asked', 'after the contact: both slide to a stand',
                     str(self.ended), 'attack.png', 'attack.gif'):
            self.assertIn(text, self.result.stdout)

    def test_same_seed_same_bytes(self):
        again = self.path('out.bag')
        result = road.inject(self.source, again, 'rear_end', 4.0, NOW, *ASKED, '--seed', 5)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(again.read_bytes(), self.ended.read_bytes())

    def test_other_seed_other_attack(self):
        trajectories = []
        for seed in (5, 6):
            out = self.path('out.bag')
            result = road.inject(self.source, out, 'rear_end', 4.0, NOW, '--seed', seed)
            self.assertEqual(result.returncode, 0, result.stderr)
            trajectories.append(road.read_one(out, '/attack').trajectory)
        self.assertNotEqual(*trajectories)

    def test_now_between_frames_is_the_frame_before(self):
        other = self.path('out.bag')
        result = road.inject(self.source, other, 'rear_end', 4.0, NOW + 0.4, *ASKED, '--seed', 5)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(road.read_one(other, '/attack').trajectory, self.trajectory)

    def test_chosen_attacker_attacks(self):
        attackers = set()
        for collision_type in TYPES:
            result = road.inject(self.source, self.path('out.bag'), collision_type, 4.0, NOW, '--attacker', 'existing',
                                 '--mode', 'history')
            if road.code_of(result) == 'OK':
                attackers.add((collision_type, road.read_one(self.path('out.bag'), '/attack').report.attacker_id))
        self.assertGreater(len({attacker for _, attacker in attackers}), 1)
        answered = 0
        for collision_type, attacker in attackers:
            out = self.path('chosen.bag')
            result = road.inject(self.source, out, collision_type, 4.0, NOW, '--attacker', attacker, '--mode', 'history')
            self.assertIn(road.code_of(result), ('OK', 'LOW_CONFIDENCE'), result.stderr)
            if road.code_of(result) == 'OK':
                self.assertEqual(road.read_one(out, '/attack').trajectory.attacker_id, attacker)
                answered += 1
        self.assertGreater(answered, 1)

    def test_alternatives_are_distinct_until_there_are_no_more(self):
        attacks, out = set(), self.path('out.bag')
        self.assertEqual(road.code_of(road.inject(self.source, out, 'rear_end', 4.0, NOW, '--seed', 5)), 'OK')
        without = road.read_one(out, '/attack').trajectory
        for number in range(1, 17):
            result = road.inject(self.source, out, 'rear_end', 4.0, NOW, '--seed', 5, '--alternative', number)
            if result.returncode != 0:
                break
            attack = road.read_one(out, '/attack')
            if number == 1:
                self.assertEqual(attack.trajectory, without)
            attacks.add((attack.trajectory.attacker_id, attack.report.manoeuvre))
            self.assertEqual(len(attacks), number)
        self.assertGreater(len(attacks), 1)
        self.assertEqual(road.code_of(result), 'NO_ATTACK_WITHIN_LIMITS')
        self.assertIn('there are {} distinct attacks only'.format(len(attacks)), result.stderr)


class RecordedCrashTest(road.RoadTest):
    """Whether the bag shows the crash that was asked for decides the exit code."""
    SCENES = [SCENE]

    def test_a_bag_without_the_crash_asked_for_is_written_with_an_exit_code_of_its_own(self):
        """In history mode the ego may drive otherwise than predicted."""
        codes = set()
        for collision_type in ('rear_end', 'lane_change'):
            for now in (4.0, 8.0, NOW):
                out = self.path('{}_{}.bag'.format(collision_type, now))
                result = road.inject(self.bag(SCENE), out, collision_type, 4.0, now, '--mode', 'history')
                self.assertEqual(road.code_of(result), 'OK', result.stderr)
                tested = road.read_one(out, '/tested_report')
                self.assertEqual(result.returncode, 0 if tested.verified else 3, result.stderr)
                codes.add(result.returncode)
                if result.returncode == 3:
                    last = result.stderr.splitlines()[-1]
                    self.assertTrue(last.startswith('NOT_AS_ASKED: {} does not show the crash asked for: '.format(out)))
                    self.assertIn('contact not as asked: ' if tested.contact else 'no contact', last)
        self.assertIn(3, codes)

    def test_by_default_the_recorded_future_is_known(self):
        out = self.path('out.bag')
        result = road.inject(self.bag(SCENE), out, 'rear_end', 4.0, NOW)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(road.read_one(out, '/tested_report').verified)
        self.assertEqual(road.read_one(out, '/attack_request').request.mode, 'replay')


class AdaptiveInjectionTest(road.RoadTest):
    """An attacker that sees and reacts says in its bag what it decided."""
    SCENES = ['scene-0005']

    def reports(self, mode):
        out = self.path(mode + '.bag')
        result = road.inject(self.bag('scene-0005'), out, 'rear_end', 4.0, 4.0, '--mode', mode)
        self.assertEqual(road.code_of(result), 'OK', result.stderr)
        return road.read_one(out, '/attack'), road.read_one(out, '/tested_report')

    def test_decisions_are_in_the_bag(self):
        attack, tested = self.reports('adaptive')
        self.assertTrue(attack.adaptive)
        self.assertEqual(attack.phase, 'driving_on')
        self.assertEqual(attack.decision, 'the time asked for is over')
        self.assertEqual((attack.report.decision, tested.decision), (attack.decision, attack.decision))
        self.assertGreater(attack.plans, 1)
        self.assertGreater(attack.decided, attack.report.contact_time)

    def test_a_fixed_attacker_decides_nothing(self):
        attack, tested = self.reports('replay')
        self.assertEqual((attack.adaptive, attack.phase, attack.decision, attack.plans), (False, '', '', 0))
        self.assertEqual((attack.report.decision, tested.decision), ('', ''))


class ImpossibleRequestTest(road.RoadTest):
    """Exit code 3 and the code's name where the answer is no; nothing is written."""
    SCENES = [SCENE]

    def assert_refused(self, code, named, collision_type, tta, now, *arguments):
        out = self.path('out.bag')
        result = road.inject(self.bag(SCENE), out, collision_type, tta, now, *arguments)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertEqual(road.code_of(result), code, result.stderr)
        for text in named:
            self.assertIn(text, result.stderr)
        self.assertFalse(out.exists())
        self.assertEqual(list(self.folder.glob('*.part')), [])

    def test_unknown_words_are_a_wrong_command_that_names_the_choices(self):
        for option, word, choice in (('--type', 'sideswipe', 'junction_crossing'), ('--mode', 'future', 'replay'),
                                     ('--after-contact', 'fly', 'drive_on'), ('--ego-side', 'top', 'front')):
            out = self.path('out.bag')
            arguments = () if option == '--type' else (option, word)
            collision_type = word if option == '--type' else 'rear_end'
            result = road.inject(self.bag(SCENE), out, collision_type, 4.0, NOW, *arguments)
            self.assertEqual(result.returncode, 2, result.stderr)
            for text in (option, word, choice):
                self.assertIn(text, result.stderr)
            self.assertFalse(out.exists())

    def test_tta_out_of_range(self):
        for tta in ('0.49', '9.01', '0', '-4', 'inf', '-inf', 'nan'):
            self.assert_refused('TTA_OUT_OF_RANGE', ['tta'], 'rear_end', tta, NOW)

    def test_bounds_of_tta_are_within_range(self):
        for tta in (0.5, 9.0):
            result = road.inject(self.bag(SCENE), self.path('out.bag'), 'rear_end', tta, NOW)
            self.assertIn(road.code_of(result), ('OK', 'NO_ATTACK_WITHIN_LIMITS', 'LOW_CONFIDENCE'), result.stderr)

    def test_unknown_attacker(self):
        self.assert_refused('UNKNOWN_ATTACKER', ['nobody'], 'rear_end', 4.0, NOW, '--attacker', 'nobody')

    def frames(self):
        """By seconds from the first frame: the agents by id."""
        messages = [message for message, _ in road.read(self.bag(SCENE), '/agents')]
        start = messages[0].header.stamp
        return {(message.header.stamp - start).to_sec(): {agent.id: agent for agent in message.agents}
                for message in messages}

    def test_absent_attacker(self):
        """Somebody who has just driven out of sight, and one who left it longer ago than the history reaches."""
        frames = self.frames()
        vanished = [(now, gone) for now in sorted(frames)[2:-1]
                    for gone in sorted(set(frames[now - 0.5]) - set(frames[now]))]
        now, gone = next((now, gone) for now, gone in vanished if gone not in frames[now + 0.5])
        self.assert_refused('ABSENT_ATTACKER', [gone, 'not there now'], 'rear_end', 4.0, now, '--attacker', gone)
        now, gone = next((now, gone) for now, gone in vanished
                         if not any(gone in frames[later] for later in frames if later >= now))
        self.assert_refused('UNKNOWN_ATTACKER', [gone], 'rear_end', 2.0, now + 4.0, '--attacker', gone)

    def test_attacker_that_has_just_appeared(self):
        frames = self.frames()
        now, new = next((now, agent.id) for now in sorted(frames)[8:] for agent in frames[now].values()
                        if agent.agent_class == 0 and not any(agent.id in frames[now - 0.5 * i] for i in range(1, 9)))
        self.assert_refused('TOO_LITTLE_HISTORY', [new], 'rear_end', 4.0, now, '--attacker', new)

    def test_pedestrian_cannot_attack(self):
        pedestrian = min(agent.id for agent in self.frames()[NOW].values() if agent.agent_class == 8)
        self.assert_refused('ABSENT_ATTACKER', [pedestrian, 'pedestrian'], 'rear_end', 4.0, NOW, '--attacker',
                            pedestrian)

    def test_first_frame_is_too_little_history(self):
        self.assert_refused('TOO_LITTLE_HISTORY', ['1 frames'], 'rear_end', 4.0, 0.0)

    def test_beyond_recording(self):
        self.assert_refused('BEYOND_RECORDING', [], 'rear_end', 6.0, 18.0, '--mode', 'replay')

    def test_history_mode_needs_no_future(self):
        result = road.inject(self.bag(SCENE), self.path('out.bag'), 'rear_end', 6.0, 18.0, '--mode', 'history')
        self.assertIn(road.code_of(result), ('OK', 'NO_ATTACK_WITHIN_LIMITS', 'NO_CANDIDATE'), result.stderr)

    def test_out_of_reach(self):
        """Half a second is not enough to turn round."""
        self.assert_refused('NO_ATTACK_WITHIN_LIMITS', [], 'opposite_direction', 0.5, 2.0, '--attacker', 'existing')

    def test_errors(self):
        """Exit code 1: the request or a file cannot be understood."""
        out = self.path('out.bag')
        for arguments, named in [((self.bag(SCENE), out, 'rear_end', 4.0, 20.1), '--now'),
                                 ((self.bag(SCENE), out, 'rear_end', 4.0, -1.0), '--now'),
                                 ((self.bag(SCENE), out, 'rear_end', 4.0, 'nan'), '--now'),
                                 ((self.path('none.bag'), out, 'rear_end', 4.0, NOW), 'none.bag'),
                                 ((self.folder, out, 'rear_end', 4.0, NOW), str(self.folder))]:
            result = road.inject(*arguments)
            self.assertEqual(result.returncode, 1, '{}: {}'.format(arguments, result.stderr))
            self.assertIn(named, result.stderr)
            self.assertFalse(out.exists())

    def test_wrong_command(self):
        complete = ['--bag', self.bag(SCENE), '--out', self.path('out.bag'), '--type', 'rear_end', '--tta', '4',
                    '--now', '6']
        for arguments in ([], complete[:-2], complete + ['--mode', 'future'], complete + ['--seed', 'many'],
                          complete[:-1] + ['soon'], complete + ['--config', self.path('nowhere')]):
            result = road.run('inject', *arguments)
            self.assertEqual(result.returncode, 2, '{}: {}'.format(arguments, result.stderr))
            self.assertNotEqual(result.stderr, '')

    def test_out_is_the_input(self):
        """Under its own name and through a link; the bag stays as it is."""
        before = self.bag(SCENE).read_bytes()
        link = self.path('link.bag')
        link.symlink_to(self.bag(SCENE))
        for out in (self.bag(SCENE), self.folder / 'x' / '..' / (SCENE + '.bag'), link):
            result = road.inject(self.bag(SCENE), out, 'rear_end', 4.0, NOW)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn('--out', result.stderr)
            self.assertEqual(self.bag(SCENE).read_bytes(), before)

    def test_unwritable_out(self):
        for out in (self.path('nowhere') / 'out.bag', self.folder):
            result = road.inject(self.bag(SCENE), out, 'rear_end', 4.0, NOW)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn(str(out), result.stderr)
            left = list(self.folder.glob('*.part')) + list(self.folder.parent.glob(self.folder.name + '.*'))
            self.assertEqual(left, [])

    def test_a_full_disk_is_told_and_leaves_nothing(self):
        out = self.path('out.bag')
        for room in (0, 5000, 100000):  # bytes; a write beyond them fails, as the signal is ignored here
            def limit(room=room):
                resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))

            result = subprocess.run(['forge', 'inject', '--bag', str(self.bag(SCENE)), '--out', str(out),
                                     '--type', 'rear_end', '--tta', '4', '--now', str(NOW)], stdout=subprocess.PIPE,
                                    stderr=subprocess.PIPE, universal_newlines=True, preexec_fn=limit,
                                    restore_signals=False, check=False)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn(str(out), result.stderr)
            self.assertEqual([path.name for path in self.folder.glob(out.name + '*')], [], room)

    def test_out_is_no_file(self):
        out = self.path('pipe')
        os.mkfifo(str(out))
        result = road.inject(self.bag(SCENE), out, 'rear_end', 4.0, NOW)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(str(out) + ': is there and no file', result.stderr)
        self.assertTrue(stat.S_ISFIFO(out.stat().st_mode))

    def test_unwritable_drawing(self):
        """Nothing is written, neither where the folder is missing nor where a picture's name is a folder's."""
        out = self.path('out.bag')
        self.path('taken.gif').mkdir()
        for drawing, named in ((self.path('nowhere') / 'attack', 'attack.png'), (self.path('taken'), 'taken.gif')):
            result = road.inject(self.bag(SCENE), out, 'rear_end', 4.0, NOW, '--draw', drawing)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn(named, result.stderr)
            self.assertFalse(out.exists())
            self.assertFalse(self.path('taken.png').exists())

    def test_drawing_is_a_bag(self):
        before = self.bag(SCENE).read_bytes()
        for ending in ('.png', '.gif'):
            named = self.path('scene' + ending)
            named.write_bytes(before)
            out = self.path('out' + ending)
            for bag, target, drawing, option in ((self.bag(SCENE), out, self.path('out'), '--out'),
                                                 (named, self.path('out.bag'), self.path('scene'), '--bag')):
                result = road.inject(bag, target, 'rear_end', 4.0, NOW, '--draw', drawing)
                self.assertEqual(result.returncode, 1, result.stderr)
                for word in ('--draw', option, ending):
                    self.assertIn(word, result.stderr)
                self.assertFalse(target.exists())
            self.assertEqual(named.read_bytes(), before)


class BadBagTest(road.RoadTest):
    """Bags that are damaged, incomplete, or hold nonsense: a message that names the bag, or the attack all the same."""
    SCENES = [SCENE]

    def inject(self, bag, *arguments):
        return road.inject(bag, self.path('out.bag'), 'rear_end', 4.0, NOW, *arguments)

    def changed(self, change):
        bag = self.path('changed.bag')
        road.copy_bag(self.bag(SCENE), bag, change)
        return bag

    def assert_refused(self, bag, *named):
        result = self.inject(bag)
        self.assertEqual(result.returncode, 1, result.stderr)
        for text in (str(bag),) + named:
            self.assertIn(text, result.stderr)
        self.assertFalse(self.path('out.bag').exists())

    def test_truncated(self):
        whole = self.bag(SCENE).read_bytes()
        for size in (0, 5, 13, 2000, 5000, len(whole) // 2, len(whole) - 7):
            bag = self.path('cut_at_{}.bag'.format(size))
            bag.write_bytes(whole[:size])
            self.assert_refused(bag)

    def test_without_index_as_after_a_killed_recording(self):
        whole = self.bag(SCENE).read_bytes()
        at = whole.index(b'index_pos=') + len(b'index_pos=')
        bag = self.path('unindexed.bag')
        bag.write_bytes(whole[:at] + bytes(8) + whole[at + 8:len(whole) // 2])
        self.assert_refused(bag, 'truncated')

    def test_scrambled(self):
        whole = bytearray(self.bag(SCENE).read_bytes())
        middle = len(whole) // 3
        for index in range(middle, middle + 2000):
            whole[index] = index * 37 % 251
        bag = self.path('scrambled.bag')
        bag.write_bytes(whole)
        self.assert_refused(bag)

    def test_no_bag_at_all(self):
        text = self.path('text.bag')
        text.write_text('not a bag\n' * 1000)
        self.assert_refused(text)

    def test_empty_bag(self):
        self.assert_refused(self.changed(lambda topic, message: None))

    def test_without_a_topic(self):
        for missing, named in (('/lane_map', '/lane_map'), ('/agents', '/agents'), ('/tf', '/tf')):
            self.assert_refused(self.changed(lambda topic, message: None if topic == missing else message), named)

    def test_without_topics_that_are_not_needed(self):
        bag = self.changed(lambda topic, message: None if topic in ('/odom', '/annotation_markers') else message)
        self.assertEqual(road.code_of(self.inject(bag)), 'OK')

    def test_other_type_on_the_topic_of_the_agents(self):
        bag = self.path('other_type.bag')
        with rosbag.Bag(str(self.bag(SCENE))) as source, rosbag.Bag(str(bag), 'w') as target:
            for topic, message, time in road.messages_of(source):
                if topic != '/agents':
                    target.write(topic, message, time)
                if topic == '/odom':
                    target.write('/agents', message, time)
        self.assert_refused(bag, '/agents')

    def test_unknown_agent_class(self):
        def change(topic, message):
            if topic == '/agents':
                for agent in message.agents:
                    agent.agent_class = 42
            return message
        self.assert_refused(self.changed(change), '42')

    def test_no_agents_in_the_frames(self):
        def change(topic, message):
            if topic == '/agents':
                message.agents = []
            return message
        result = self.inject(self.changed(change), '--attacker', 'existing')
        self.assertEqual(road.code_of(result), 'NO_CANDIDATE', result.stderr)

    def test_agents_with_poses_that_are_not_numbers(self):
        """They are left out with a warning, and the others attack."""
        ids = sorted({agent.id for message, _ in road.read(self.bag(SCENE), '/agents') for agent in message.agents})
        broken = set(ids[::2])

        def change(topic, message):
            if topic == '/agents':
                for agent in message.agents:
                    if agent.id in broken:
                        agent.pose.position.x = math.nan
            return message
        result = self.inject(self.changed(change))
        self.assertIn('warning', result.stderr)
        self.assertIn('not a number', result.stderr)
        if road.code_of(result) == 'OK':
            self.assertNotIn(road.read_one(self.path('out.bag'), '/attack').report.attacker_id, broken)

    def test_all_agents_not_numbers(self):
        def change(topic, message):
            if topic == '/agents':
                for agent in message.agents:
                    agent.pose.orientation.z = math.inf
            return message
        self.assertEqual(road.code_of(self.inject(self.changed(change), '--attacker', 'existing')), 'NO_CANDIDATE')

    def test_boxes_without_size(self):
        def change(topic, message):
            if topic == '/agents':
                for agent in message.agents:
                    agent.size.x = 0.0
            return message
        result = self.inject(self.changed(change), '--attacker', 'existing')
        self.assertEqual(road.code_of(result), 'NO_CANDIDATE', result.stderr)
        self.assertIn('warning', result.stderr)

    def test_ego_poses_that_are_not_numbers(self):
        """One is left out with a warning; without any the bag is refused."""
        count = []

        def change_all(topic, message):
            if topic == '/tf':
                message.transforms[0].transform.translation.x = math.nan
            return message

        def change_one(topic, message):
            if topic == '/tf':
                count.append(topic)
                if len(count) == 33:
                    message.transforms[0].transform.rotation.w = math.nan
            return message
        self.assert_refused(self.changed(change_all), '/tf')
        result = self.inject(self.changed(change_one))
        self.assertEqual(road.code_of(result), 'OK', result.stderr)
        self.assertIn('1 ego poses', result.stderr)

    def test_time_that_goes_backwards(self):
        """A bag of a replay that was restarted: the first run counts, with a warning."""
        bag = self.path('twice.bag')
        with rosbag.Bag(str(self.bag(SCENE))) as source, rosbag.Bag(str(bag), 'w') as target:
            messages = list(road.messages_of(source))
            length = messages[-1][2] - messages[0][2]
            for topic, message, time in messages:
                target.write(topic, message, time)
            for topic, message, time in messages:
                target.write(topic, message, time + length + road.Duration(1))
        result = self.inject(bag)
        self.assertEqual(road.code_of(result), 'OK', result.stderr)
        self.assertIn('warning', result.stderr)
        reference = self.path('reference.bag')
        self.assertEqual(road.code_of(road.inject(self.bag(SCENE), reference, 'rear_end', 4.0, NOW)), 'OK')
        self.assertEqual(road.read_one(self.path('out.bag'), '/attack').trajectory,
                         road.read_one(reference, '/attack').trajectory)

    def test_attacker_twice_in_a_frame(self):
        def change(topic, message):
            if topic == '/agents':
                message.agents = message.agents + message.agents
            return message
        result = self.inject(self.changed(change))
        self.assertEqual(road.code_of(result), 'OK', result.stderr)
        attacker = road.read_one(self.path('out.bag'), '/attack').report.attacker_id
        poses = set()
        now = road.read_one(self.path('out.bag'), '/attack').header.stamp
        frames = [message for message, _ in road.read(self.path('out.bag'), '/agents') if message.header.stamp > now]
        for message in frames:
            poses |= {(message.header.stamp, agent.pose.position.x) for agent in message.agents if agent.id == attacker}
        self.assertEqual(len(poses), len(frames), 'the recorded attacker is still beside the attack')

    def test_ego_that_never_moves(self):
        first = road.read(self.bag(SCENE), '/tf')[0][0].transforms[0].transform
        first_odometry = road.read(self.bag(SCENE), '/odom')[0][0].pose

        def change(topic, message):
            if topic == '/tf':
                message.transforms[0].transform = first
            if topic == '/odom':
                message.pose = first_odometry
            return message
        bag = self.changed(change)
        for collision_type in TYPES + ['ltap']:
            for mode in ('history', 'replay'):
                result = road.inject(bag, self.path('out.bag'), collision_type, 4.0, NOW, '--mode', mode)
                code = road.code_of(result)
                self.assertIn(code, ('OK', 'NO_CANDIDATE', 'NO_ATTACK_WITHIN_LIMITS', 'NOT_BELIEVABLE',
                                     'ROAD_DOES_NOT_ALLOW', 'LOW_CONFIDENCE'), result.stderr)
                if code == 'OK':
                    self.assertTrue(road.read_one(self.path('out.bag'), '/attack').report.verified)

    def test_map_without_lanes_and_ground(self):
        def change(topic, message):
            if topic == '/lane_map':
                message.lanes = []
                message.drivable_area = []
            return message
        result = self.inject(self.changed(change))
        self.assertIn(road.code_of(result), ('OK', 'NO_ATTACK_WITHIN_LIMITS', 'LOW_CONFIDENCE'), result.stderr)

    def test_map_that_is_not_a_number(self):
        def change(topic, message):
            if topic == '/lane_map':
                message.lanes[0].centerline[0].x = math.nan
            return message
        result = self.inject(self.changed(change))
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertNotEqual(result.stderr, '')


if __name__ == '__main__':
    road.main()
