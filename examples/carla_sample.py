#!/usr/bin/python3
"""usage: carla_sample.py BAG OUT: write ego and agents of a bag as the CARLA ROS bridge does."""
import math
import sys

import rosbag

BASE_LINK_TO_MIDDLE = 1.385  # m

with rosbag.Bag(sys.argv[1]) as recorded, rosbag.Bag(sys.argv[2], 'w') as bridge:
    for topic, message, time in recorded.read_messages(['/odom', '/agent_objects']):
        if topic == '/odom':
            pose = message.pose.pose
            yaw = 2.0 * math.atan2(pose.orientation.z, pose.orientation.w)
            pose.position.x += BASE_LINK_TO_MIDDLE * math.cos(yaw)
            pose.position.y += BASE_LINK_TO_MIDDLE * math.sin(yaw)
        name = 'odometry' if topic == '/odom' else 'objects'
        bridge.write('/carla/ego_vehicle/' + name, message, time)
