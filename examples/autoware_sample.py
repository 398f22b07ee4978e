#!/usr/bin/python3
"""usage: autoware_sample.py BAG OUT: write a sample in Autoware's manner, made of a bag of this suite.

Writes OUT.bag: the ego as nav_msgs/Odometry on /localization/kinematic_state, the agents as
autoware_auto_perception_msgs/TrackedObjects on /perception/object_recognition/tracking/objects, as rosbags-convert
converts them from ROS 2, without lanes. Writes OUT.osm: the lanes of the bag as a Lanelet2 map with local_x and local_y.
"""
import argparse
import math
from typing import Any, Dict, Iterator, List, Tuple
from xml.etree import ElementTree

import rosbag
from genpy.dynamic import generate_dynamic
from geometry_msgs.msg import AccelWithCovariance, Polygon, PoseWithCovariance, TwistWithCovariance, Vector3

ODOMETRY = '/localization/kinematic_state'
OBJECTS = '/perception/object_recognition/tracking/objects'
TYPE = 'autoware_auto_perception_msgs/TrackedObjects'
RULE = '=' * 80
OWN_TYPES = {
    TYPE: 'std_msgs/Header header\nautoware_auto_perception_msgs/TrackedObject[] objects',
    'autoware_auto_perception_msgs/TrackedObject':
        'unique_identifier_msgs/UUID object_id\nfloat32 existence_probability\n'
        'autoware_auto_perception_msgs/ObjectClassification[] classification\n'
        'autoware_auto_perception_msgs/TrackedObjectKinematics kinematics\n'
        'autoware_auto_perception_msgs/Shape shape',
    'unique_identifier_msgs/UUID': 'uint8[16] uuid',
    'autoware_auto_perception_msgs/ObjectClassification': 'uint8 label\nfloat32 probability',
    'autoware_auto_perception_msgs/TrackedObjectKinematics':
        'geometry_msgs/PoseWithCovariance pose_with_covariance\nuint8 orientation_availability\n'
        'geometry_msgs/TwistWithCovariance twist_with_covariance\n'
        'geometry_msgs/AccelWithCovariance acceleration_with_covariance\nbool is_stationary',
    'autoware_auto_perception_msgs/Shape':
        'uint8 type\ngeometry_msgs/Polygon footprint\ngeometry_msgs/Vector3 dimensions',
    'std_msgs/Header': 'uint32 seq\ntime stamp\nstring frame_id',
}
# Labels of Autoware for the classes of derived_object_msgs; 0 is unknown.
LABELS = {4: 7, 5: 6, 6: 1, 7: 2, 8: 5, 9: 3}
LANE_WIDTH = 3.5  # m, of lanes without an outline

Point = Tuple[float, float]


def definition() -> str:
    """Return the definition of TrackedObjects with all types that it uses."""
    types = dict(OWN_TYPES)
    for message in (PoseWithCovariance, TwistWithCovariance, AccelWithCovariance, Polygon, Vector3):
        first, *others = message._full_text.split(RULE + '\nMSG: ')
        types.setdefault(message._type, first)
        for other in others:
            name, text = other.split('\n', 1)
            types.setdefault(name, text)
    main = types.pop(TYPE)
    return '\n'.join([main] + ['{}\nMSG: {}\n{}'.format(RULE, name, text) for name, text in types.items()])


def tracked(source: Any, classes: Dict[str, Any]) -> Any:
    """Return an object of derived_object_msgs as a TrackedObject."""
    found = classes['autoware_auto_perception_msgs/TrackedObject']()
    found.object_id.uuid = source.id.to_bytes(16, 'little')
    found.existence_probability = 1.0
    label = classes['autoware_auto_perception_msgs/ObjectClassification']()
    label.label, label.probability = LABELS.get(source.classification, 0), 1.0
    found.classification = [label]
    found.kinematics.pose_with_covariance.pose = source.pose
    found.kinematics.orientation_availability = 2
    speed = math.hypot(source.twist.linear.x, source.twist.linear.y)
    found.kinematics.twist_with_covariance.twist.linear.x = speed
    length, width, height = source.shape.dimensions
    found.shape.dimensions = Vector3(length, width, height)
    return found


