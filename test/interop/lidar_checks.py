"""usage: lidar_checks.py DATAROOT VERSION STAMP BOX: a sweep of LIDAR_TOP as the devkit of nuScenes reads it.

Run by the interpreter of an environment with nuscenes-devkit. STAMP: of the sweep, us. BOX: `center` (m, map), `size`
(width, length, height, m) and `rotation` (w, x, y, z) as JSON. Prints as JSON: the number of points, the SHA-256 of
x, y, z and intensity of all, the indices of the points in the box, and the points of the radar file.
"""
import hashlib
import json
import sys
from pathlib import Path

from nuscenes.nuscenes import NuScenes
from nuscenes.utils.data_classes import Box, LidarPointCloud, RadarPointCloud
from nuscenes.utils.geometry_utils import points_in_box, transform_matrix
from pyquaternion import Quaternion


def main(dataroot, version, stamp, box):
    data = NuScenes(version, dataroot, verbose=False)
    sweep = next(row for row in data.sample_data if row['timestamp'] == int(stamp) and row['channel'] == 'LIDAR_TOP')
    cloud = LidarPointCloud.from_file(str(Path(dataroot, sweep['filename'])))
    found = {'points': cloud.nbr_points(),
             'digest': hashlib.sha256(cloud.points.T.astype('<f4').tobytes()).hexdigest()}
    for row in (data.get('calibrated_sensor', sweep['calibrated_sensor_token']),
                data.get('ego_pose', sweep['ego_pose_token'])):
        cloud.transform(transform_matrix(row['translation'], Quaternion(row['rotation'])))
    box = json.loads(box)
    inside = points_in_box(Box(box['center'], box['size'], Quaternion(box['rotation'])), cloud.points[:3], wlh_factor=1.1)
    found['in_box'] = inside.nonzero()[0].tolist()
    radar = next(row for row in data.sample_data if row['channel'] == 'RADAR_FRONT')
    found['radar'] = RadarPointCloud.from_file(str(Path(dataroot, radar['filename']))).points.T.tolist()
    json.dump(found, sys.stdout)


if __name__ == '__main__':
    main(*sys.argv[1:])
