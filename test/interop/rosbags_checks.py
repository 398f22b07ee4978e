"""usage: rosbags_checks.py BAG: the contents of a bag with an attack as read by the package rosbags, as JSON.

For an environment of their own, without ROS. Types that ROS itself does not bring are learned from the definitions in
the bag, and their md5 is computed from these.
"""
import json
import sys
from pathlib import Path

from rosbags.rosbag1 import Reader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

READ = ('/attack_path', '/attack_ego_path', '/agent_objects', '/attack_markers', '/annotation_markers', '/odom')


def stamp_of(header):
    return header.stamp.sec * 10 ** 9 + header.stamp.nanosec


def place_of(pose):
    return [pose.position.x, pose.position.y, pose.position.z]


def told(topic, message):
    """Return the fields of a message that the test compares."""
    if topic.endswith('_path'):
        return {'frame': message.header.frame_id, 'stamp': stamp_of(message.header),
                'poses': [[stamp_of(pose.header), place_of(pose.pose)] for pose in message.poses]}
    if topic == '/agent_objects':
        return {'stamp': stamp_of(message.header), 'objects': [
            [one.id, place_of(one.pose), one.classification, one.shape.dimensions.tolist()] for one in message.objects]}
    if topic == '/odom':
        return {'stamp': stamp_of(message.header), 'place': place_of(message.pose.pose)}
    return {'markers': [[marker.ns, place_of(marker.pose)] for marker in message.markers]}


def read(path):
    store = get_typestore(Stores.ROS1_NOETIC)
    found = {topic: [] for topic in READ}
    with Reader(path) as bag:
        connections = [connection for connection in bag.connections if connection.topic in READ]
        own = sorted({connection.msgtype for connection in connections} - set(store.types))
        for connection in connections:
            if connection.msgtype in own:
                types = get_types_from_msg(connection.msgdef.data, connection.msgtype)
                store.register({name: fields for name, fields in types.items() if name not in store.types})
        digests = {connection.topic: [connection.digest, store.generate_msgdef(connection.msgtype)[1]]
                   for connection in connections}
        for connection, time, data in bag.messages(connections=connections):
            message = store.deserialize_ros1(data, connection.msgtype)
            found[connection.topic].append([time, told(connection.topic, message)])
    return {'learned': own, 'digests': digests, 'found': found}


if __name__ == '__main__':
    json.dump(read(Path(sys.argv[1])), sys.stdout)