def write_bag(source: str, path: str) -> None:
    classes = generate_dynamic(TYPE, definition())
    with rosbag.Bag(source) as bag, rosbag.Bag(path, 'w') as out:
        for topic, message, stamp in bag.read_messages(['/odom', '/agent_objects']):
            if topic == '/odom':
                message.header.frame_id = 'map'
                out.write(ODOMETRY, message, stamp)
                continue
            objects = classes[TYPE]()
            objects.header = message.header
            objects.objects = [tracked(one, classes) for one in message.objects]
            out.write(OBJECTS, objects, stamp)


def width_of(lane: Any) -> float:
    """Return the area of the outline over the length of the centreline, m."""
    points = lane.polygon.points
    twice = sum(a.x * b.y - b.x * a.y for a, b in zip(points, [*points[1:], *points[:1]]))
    line = lane.centerline
    length = sum(math.hypot(b.x - a.x, b.y - a.y) for a, b in zip(line, line[1:]))
    return abs(twice) / 2 / length if points and length else LANE_WIDTH


class Lanelet2Map:
    """A Lanelet2 map with local coordinates."""

    def __init__(self) -> None:
        self.root = ElementTree.Element('osm', version='0.6', generator='collision_forge')
        self.ids: Iterator[int] = iter(range(1, 10 ** 9))

    def element(self, name: str, tags: Dict[str, str], **attributes: str) -> ElementTree.Element:
        made = ElementTree.SubElement(self.root, name, id=str(next(self.ids)), **attributes)
        for key, value in tags.items():
            ElementTree.SubElement(made, 'tag', k=key, v=value)
        return made

    def node(self, point: Point) -> str:
        tags = {'local_x': '{:.4f}'.format(point[0]), 'local_y': '{:.4f}'.format(point[1]), 'ele': '0'}
        return self.element('node', tags, lat='0', lon='0').get('id', '')

    def way(self, nodes: List[str]) -> str:
        way = self.element('way', {'type': 'line_thin', 'subtype': 'solid'})
        for node in nodes:
            ElementTree.SubElement(way, 'nd', ref=node)
        return way.get('id', '')

    def lanelet(self, left: str, right: str, is_connector: bool) -> None:
        tags = {'type': 'lanelet', 'subtype': 'road', 'location': 'urban', 'one_way': 'yes'}
        if is_connector:
            tags['turn_direction'] = 'straight'
        relation = self.element('relation', tags)
        for role, way in (('left', left), ('right', right)):
            ElementTree.SubElement(relation, 'member', type='way', role=role, ref=way)


def joints_of(lanes: List[Any]) -> Dict[Tuple[str, str], int]:
    """Return a number for the start and the end of each lane, the same where lanes meet."""
    numbers = {(lane.id, end): 2 * i + (end == 'end') for i, lane in enumerate(lanes) for end in ('start', 'end')}
    for lane in lanes:
        for after in lane.outgoing:
            old, new = numbers[(after, 'start')], numbers[(lane.id, 'end')]
            numbers = {key: new if number == old else number for key, number in numbers.items()}
    return numbers


def write_map(source: str, path: str) -> None:
    with rosbag.Bag(source) as bag:
        lanes = [lane for _, message, _ in bag.read_messages('/lane_map') for lane in message.lanes]
    joints, nodes, made = joints_of(lanes), {}, Lanelet2Map()
    for lane in lanes:
        half, line = width_of(lane) / 2, lane.centerline
        ways = []
        for side in (1, -1):
            points = [(pose.x - side * half * math.sin(pose.theta), pose.y + side * half * math.cos(pose.theta))
                      for pose in line]
            first, last = ((joints[(lane.id, end)], side) for end in ('start', 'end'))
            for joint, point in ((first, points[0]), (last, points[-1])):
                if joint not in nodes:
                    nodes[joint] = made.node(point)
            ways.append(made.way([nodes[first], *map(made.node, points[1:-1]), nodes[last]]))
        made.lanelet(*ways, lane.is_connector)
    ElementTree.ElementTree(made.root).write(path, encoding='utf-8', xml_declaration=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('bag')
    parser.add_argument('out')
    arguments = parser.parse_args()
    write_bag(arguments.bag, arguments.out + '.bag')
    write_map(arguments.bag, arguments.out + '.osm')


if __name__ == '__main__':
    main()
