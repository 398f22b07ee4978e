#!/usr/bin/python3
"""forge convert: the bags equal the tables; errors for bad input."""
import json
import os
import shutil
import subprocess

import rosbag

import road
from road import DATAROOT, VERSION


class ConversionTest(road.RoadTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.names = sorted(row['name'] for row in json.loads((DATAROOT / VERSION / 'scene.json').read_text()))
        cls.result = road.convert(cls.folder)
        assert cls.result.returncode == 0, cls.result.stderr

    def test_a_bag_for_every_scene_and_nothing_else(self):
        bags = sorted(path.name for path in self.folder.iterdir() if path.is_file())
        self.assertEqual(bags, [name + '.bag' for name in self.names])

    def test_ego_poses_and_agents_are_those_of_the_tables(self):
        result = subprocess.run(
            [str(road.PACKAGE_FOLDER / 'scripts' / 'measure_conversion'), '--dataroot', str(DATAROOT), '--version',
             VERSION, '--bags', str(self.folder)], stdout=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertRegex(result.stdout, r'^{} scenes, [1-9]\d+ poses, [1-9]\d+ boxes'.format(len(self.names)))

    def test_one_map_first_and_latched(self):
        for name in self.names:
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

    def stamps_after_scenarionet(self, rows):
        """Return the times (us) of /odom and /agents after scene-0001 went through a description with these rows."""
        told, back = self.path(rows), self.path(rows + '_back')
        result = road.convert(told, '--scene', 'scene-0001', '--to', 'scenarionet', '--rows', rows)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(sorted(path.name for path in told.iterdir()),
                         ['dataset_mapping.pkl', 'dataset_summary.pkl', 'sd_collision_forge_v1_scene-0001.pkl'])
        result = road.run('convert', '--source', told, '--out', back)
        self.assertEqual(result.returncode, 0, result.stderr)
        return self.stamps_in(back / 'scene-0001.bag')

    @staticmethod
    def stamps_in(path):
        with rosbag.Bag(str(path)) as bag:
            return [[message.header.stamp.to_nsec() // 1000 for _, message, _ in bag.read_messages([topic])]
                    for topic in ('/odom', '/agents')]

    def test_scenes_come_back_from_scenarionet(self):
        poses, frames = self.stamps_in(self.bag('scene-0001'))
        self.assertEqual(self.stamps_after_scenarionet('recorded'), [poses, frames])
        odometry, agents = self.stamps_after_scenarionet('even')
        self.assertEqual(agents, frames)
        self.assertEqual({after - before for before, after in zip(odometry, odometry[1:])}, {100000})

    def test_a_bag_of_the_suite_becomes_a_scenarionet_file(self):
        logs, back = self.path('from_bag'), self.path('back')
        result = road.run('convert', '--source', self.bag('scene-0001'), '--to', 'scenarionet', '--rows', 'recorded',
                          '--out', logs)
        self.assertEqual(result.returncode, 0, result.stderr)
        result = road.run('convert', '--source', logs, '--out', back)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.stamps_in(back / 'scene-0001.bag'), self.stamps_in(self.bag('scene-0001')))

    def test_a_bag_of_another_stack_is_not_called_one_of_the_suite(self):
        foreign = self.path('foreign.bag')
        with rosbag.Bag(str(foreign), 'w'):
            pass
        result = road.run('convert', '--source', foreign, '--out', self.path('nothing'))
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn('no message on /lane_map, no message on /agents, no transform map -> base_link on /tf: is not a bag of '
                      'this suite; convert a bag of another stack with forge convert --topics', result.stderr)

    def test_a_scene_that_cannot_be_read_costs_itself_alone(self):
        logs, listed = self.path('logs'), self.path('listed.jsonl')
        result = road.convert(logs, '--scene', 'scene-0001', 'scene-0002', '--to', 'scenarionet')
        self.assertEqual(result.returncode, 0, result.stderr)
        broken = next(logs.glob('sd_*scene-0002.pkl'))
        broken.write_bytes(broken.read_bytes()[:1000])
        result = road.run('requests', '--source', logs, '--out', listed)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn('not read: scene-0002: ' + str(broken), result.stderr)
        self.assertEqual({json.loads(line)['scene'] for line in listed.read_text().splitlines()}, {'scene-0001'})
        result = road.run('requests', '--source', logs, '--out', listed, '--min-ego-speed', 100)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn('with an ego below 100 m/s', result.stderr)
        self.assertIn('not read: scene-0002', result.stderr, 'the reason is named if no request is listed, too')


class ResumeTest(road.RoadTest):
    def test_second_run_converts_nothing_and_force_everything(self):
        first = road.convert(self.folder, '--scene', 'scene-0001', 'scene-0002')
        self.assertEqual(first.returncode, 0, first.stderr)
        bags = [self.bag('scene-0001'), self.bag('scene-0002')]
        for bag in bags:
            os.utime(str(bag), (0, 0))  # s; long ago: whatever writes the file again changes it
        second = road.convert(self.folder, '--scene', 'scene-0001', 'scene-0002')
        self.assertEqual(second.returncode, 0, second.stderr)
        self.assertIn('0 scenes to convert, 2 already converted', second.stderr)
        self.assertEqual([bag.stat().st_mtime for bag in bags], [0, 0])

        bags[1].unlink()
        third = road.convert(self.folder, '--scene', 'scene-0001', 'scene-0002')
        self.assertIn('1 scene to convert, 1 already converted', third.stderr)
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


class BadConversionInputTest(road.RoadTest):
    """Exit code 1 for invalid data, 2 for an invalid command line."""

    def setUp(self):
        self.dataroot = self.path('data')
        shutil.copytree(str(DATAROOT), str(self.dataroot))

    def change_row(self, name, change):
        """Change the table's second row; return its token."""
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

    def test_names_that_are_paths_outside_the_folder(self):
        for table, field in (('scene', 'name'), ('log', 'location')):
            for name in ('../evil', str(self.path('evil')), '..', '', 'a\nb'):
                original = (self.dataroot / VERSION / (table + '.json')).read_text()
                rows = json.loads(original)
                rows[0][field] = name
                (self.dataroot / VERSION / (table + '.json')).write_text(json.dumps(rows))
                left = self.assert_refused([table + '.json', rows[0]['token'], field, 'is not a valid file name'])
                self.assertEqual(left, [])
                (self.dataroot / VERSION / (table + '.json')).write_text(original)
        self.assertEqual(list(self.folder.glob('**/*evil*')), [])

    def test_missing_field(self):
        token = self.change_row('sample', lambda row: row.pop('timestamp'))
        self.assert_refused(['sample.json', token, 'timestamp'])


if __name__ == '__main__':
    road.main()
