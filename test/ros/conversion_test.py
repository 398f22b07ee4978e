#!/usr/bin/python3
"""forge convert: what is in the bags is what is in the tables, and what it answers to bad input."""
import json
import math
import os
import shutil
import zlib

import rosbag
from genpy.dynamic import generate_dynamic

import road
from road import DATAROOT, VERSION

POSITION_TOLERANCE = 1e-3  # m
ANGLE_TOLERANCE = 1e-4     # rad


def table(name):
    with open(str(DATAROOT / VERSION / (name + '.json'))) as file:
        return json.load(file)


class Tables:
    """The rows of the embedded tables that a bag is made of, by scene name."""

    def __init__(self):
        sample_scenes = {row['token']: row['scene_token'] for row in table('sample')}
        names = {row['token']: row['name'] for row in table('scene')}
        poses = {row['token']: row for row in table('ego_pose')}
        categories = {row['token']: row['name'] for row in table('category')}
        self.category_of = {row['token']: categories[row['category_token']] for row in table('instance')}
        self.names = sorted(names.values())
        self.ego_poses = {name: [] for name in self.names}
        self.samples = {name: [] for name in self.names}
        self.annotations = {}
        for row in table('sample_data'):
            self.ego_poses[names[sample_scenes[row['sample_token']]]].append(poses[row['ego_pose_token']])
        for row in table('sample'):
            self.samples[names[row['scene_token']]].append(row)
        for row in table('sample_annotation'):
            self.annotations.setdefault(row['sample_token'], []).append(row)
        for rows in list(self.ego_poses.values()) + list(self.samples.values()):
            rows.sort(key=lambda row: row['timestamp'])


def yaw_of_list(rotation):
    w, x, y, z = rotation
    return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


