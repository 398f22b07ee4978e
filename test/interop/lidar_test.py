#!/usr/bin/python3
"""Clouds of attacked bags are those that nuScenes' own devkit and pypcd4 read: lidar with the attacker, and radar."""
import hashlib
import json
import math
import os
import shutil
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

import rosbag

from pages import LOGS, forge
from virtual_environments import nuscenes_python, python_with

SCENE, TABLES = 'scene-0005', Path('data', 'embedded', 'v1.0-embedded')
ATTACK = ['--type', 'opposite_direction', '--now', '5', '--tta', '4', '--lidar', 'auto']
POINT = struct.Struct('<5f')  # of a .pcd.bin
RADAR_FIELDS = ('x y z dyn_prop id rcs vx vy vx_comp vy_comp is_quality_valid ambig_state x_rms y_rms invalid_state '
                'pdh0 vx_rms vy_rms').split()
RADAR_POINT = struct.Struct('<3fbh5f8b')
RADAR_POINTS = [(10.5 + i, -2.25, 0.0, i % 7, 300 + i, 7.5, -3.0, 0.5, -8.0, 0.25, 1, 3, 19, 20, 0, 1, 16, 3)
                for i in range(5)]


def radar_file():
    """Return the bytes of a radar file as nuScenes writes them."""
    sizes = [4, 4, 4, 1, 2, 4, 4, 4, 4, 4] + [1] * 8
    types = list('FFFIIFFFFF') + ['I'] * 8
    lines = ['# .PCD v0.7 - Point Cloud Data file format', 'VERSION 0.7', 'FIELDS ' + ' '.join(RADAR_FIELDS),
             'SIZE ' + ' '.join(map(str, sizes)), 'TYPE ' + ' '.join(types), 'COUNT' + ' 1' * len(RADAR_FIELDS),
             'WIDTH {}'.format(len(RADAR_POINTS)), 'HEIGHT 1', 'VIEWPOINT 0 0 0 1 0 0 0',
             'POINTS {}'.format(len(RADAR_POINTS)), 'DATA binary', '']
    # The devkit requires a byte behind the last point.
    return '\n'.join(lines).encode() + b''.join(RADAR_POINT.pack(*point) for point in RADAR_POINTS) + b'\n'


def clouds_in(bag, topic):
    """Return the clouds of a topic by stamp, us."""
    with rosbag.Bag(str(bag)) as opened:
        return {round(message.header.stamp.to_nsec() / 1000): message
                for _, message, _ in opened.read_messages(topic)}


def mount_in(bag):
    """Return the fields `translation` and `rotation` of the lidar's row in calibrated_sensor."""
    with rosbag.Bag(str(bag)) as opened:
        place = next(one.transform for _, message, _ in opened.read_messages('/tf_static')
                     for one in message.transforms if one.child_frame_id == 'lidar_top')
    turn = place.rotation
    return {'translation': [place.translation.x, place.translation.y, place.translation.z],
            'rotation': [turn.w, turn.x, turn.y, turn.z]}


def write_root(root, clouds, mount):
    """Write a nuScenes root of the embedded tables with the clouds as its sweeps, and one radar file.

    `mount`: as mount_in()."""
    tables = Path(root, TABLES.name)
    shutil.copytree(TABLES, tables)
    shutil.copytree(TABLES.parent / 'maps', Path(root, 'maps'))
    rows = {name: json.loads((tables / (name + '.json')).read_text(encoding='utf-8'))
            for name in ('sensor', 'calibrated_sensor', 'sample_data')}
    for row in rows['calibrated_sensor']:
        row.update(mount)
    for row in rows['sample_data']:
        if SCENE not in row['filename']:
            continue
        path = Path(root, row['filename'])
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(clouds[row['timestamp']].data)
        lidar = row
    radar = dict(lidar, token='radar', calibrated_sensor_token='radar', prev='', next='',
                 filename='sweeps/RADAR_FRONT/radar.pcd', is_key_frame=False)
    rows['sample_data'].append(radar)
    rows['sensor'].append({'token': 'radar', 'channel': 'RADAR_FRONT', 'modality': 'radar'})
    rows['calibrated_sensor'].append(dict(rows['calibrated_sensor'][0], token='radar', sensor_token='radar'))
    Path(root, 'sweeps', 'RADAR_FRONT').mkdir(parents=True)
    Path(root, radar['filename']).write_bytes(radar_file())
    for name, table in rows.items():
        (tables / (name + '.json')).write_text(json.dumps(table), encoding='utf-8')


def points_in(cloud):
    return list(POINT.iter_unpack(cloud.data))


class LidarTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        recorded, cls.attacked = Path(folder.name, SCENE + '.bag'), Path(folder.name, 'attacked.bag')
        forge('convert', *LOGS, '--scene', SCENE, '--sensors', 'simulated', '--out', folder.name)
        forge('inject', '--bag', str(recorded), *ATTACK, '--out', str(cls.attacked))
        cls.recorded, cls.clouds = clouds_in(recorded, '/lidar_top'), clouds_in(cls.attacked, '/lidar_top')
        cls.root = Path(folder.name, 'root')
        write_root(cls.root, {**cls.recorded, **cls.clouds}, mount_in(recorded))
        forge('convert', '--dataroot', str(cls.root), '--version', TABLES.name, '--scene', SCENE, '--sensors', 'files',
              '--out', str(Path(folder.name, 'again')))
        cls.again = Path(folder.name, 'again', SCENE + '.bag')

    def stamp_of_most_changed(self):
        """Return the stamp of the cloud before the contact in which the attacker has most points.

        The tables have the recorded pose of the ego, which the impact changes."""
        with rosbag.Bag(str(self.attacked)) as bag:
            attack = next(message for _, message, _ in bag.read_messages('/attack'))
        contact = attack.report.contact_time.to_nsec() / 1000
        return max((stamp for stamp in self.clouds if stamp < contact),
                   key=lambda stamp: len(set(points_in(self.clouds[stamp])) - set(points_in(self.recorded[stamp]))))

    def attacker_at(self, stamp):
        """Return the attacker's box at a stamp, interpolated between the frames of agents."""
        with rosbag.Bag(str(self.attacked)) as bag:
            attacker = next(message for _, message, _ in bag.read_messages('/attack')).trajectory.attacker_id
            frames = [(frame.header.stamp.to_nsec() / 1000, agent) for _, frame, _ in bag.read_messages('/agents')
                      for agent in frame.agents if agent.id == attacker]
        before, after = next(pair for pair in zip(frames, frames[1:]) if pair[0][0] <= stamp <= pair[1][0])
        share = (stamp - before[0]) / (after[0] - before[0])
        places = [(one.pose.position.x, one.pose.position.y, one.pose.position.z) for _, one in (before, after)]
        turn = before[1].pose.orientation
        size = before[1].size
        return {'center': [a + share * (b - a) for a, b in zip(*places)], 'size': [size.y, size.x, size.z],
                'rotation': [turn.w, turn.x, turn.y, turn.z]}

    def test_the_devkit_reads_the_clouds_and_finds_the_attacker_in_its_box(self):
        stamp = self.stamp_of_most_changed()
        script = Path(__file__).with_name('lidar_checks.py')
        done = subprocess.run([nuscenes_python(), script, self.root, TABLES.name, str(stamp),
                               json.dumps(self.attacker_at(stamp))], stdout=subprocess.PIPE, check=True)
        found = json.loads(done.stdout)
        points = points_in(self.clouds[stamp])
        self.assertEqual(found['points'], len(points))
        self.assertEqual(found['digest'],
                         hashlib.sha256(b''.join(struct.pack('<4f', *point[:4]) for point in points)).hexdigest())
        recorded = set(points_in(self.recorded[stamp]))
        new = {i for i, point in enumerate(points) if point not in recorded}
        self.assertGreater(len(new), 20)
        self.assertGreaterEqual(len(new.intersection(found['in_box'])), 0.95 * len(new))
        self.assertEqual(found['radar'], [list(map(float, point)) for point in RADAR_POINTS])

    def test_sweeps_of_a_root_are_converted_byte_by_byte(self):
        again = clouds_in(self.again, '/lidar_top')
        self.assertGreater(len(again), 100)
        for stamp, cloud in again.items():
            self.assertEqual(cloud.data, {**self.recorded, **self.clouds}[stamp].data)

    def test_pypcd4_reads_lidar_and_radar_messages(self):
        python = python_with('pypcd4', 'pypcd4==1.5.1', 'rosbags==0.11.9')
        script = Path(__file__).with_name('cloud_message_checks.py')
        done = subprocess.run([python, script, self.again], stdout=subprocess.PIPE, check=True)
        found = json.loads(done.stdout)
        last = clouds_in(self.again, '/lidar_top')
        lidar, radar = found['/lidar_top'], found['/radar_front']
        self.assertEqual(lidar['fields'], ['x', 'y', 'z', 'intensity', 'ring'])
        self.assertEqual([tuple(point) for point in lidar['points']], points_in(last[max(last)]))
        self.assertTrue(all(math.isfinite(value) for point in lidar['points'] for value in point))
        self.assertEqual(radar['fields'], RADAR_FIELDS)
        self.assertEqual(radar['points'], [list(map(float, point)) for point in RADAR_POINTS])


if __name__ == '__main__':
    os.chdir(Path(__file__).parents[2])
    unittest.main()
