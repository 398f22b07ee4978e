#!/usr/bin/python3
"""forge inject: the changes in a bag, and errors for impossible requests and invalid bags."""
import math
import resource
import struct
import subprocess

import rosbag
import rospy
import yaml

import road

SCENE = 'scene-0003'
NOW = 6.0  # s from the first frame
ASKED = ('--mode', 'replay', '--attacker', 'existing')  # against the recorded ego: there is a contact in the bag
TYPES = ['lane_change', 'opposite_direction', 'rear_end', 'junction_crossing']


class InjectionTest(road.RoadTest):
    """One attack: compares the input bag with the output bag."""
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
        """Agents are unchanged up to t0, the ego up to the contact, at which one message is added."""
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

    def test_the_view_for_rviz_holds_the_contact_before_it_comes(self):
        """The view covers the distance that the ego drives in 4 s at 15 m/s, in any direction."""
        layout = yaml.safe_load((road.PACKAGE_FOLDER / 'rviz/attacked_bag.rviz').read_text())
        view = layout['Visualization Manager']['Views']['Current']
        self.assertEqual(view['Target Frame'], 'base_link')
        self.assertGreater(layout['Window Geometry']['Height'] / 2 / view['Scale'], 60.0)

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
        for text in ('rear_end by ' + self.attacker, 'crash as requested', 'after the contact: both stand ',
                     str(self.ended), 'attack.png', 'attack.gif'):
            self.assertIn(text, self.result.stdout)

    def test_same_seed_same_bytes(self):
        again = self.path('out.bag')
        result = road.inject(self.source, again, 'rear_end', 4.0, NOW, *ASKED, '--seed', 5)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(again.read_bytes(), self.ended.read_bytes())

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
        self.assertIn('there are only {} distinct attacks'.format(len(attacks)), result.stderr)


class RecordedCrashTest(road.RoadTest):
    """The exit code depends on whether the bag shows the requested crash."""
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
                    self.assertTrue(last.startswith('NOT_AS_ASKED: {} does not show the requested collision: '.format(out)))
                    self.assertIn('contact not as requested: ' if tested.contact else 'no contact', last)
        self.assertIn(3, codes)

    def test_a_recording_that_ends_before_the_contact_is_reported_as_such(self):
        short = self.path('short.bag')
        with rosbag.Bag(self.bag(SCENE)) as bag, rosbag.Bag(short, 'w') as begin:
            end = bag.get_start_time() + NOW + 1.0
            for topic, message, time in bag.read_messages():
                if time.to_sec() <= end:
                    begin.write(topic, message, time)
        result = road.inject(short, self.path('out.bag'), 'rear_end', 4.0, NOW, '--mode', 'history')
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertRegex(result.stdout, r'against the recording: it ends \d\.\d\d s after t0, before the contact\n')
        self.assertIn(': the recording ends before the contact', result.stderr.splitlines()[-1])

    def test_by_default_the_recorded_future_is_known(self):
        out = self.path('out.bag')
        result = road.inject(self.bag(SCENE), out, 'rear_end', 4.0, NOW)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(road.read_one(out, '/tested_report').verified)
        self.assertEqual(road.read_one(out, '/attack_request').request.mode, 'replay')


class AdaptiveInjectionTest(road.RoadTest):
    """The bag of an adaptive attack contains its decisions."""
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
        self.assertEqual(attack.decision, 'the requested time has passed')
        self.assertEqual((attack.report.decision, tested.decision), (attack.decision, attack.decision))
        self.assertGreater(attack.plans, 1)
        self.assertGreater(attack.decided, attack.report.contact_time)

    def test_a_fixed_attacker_decides_nothing(self):
        attack, tested = self.reports('replay')
        self.assertEqual((attack.adaptive, attack.phase, attack.decision, attack.plans), (False, '', '', 0))
        self.assertEqual((attack.report.decision, tested.decision), ('', ''))


class ImpossibleRequestTest(road.RoadTest):
    """A rejected request: exit code 3 and the name of the status code; nothing is written."""
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

    def test_unknown_attacker(self):
        self.assert_refused('UNKNOWN_ATTACKER', ['nobody'], 'rear_end', 4.0, NOW, '--attacker', 'nobody')

    def test_beyond_recording(self):
        self.assert_refused('BEYOND_RECORDING', [], 'rear_end', 6.0, 18.0, '--mode', 'replay')

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

    def test_out_is_the_input(self):
        """The output is the input bag, by name and by link: the bag is unchanged."""
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

    def test_unwritable_drawing(self):
        """Nothing is written if the folder is missing or a picture's path is a folder."""
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
    """Damaged and incomplete bags, and bags with invalid values: an error that names the bag, or still an attack."""
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

    def test_agents_with_poses_that_are_not_numbers(self):
        """Such agents are dropped with a warning; the other agents can attack."""
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
        self.assertIn('not finite', result.stderr)
        if road.code_of(result) == 'OK':
            self.assertNotIn(road.read_one(self.path('out.bag'), '/attack').report.attacker_id, broken)

    def test_ego_poses_that_are_not_numbers(self):
        """One such message is dropped with a warning; if all are invalid, the bag is rejected."""
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


if __name__ == '__main__':
    road.main()
