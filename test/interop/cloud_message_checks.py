"""usage: cloud_message_checks.py BAG: the newest cloud of each topic of sensor_msgs/PointCloud2 as pypcd4 reads it.

Run by the interpreter of an environment with pypcd4 and rosbags. Prints fields and points by topic as JSON.
"""
import json
import sys
from pathlib import Path

from pypcd4 import PointCloud
from rosbags.rosbag1 import Reader
from rosbags.typesys import Stores, get_typestore


def main(path):
    store = get_typestore(Stores.ROS1_NOETIC)
    found = {}
    with Reader(Path(path)) as bag:
        wanted = [connection for connection in bag.connections
                  if connection.msgtype == 'sensor_msgs/msg/PointCloud2']
        for connection, _, data in bag.messages(connections=wanted):
            cloud = PointCloud.from_msg(store.deserialize_ros1(data, connection.msgtype))
            points = [[float(value) for value in point] for point in cloud.pc_data.tolist()]
            found[connection.topic] = {'fields': list(cloud.fields), 'points': points}
    json.dump(found, sys.stdout)


if __name__ == '__main__':
    main(sys.argv[1])
