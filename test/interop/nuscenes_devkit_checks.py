"""usage: nuscenes_devkit_checks.py DATAROOT VERSION LANES: how a data root looks to the devkit of nuScenes.

Run by the interpreter of an environment with nuscenes-devkit. LANES: by location and by id the `line` of a lane, points
1 m apart, and which of these are `incoming` and `outgoing`, as JSON. Prints as JSON what differs.
"""
import json
import sys
from pathlib import Path

import numpy
from nuscenes.map_expansion import map_api
from nuscenes.nuscenes import NuScenes

SPACING = 1.0  # m
REPEATED = 0.001  # m; the devkit returns a point twice where two arcs meet


def centreline(points):
    """Return the points without consecutive duplicates."""
    points = numpy.array(points)[:, :2]
    steps = numpy.linalg.norm(numpy.diff(points, axis=0), axis=1)
    return points[numpy.concatenate(([True], steps > REPEATED))]


def farthest(ours, theirs):
    """Return the largest distance (m) of points of equal index in two lines; infinite if their counts differ."""
    if ours.shape != theirs.shape:
        return float('inf')
    return float(numpy.linalg.norm(ours - theirs, axis=1).max())


def lane_differences(dataroot, location, lanes):
    roads = map_api.NuScenesMap(dataroot, location)
    tokens = {row['token'] for row in roads.lane + roads.lane_connector}
    shared = sorted(tokens & lanes.keys())
    found = roads.discretize_lanes(shared, SPACING)
    return {'unknown': sorted(lanes.keys() - tokens),
            'farthest': max(farthest(centreline(lanes[token]['line']), centreline(found[token])) for token in shared),
            'linked_otherwise': [token for token in shared
                                 if lanes.keys() & roads.get_incoming_lane_ids(token) != set(lanes[token]['incoming'])
                                 or lanes.keys() & roads.get_outgoing_lane_ids(token) != set(lanes[token]['outgoing'])]}


def poses_off_the_road(data):
    """Yield the tokens of the ego's poses that are off the road by the map mask."""
    masks = {log: row['mask'] for row in data.map for log in row['log_tokens']}
    for scene in data.scene:
        sample = data.get('sample', scene['first_sample_token'])
        while sample:
            message = data.get('sample_data', sample['data']['LIDAR_TOP'])
            pose = data.get('ego_pose', message['ego_pose_token'])
            x, y = pose['translation'][:2]
            if not masks[scene['log_token']].is_on_mask([x], [y])[0]:
                yield pose['token']
            sample = sample['next'] and data.get('sample', sample['next'])


def main(dataroot, version, path):
    lanes = json.loads(Path(path).read_text(encoding='utf-8'))
    map_api.locations.extend(lanes)  # it only knows the four towns of nuScenes
    data = NuScenes(version, dataroot, verbose=False)
    json.dump({'scenes': len(data.scene), 'boxes': sum(len(sample['anns']) for sample in data.sample),
               'off_the_road': list(poses_off_the_road(data)),
               'towns': {location: lane_differences(dataroot, location, lanes[location]) for location in lanes}},
              sys.stdout)


if __name__ == '__main__':
    main(*sys.argv[1:])
