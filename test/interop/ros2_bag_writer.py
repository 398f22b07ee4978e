"""usage: ros2_bag_writer.py BAG OUT sqlite3|mcap: a bag of this project as Autoware records it with ROS 2.

For an environment of their own, without ROS. The ego's pose is the chain map, odom, base_link on /tf; the agents are
TrackedObjects in the frame base_link.
"""
import sys
from importlib.machinery import SourceFileLoader
from pathlib import Path

import numpy
from rosbags.highlevel import AnyReader
from rosbags.rosbag2 import StoragePlugin, Writer

CONVERTER = SourceFileLoader('ros2_bag', str(Path(__file__).parents[2] / 'scripts' / 'ros2_bag')).load_module()
STORE = CONVERTER.known_types([])
PACKAGE = 'autoware_auto_perception_msgs/msg/'
LABELS = {6: 1, 7: 2, 9: 3, 8: 5, 5: 6, 4: 7}  # of Autoware, by class of derived_object_msgs
ORIGIN = (100.0, 50.0)  # m, of odom in map


def made(name, *values):
    return STORE.types[name](*values)


def vector(x=0.0, y=0.0, z=0.0, kind='Vector3'):
    return made('geometry_msgs/msg/' + kind, float(x), float(y), float(z))


def header(stamp, frame):
    return made('std_msgs/msg/Header', made('builtin_interfaces/msg/Time', stamp.sec, stamp.nanosec), frame)


def turn(yaw):
    return made('geometry_msgs/msg/Quaternion', 0.0, 0.0, float(numpy.sin(0.5 * yaw)), float(numpy.cos(0.5 * yaw)))


def yaw_of(rotation):
    return 2.0 * numpy.arctan2(rotation.z, rotation.w)


def transform(stamp, parent, child, place, yaw):
    return made('geometry_msgs/msg/TransformStamped', header(stamp, parent), child,
                made('geometry_msgs/msg/Transform', vector(*place), turn(yaw)))


def chain(pose):
    """The message of /tf for a transform from map to base_link."""
    stamp, moved = pose.header.stamp, pose.transform
    place = (moved.translation.x - ORIGIN[0], moved.translation.y - ORIGIN[1], moved.translation.z)
    return made('tf2_msgs/msg/TFMessage', [transform(stamp, 'map', 'odom', ORIGIN, 0.0),
                                           transform(stamp, 'odom', 'base_link', place, yaw_of(moved.rotation))])


def tracked(one, ego):
    """A TrackedObject for an object in the map frame and the transform from map to base_link."""
    yaw = yaw_of(ego.rotation)
    away = numpy.array([one.pose.position.x - ego.translation.x, one.pose.position.y - ego.translation.y])
    x, y = numpy.array([[numpy.cos(yaw), numpy.sin(yaw)], [-numpy.sin(yaw), numpy.cos(yaw)]]) @ away
    place = vector(x, y, one.pose.position.z - ego.translation.z, 'Point')
    pose = made('geometry_msgs/msg/Pose', place, turn(yaw_of(one.pose.orientation) - yaw))
    still, unknown = made('geometry_msgs/msg/Twist', vector(), vector()), numpy.zeros(36)
    kinematics = made(
        PACKAGE + 'TrackedObjectKinematics', made('geometry_msgs/msg/PoseWithCovariance', pose, unknown), 1,
        made('geometry_msgs/msg/TwistWithCovariance', still, unknown),
        made('geometry_msgs/msg/AccelWithCovariance', made('geometry_msgs/msg/Accel', vector(), vector()), unknown), False)
    identity = made('unique_identifier_msgs/msg/UUID', numpy.frombuffer(one.id.to_bytes(16, 'big'), dtype=numpy.uint8))
    label = made(PACKAGE + 'ObjectClassification', LABELS.get(one.classification, 0), 1.0)
    shape = made(PACKAGE + 'Shape', 0, made('geometry_msgs/msg/Polygon', []), vector(*one.shape.dimensions))
    return made(PACKAGE + 'TrackedObject', identity, 1.0, [label], kinematics, shape)


def write(source, out, storage):
    """The objects of a frame follow the transform at their stamp, which is there for every frame of the source."""
    ego = {}
    with AnyReader([source]) as bag, Writer(out, version=9, storage_plugin=storage) as writer:
        transforms = writer.add_connection('/tf', 'tf2_msgs/msg/TFMessage', typestore=STORE)
        objects = writer.add_connection('/perception/object_recognition/tracking/objects', PACKAGE + 'TrackedObjects',
                                        typestore=STORE)
        for connection, time, data in bag.messages():
            if connection.topic == '/tf':
                pose, = bag.deserialize(data, connection.msgtype).transforms
                ego[pose.header.stamp.sec, pose.header.stamp.nanosec] = pose.transform
                writer.write(transforms, time, STORE.serialize_cdr(chain(pose), transforms.msgtype))
        for connection, time, data in bag.messages():
            if connection.topic == '/agent_objects':
                frame = bag.deserialize(data, connection.msgtype)
                stamp = frame.header.stamp
                message = made(PACKAGE + 'TrackedObjects', header(stamp, 'base_link'),
                               [tracked(one, ego[stamp.sec, stamp.nanosec]) for one in frame.objects])
                writer.write(objects, time, STORE.serialize_cdr(message, objects.msgtype))


if __name__ == '__main__':
    write(Path(sys.argv[1]), Path(sys.argv[2]), StoragePlugin[sys.argv[3].upper()])
