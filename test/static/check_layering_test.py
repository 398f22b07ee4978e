#!/usr/bin/python3
"""What check_layering.py must find, and what it must let pass."""
import tempfile
import unittest
from pathlib import Path

from check_layering import violations


def violations_of(**files):
    """violations() of a tree; `map__lane_h='a.h b.h'` stands for src/map/lane.h that includes a.h and b.h."""
    with tempfile.TemporaryDirectory() as src:
        for key, included in files.items():
            name, suffix = key.replace('__', '/').rsplit('_', 1)
            path = Path(src, name + '.' + suffix)
            path.parent.mkdir(exist_ok=True)
            path.write_text('\n'.join('#include <{}>'.format(header) for header in included.split()))
        return violations(Path(src))


class CheckLayering(unittest.TestCase):
    def test_lower_modules_may_be_included(self):
        self.assertEqual([], violations_of(geometry__a_h='vector', map__b_cpp='geometry/a.h'))

    def test_higher_modules_may_not(self):
        self.assertEqual(['src/geometry/a.cpp: map is above geometry'],
                         violations_of(geometry__a_cpp='map/b.h', map__b_h=''))

    def test_batch_is_between_formats_and_tools(self):
        self.assertEqual([], violations_of(formats__a_h='', batch__b_h='formats/a.h', tools__c_cpp='batch/b.h'))
        self.assertEqual(['src/formats/a.cpp: batch is above formats'],
                         violations_of(formats__a_cpp='batch/b.h', batch__b_h=''))

    def test_dataset_is_between_protocols_and_tools(self):
        self.assertEqual([], violations_of(protocols__a_h='', dataset__b_h='protocols/a.h', tools__c_cpp='dataset/b.h'))
        self.assertEqual(['src/protocols/a.cpp: dataset is above protocols'],
                         violations_of(protocols__a_cpp='dataset/b.h', dataset__b_h=''))

    def test_ros_stays_in_its_modules(self):
        self.assertEqual([], violations_of(ros__a_cpp='ros/ros.h', ros__bag_reader_cpp='rosbag/bag.h',
                                           tools__b_cpp='nav_msgs/Path.h', rviz__c_cpp='rviz/panel.h'))
        self.assertEqual(1, len(violations_of(formats__tables_cpp='ros/time.h')))
        self.assertEqual(1, len(violations_of(scene__a_cpp='geometry_msgs/Pose.h')))
        self.assertEqual(1, len(violations_of(scene__a_cpp='collision_forge/Agent.h')))

    def test_own_folder_named_ros_is_not_ros(self):
        self.assertEqual([], violations_of(ros__conversions_h='', tools__a_cpp='ros/conversions.h'))

    def test_torch_stays_in_network(self):
        self.assertEqual([], violations_of(network__a_cpp='torch/torch.h'))
        self.assertEqual(1, len(violations_of(attack__a_cpp='ATen/ATen.h')))

    def test_network_headers_hide_torch(self):
        self.assertEqual([], violations_of(network__a_h='vector', network__a_cpp='torch/torch.h network/a.h',
                                           tools__b_cpp='network/a.h'))
        self.assertEqual(['src/tools/b.cpp: network/a.h brings torch out of src/network'],
                         violations_of(network__a_h='network/c.h', network__c_h='torch/torch.h',
                                       tools__b_cpp='network/a.h'))

    def test_mpi_stays_in_batch(self):
        self.assertEqual([], violations_of(batch__a_cpp='mpi.h'))
        self.assertEqual(['src/tools/a.cpp: mpi.h: MPI has no place outside src/batch'],
                         violations_of(tools__a_cpp='mpi.h'))

    def test_a_new_module_must_be_given_a_layer(self):
        self.assertEqual(1, len(violations_of(physics__a_cpp='vector')))

    def test_an_empty_tree_is_no_success(self):
        self.assertEqual(1, len(violations_of()))


if __name__ == '__main__':
    unittest.main()
