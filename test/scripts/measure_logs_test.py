#!/usr/bin/python3
"""What scripts/measure_logs computes from raw files."""
import importlib.machinery
import math
import unittest
from pathlib import Path

import numpy as np

SCRIPT = Path(__file__).resolve().parents[2] / 'scripts' / 'measure_logs'
measure_logs = importlib.machinery.SourceFileLoader('measure_logs', str(SCRIPT)).load_module()


def lane(*points, kind='LANE_SURFACE_STREET'):
    return {'type': kind, 'polyline': np.array(points)}


class MeasureLogsTest(unittest.TestCase):
    def test_boxes_overlap_from_their_first_contact(self):
        boxes = np.array([[x, 0.0, 0.0] for x in (3.9, 4.1)])
        across = np.array([[x, 0.0, math.pi / 2] for x in (2.9, 3.1)])
        self.assertEqual(measure_logs.overlap(boxes, (4.0, 2.0), np.zeros((2, 3)), (4.0, 2.0)).tolist(), [True, False])
        self.assertEqual(measure_logs.overlap(across, (4.0, 2.0), np.zeros((2, 3)), (4.0, 2.0)).tolist(), [True, False])

    def test_a_pose_is_on_a_lane_near_it_in_its_direction(self):
        lanes = measure_logs.lanes_of({'map_features': {
            '1': lane((0.0, 0.0), (50.0, 0.0)), '2': lane((0.0, 4.0), (50.0, 4.0), kind='LANE_BIKE_LANE')}})
        self.assertEqual(measure_logs.on_lane([(20.0, 1.9, 0.4)], lanes), 1.0)
        for pose in ((20.0, 4.0, 0.0), (20.0, 0.0, 0.5), (20.0, 0.0, math.pi)):
            self.assertEqual(measure_logs.on_lane([pose], lanes), 0.0)

    def test_a_class_is_right_by_the_most_that_the_file_says(self):
        def is_right(kind, found, **metadata):
            return measure_logs.is_class_right({'type': kind, 'metadata': metadata}, found)
        self.assertTrue(is_right('VEHICLE', 'bus', type='vehicle.bus.rigid'))
        self.assertFalse(is_right('VEHICLE', 'truck', type='vehicle.bus.rigid'))
        self.assertTrue(is_right('VEHICLE', 'truck', type='VEHICLE'))
        self.assertFalse(is_right('CYCLIST', 'car'))
        self.assertTrue(is_right('TRAFFIC_CONE', 'static_object'))

    def test_a_motion_has_the_valid_rows_alone(self):
        state = {'position': np.array([[0.0, 0.0], [9.0, 9.0], [2.0, 0.0]]), 'heading': np.zeros(3),
                 'valid': np.array([1.0, 0.0, 1.0]), 'length': np.array([4.0, 0.0, 4.0]), 'width': np.full(3, 2.0)}
        motion = measure_logs.Motion({'state': state}, np.array([0.0, 1.0, 2.0]))
        self.assertEqual(motion.at([1.0]).tolist(), [[1.0, 0.0, 0.0]])
        self.assertEqual(motion.size, [4.0, 2.0])


if __name__ == '__main__':
    unittest.main()