class ConversionTest(road.RoadTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.tables = Tables()
        cls.result = road.convert(cls.folder)
        assert cls.result.returncode == 0, cls.result.stderr

    def assert_pose(self, position, orientation, row):
        for actual, expected in zip((position.x, position.y, position.z), row['translation']):
            self.assertLessEqual(abs(actual - expected), POSITION_TOLERANCE, row['token'])
        error = road.angle_between(yaw_of_list(row['rotation']), road.yaw_of(orientation))
        self.assertLessEqual(abs(error), ANGLE_TOLERANCE, row['token'])

    def test_a_bag_for_every_scene_and_nothing_else(self):
        bags = sorted(path.name for path in self.folder.iterdir() if path.is_file())
        self.assertEqual(bags, [name + '.bag' for name in self.tables.names])

    def test_ego_poses_are_those_of_the_table(self):
        for name in self.tables.names:
            rows = self.tables.ego_poses[name]
            messages = road.read(self.bag(name), '/tf')
            self.assertEqual(len(messages), len(rows), name)
            for (message, time), row in zip(messages, rows):
                transform, = message.transforms
                self.assertEqual(transform.header.stamp.to_nsec(), row['timestamp'] * 1000)
                self.assertEqual(time, transform.header.stamp)
                self.assertEqual((transform.header.frame_id, transform.child_frame_id), ('map', 'base_link'))
                self.assert_pose(transform.transform.translation, transform.transform.rotation, row)

    def test_odometry_has_the_same_poses_and_their_speed(self):
        for name in self.tables.names:
            rows = self.tables.ego_poses[name]
            messages = road.read(self.bag(name), '/odom')
            self.assertEqual(len(messages), len(rows), name)
            for (message, time), row in zip(messages, rows):
                self.assertEqual(message.header.stamp.to_nsec(), row['timestamp'] * 1000)
                self.assertEqual(time, message.header.stamp)
                self.assert_pose(message.pose.pose.position, message.pose.pose.orientation, row)
            for index in range(1, len(rows) - 1):
                before, after = rows[index - 1], rows[index + 1]
                speed = (math.dist(before['translation'], after['translation']) /
                         (after['timestamp'] - before['timestamp']) * 1e6)
                linear = messages[index][0].twist.twist.linear
                self.assertAlmostEqual(math.hypot(linear.x, linear.y, linear.z), speed, places=6)

    def test_agents_are_those_of_the_table(self):
        for name in self.tables.names:
            rows = self.tables.samples[name]
            messages = road.read(self.bag(name), '/agents')
            self.assertEqual(len(messages), len(rows), name)
            for (message, time), sample in zip(messages, rows):
                self.assertEqual(message.header.stamp.to_nsec(), sample['timestamp'] * 1000)
                self.assertEqual(time, message.header.stamp)
                self.assertEqual(message.header.frame_id, 'map')
                expected = {row['instance_token']: row for row in self.tables.annotations.get(sample['token'], [])}
                self.assertEqual(sorted(agent.id for agent in message.agents), sorted(expected))
                for agent in message.agents:
                    row = expected[agent.id]
                    self.assert_pose(agent.pose.position, agent.pose.orientation, row)
                    width, length, height = row['size']
                    self.assertEqual((agent.size.x, agent.size.y, agent.size.z), (length, width, height))

    def test_agent_classes_follow_the_categories(self):
        classes = {'vehicle.car': 0, 'vehicle.truck': 1, 'vehicle.bus': 2, 'human.pedestrian': 8}
        seen = set()
        for name in self.tables.names:
            for message, _ in road.read(self.bag(name), '/agents'):
                for agent in message.agents:
                    category = self.tables.category_of[agent.id]
                    for prefix, agent_class in classes.items():
                        if category.startswith(prefix):
                            self.assertEqual(agent.agent_class, agent_class, category)
                            seen.add(prefix)
        self.assertIn('vehicle.car', seen)
        self.assertIn('human.pedestrian', seen)

    def test_objects_are_the_agents_and_have_the_definition_of_their_md5(self):
        for name in self.tables.names:
            with rosbag.Bag(str(self.bag(name))) as bag:
                connection, = [one for one in bag._get_connections() if one.topic == '/agent_objects']
            kind = 'derived_object_msgs/ObjectArray'
            self.assertEqual(connection.datatype, kind)
            self.assertEqual(generate_dynamic(kind, connection.msg_def)[kind]._md5sum, connection.md5sum)
            agents, objects = road.read(self.bag(name), '/agents'), road.read(self.bag(name), '/agent_objects')
            self.assertEqual([time for _, time in objects], [time for _, time in agents])
            for (frame, _), (message, _) in zip(agents, objects):
                self.assertEqual(message.header.stamp, frame.header.stamp)
                self.assertEqual([(one.id, one.pose.position.x, one.twist.linear.y) for one in message.objects],
                                 [(zlib.crc32(agent.id.encode()), agent.pose.position.x, agent.velocity.y)
                                  for agent in frame.agents])

    def test_one_map_first_and_latched(self):
        for name in self.tables.names:
            with rosbag.Bag(str(self.bag(name))) as bag:
                (topic, message, time) = next(bag.read_messages())
                self.assertEqual(topic, '/lane_map')
                self.assertEqual(bag.get_message_count('/lane_map'), 1)
                self.assertEqual(time.to_sec(), bag.get_start_time())
                latching = {connection.topic: connection.header.get('latching')
                            for connection in bag._get_connections()}
            self.assertEqual(latching, {'/lane_map': b'1', '/tf': None, '/odom': None, '/agents': None,
                                        '/annotation_markers': None, '/agent_objects': None})
            self.assertGreater(len(message.lanes), 10)
            self.assertGreater(len(message.drivable_area), 0)
            self.assertTrue(message.location.startswith('embedded-'))
            self.assertEqual(message.driving_side, 1 if message.location.endswith('left') else 0)

    def test_compressed_with_lz4(self):
        for name in self.tables.names:
            with rosbag.Bag(str(self.bag(name))) as bag:
                info = bag.get_compression_info()
                self.assertEqual(info.compression, 'lz4')
                self.assertLess(info.compressed, info.uncompressed)

    def test_rosbag_check_of_reading_times_in_order(self):
        for name in self.tables.names:
            with rosbag.Bag(str(self.bag(name))) as bag:
                times = [time.to_nsec() for _, _, time in bag.read_messages(raw=True)]
            self.assertEqual(times, sorted(times))

    def stamps_after_scenarionet(self, rows):
        """Of /odom and /agents, us, where scene-0001 went through a description with these rows."""
        told, back = self.path(rows), self.path(rows + '_back')
        result = road.convert(told, '--scene', 'scene-0001', '--to', 'scenarionet', '--rows', rows)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(sorted(path.name for path in told.iterdir()),
                         ['dataset_mapping.pkl', 'dataset_summary.pkl', 'sd_collision_forge_v1_scene-0001.pkl'])
        result = road.run('convert', '--source', told, '--out', back)
        self.assertEqual(result.returncode, 0, result.stderr)
        with rosbag.Bag(str(back / 'scene-0001.bag')) as bag:
            return [[message.header.stamp.to_nsec() // 1000 for _, message, _ in bag.read_messages([topic])]
                    for topic in ('/odom', '/agents')]

    def test_scenes_come_back_from_scenarionet(self):
        poses = [row['timestamp'] for row in self.tables.ego_poses['scene-0001']]
        frames = [row['timestamp'] for row in self.tables.samples['scene-0001']]
        self.assertEqual(self.stamps_after_scenarionet('recorded'), [poses, frames])
        odometry, agents = self.stamps_after_scenarionet('even')
        self.assertEqual(agents, frames)
        self.assertEqual({after - before for before, after in zip(odometry, odometry[1:])}, {100000})


class ResumeTest(road.RoadTest):
    def test_second_run_converts_nothing_and_force_everything(self):
        first = road.convert(self.folder, '--scene', 'scene-0001', 'scene-0002')
        self.assertEqual(first.returncode, 0, first.stderr)
        bags = [self.bag('scene-0001'), self.bag('scene-0002')]
        for bag in bags:
            os.utime(str(bag), (0, 0))  # s; long ago: whatever writes the file again changes it
        second = road.convert(self.folder, '--scene', 'scene-0001', 'scene-0002')
        self.assertEqual(second.returncode, 0, second.stderr)
        self.assertIn('0 scenes to convert, 2 converted before', second.stderr)
        self.assertEqual([bag.stat().st_mtime for bag in bags], [0, 0])

        bags[1].unlink()
        third = road.convert(self.folder, '--scene', 'scene-0001', 'scene-0002')
        self.assertIn('1 scene to convert, 1 converted before', third.stderr)
        self.assertEqual(bags[0].stat().st_mtime, 0)
        self.assertTrue(bags[1].exists())

        forced = road.convert(self.folder, '--scene', 'scene-0001', 'scene-0002', '--force')
        self.assertEqual(forced.returncode, 0, forced.stderr)
        self.assertIn('2 scenes written', forced.stderr)
        self.assertGreater(bags[0].stat().st_mtime, 0)

    def test_same_bytes_whatever_the_number_of_jobs(self):
        for jobs in (1, 4):
            result = road.convert(self.path(str(jobs)), '--jobs', jobs)
            self.assertEqual(result.returncode, 0, result.stderr)
        for bag in self.path('1').iterdir():
            self.assertEqual(bag.read_bytes(), (self.path('4') / bag.name).read_bytes(), bag.name)

    def test_leftover_of_an_interrupted_run_is_no_bag(self):
        out = self.path('out')
        out.mkdir()
        (out / 'scene-0001.bag.part').write_bytes(b'#ROSBAG V2.0\n')
        result = road.convert(out, '--scene', 'scene-0001')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([path.name for path in out.iterdir()], ['scene-0001.bag'])


class BadConversionInputTest(road.RoadTest):
    """Exit code 1 for what is wrong with the data, 2 for what is wrong with the command."""

    def setUp(self):
        self.dataroot = self.path('data')
        shutil.copytree(str(DATAROOT), str(self.dataroot))

    def change_row(self, name, change):
        """Changes the table's second row; returns its token."""
        path = self.dataroot / VERSION / (name + '.json')
        rows = json.loads(path.read_text())
        token = rows[1]['token']
        change(rows[1])
        path.write_text(json.dumps(rows))
        return token

    def assert_refused(self, named, *arguments):
        out = self.path('out')
        result = road.convert(out, *arguments, dataroot=self.dataroot)
        self.assertEqual(result.returncode, 1, result.stderr)
        for text in named:
            self.assertIn(text, result.stderr)
        return [path.name for path in out.iterdir()] if out.exists() else []

    def test_unknown_scene(self):
        self.assertEqual(self.assert_refused(['scene-0099'], '--scene', 'scene-0099'), [])

    def test_names_that_lead_elsewhere(self):
        for table, field in (('scene', 'name'), ('log', 'location')):
            for name in ('../evil', str(self.path('evil')), '..', '', 'a\nb'):
                original = (self.dataroot / VERSION / (table + '.json')).read_text()
                rows = json.loads(original)
                rows[0][field] = name
                (self.dataroot / VERSION / (table + '.json')).write_text(json.dumps(rows))
                left = self.assert_refused([table + '.json', rows[0]['token'], field, 'cannot be the name of a file'])
                self.assertEqual(left, [])
                (self.dataroot / VERSION / (table + '.json')).write_text(original)
        self.assertEqual(list(self.folder.glob('**/*evil*')), [])

    def test_no_such_folder(self):
        result = road.convert(self.path('out'), dataroot=self.path('nowhere'))
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn(str(self.path('nowhere')), result.stderr)

    def test_missing_table(self):
        (self.dataroot / VERSION / 'ego_pose.json').unlink()
        self.assert_refused(['ego_pose.json'])

    def test_table_that_is_no_json(self):
        path = self.dataroot / VERSION / 'sample.json'
        path.write_text(path.read_text()[:-100])
        self.assert_refused(['sample.json'])

    def test_missing_field(self):
        token = self.change_row('sample', lambda row: row.pop('timestamp'))
        self.assert_refused(['sample.json', token, 'timestamp'])

    def test_wrong_type(self):
        token = self.change_row('ego_pose', lambda row: row.update(translation=[1.0, 'east', 0.0]))
        self.assert_refused(['ego_pose.json', token, 'translation'])

    def test_dangling_token(self):
        token = self.change_row('sample_annotation', lambda row: row.update(instance_token='nobody'))
        self.assert_refused(['sample_annotation.json', token, 'instance_token', 'nobody'])

    def test_outdated_map(self):
        """The two formats of the map expansion before 1.3 are told by their `version`."""
        path = self.dataroot / 'maps' / 'expansion' / 'embedded-right.json'
        document = json.loads(path.read_text())
        document['version'] = '1.0'
        path.write_text(json.dumps(document))
        bags = self.assert_refused(['embedded-right.json', '1.0', '1.3'])
        self.assertNotIn('scene-0001.bag', bags)
        self.assertIn('scene-0007.bag', bags, 'the other town is not affected')

    def test_missing_map(self):
        (self.dataroot / 'maps' / 'expansion' / 'embedded-left.json').unlink()
        bags = self.assert_refused(['embedded-left.json'])
        self.assertNotIn('scene-0007.bag', bags)

    def test_unwritable_folder(self):
        blocker = self.path('file')
        blocker.write_text('no folder')
        result = road.convert(blocker / 'out')
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(str(blocker), result.stderr)

    def test_wrong_command(self):
        for arguments in ([], ['--dataroot', DATAROOT], ['--nonsense'],
                          ['--dataroot', DATAROOT, '--version', VERSION, '--out', self.path('out'), '--jobs', '0']):
            result = road.run('convert', *arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertNotEqual(result.stderr, '')

    def test_help(self):
        result = road.run('convert', '--help')
        self.assertEqual(result.returncode, 0)
        self.assertIn('--dataroot', result.stdout)



if __name__ == '__main__':
    road.main()
