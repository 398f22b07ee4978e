#!/usr/bin/python3
"""Test the statistics of the scorecard on samples with known results."""
import csv
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
from threadpoolctl import threadpool_limits

PROGRAMS = Path(__file__).resolve().parents[3] / 'python' / 'collision_forge_study'
sys.path.insert(0, str(PROGRAMS))
import distances  # noqa: E402
import motion  # noqa: E402
import scorecard  # noqa: E402

LIMIT = threadpool_limits(1)  # threads that wait for a busy processor take longer than one alone
TIMES = 0.5 * (np.arange(motion.SAMPLES) - motion.MIDDLE)


def drives(count, speed=8.0, acceleration=0.0, scenes=20, noise=0.0, generated=motion.SAMPLES, seed=1):
    """Return straight drives of cars along x; arguments are one number or one per drive."""
    rng = np.random.default_rng(seed)
    windows = np.zeros((count, motion.SAMPLES, 4))
    windows[:, :, 0] = 100.0 + TIMES
    speed, acceleration = (np.broadcast_to(value, count)[:, None] for value in (speed, acceleration))
    windows[:, :, 1] = speed * TIMES + 0.5 * acceleration * TIMES ** 2
    windows[:, :, 1:3] += rng.normal(0.0, noise, (count, motion.SAMPLES, 2)) if noise else 0.0
    values = {name: np.ones(count) for name in motion.ROAD_COLUMNS}
    return motion.Drives(np.array(['scene-{}'.format(index % scenes) for index in range(count)]), np.full(count, 'rear_end'),
                         np.full(count, 3.0), np.full(count, 'car'), np.full(count, 4.6), values,
                         np.full(count, generated), windows)


def random_motion(count, mean_speed, seed, scenes=20):
    rng = np.random.default_rng(seed)
    return motion.motion_of(drives(count, rng.normal(mean_speed, 1.0, count), rng.normal(0.0, 0.5, count), scenes))


class MotionTest(unittest.TestCase):
    def test_derivatives_are_exact_for_a_cubic(self):
        # Across the wrap of the yaw at pi, unevenly sampled.
        times = TIMES + 0.05 * np.array([1, -1, 1, -1, 1, -1, 1])
        x, y, yaw = [1000.0, -6.0, 0.7, 0.2], [-500.0, 4.0, -0.3, 0.1], [np.pi, 0.3, -0.2, 0.05]
        window = np.stack([times] + [np.polyval(value[::-1], times) for value in (x, y, yaw)], axis=1)[None]
        middle = times[motion.MIDDLE]
        states = motion.states_of(window, np.array([4.6]))
        velocity = np.array([np.polyval([0.6, 1.4, -6.0], times), np.polyval([0.3, -0.6, 4.0], times)])
        ahead = velocity / np.linalg.norm(velocity, axis=0)
        yaw_rate = np.polyval([0.15, -0.4, 0.3], times)
        for quantity, expected in (('speed', np.linalg.norm(velocity, axis=0)),
                                   ('acceleration', 1.2 * times * ahead[0] + 1.4 * ahead[0] + (0.6 * times - 0.6) * ahead[1]),
                                   ('jerk', 1.2 * ahead[0] + 0.6 * ahead[1]), ('yaw rate', yaw_rate),
                                   ('yaw acceleration', 0.3 * times - 0.4)):
            np.testing.assert_allclose(states[quantity][0], expected, atol=1e-8, err_msg=quantity)
        self.assertNotEqual(middle, 0.0)

    def test_steering_follows_the_single_track_model_and_is_unknown_at_low_speed(self):
        window = np.stack([TIMES, 8.0 * TIMES + 0.5 * TIMES ** 2, 0.0 * TIMES, 0.3 * TIMES + 0.05 * TIMES ** 2], axis=1)
        wheelbase = motion.WHEELBASE_SHARE * 4.6
        states = motion.states_of(window[None], np.array([4.6]))
        angle = lambda time: np.arctan(wheelbase * (0.3 + 0.1 * time) / (8.0 + time))
        np.testing.assert_allclose(states['steering angle'][0], angle(TIMES), atol=1e-9)
        np.testing.assert_allclose(states['steering rate'][0], (angle(TIMES + 1e-5) - angle(TIMES - 1e-5)) / 2e-5, atol=1e-7)
        slow = motion.states_of(drives(1, 1.8).windows, np.array([4.6]))
        self.assertTrue(np.isnan(slow['steering angle']).all())

    def test_noise_has_the_size_of_the_recording_and_affects_only_generated_samples(self):
        attacks = drives(4000, generated=3)
        recorded = drives(4000, noise=0.2)
        moved = motion.with_recorded_noise(attacks, recorded, np.random.default_rng(2)).windows - attacks.windows
        np.testing.assert_array_equal(moved[:, :4], 0.0)
        np.testing.assert_allclose(moved[:, 4:, 1:3].std(axis=(0, 1)), 0.2, atol=0.01)
        np.testing.assert_array_equal(moved[:, :, [0, 3]], 0.0)


class DistancesTest(unittest.TestCase):
    def test_a_shift_is_its_wasserstein_distance(self):
        first, second = (motion.motion_of(drives(50, speed)) for speed in (8.0, 11.0))
        self.assertAlmostEqual(distances.distances_of(first, second, 'speed')[1], 3.0)
        self.assertAlmostEqual(distances.distances_of(first, second, 'acceleration')[1], 0.0)

    def test_divergence_of_half_moved_mass_equals_the_manual_value(self):
        first = motion.motion_of(drives(40, 3.0))
        second = motion.motion_of(drives(40, np.repeat([3.0, 20.0], 20)))
        # p = (1, 0), q = (1/2, 1/2): half of log2(4/3), and a quarter of log2(2/3) and of log2(2).
        expected = 0.5 * np.log2(4.0 / 3.0) + 0.25 * np.log2(2.0 / 3.0) + 0.25
        self.assertAlmostEqual(distances.distances_of(first, second, 'speed')[0], expected)

    def test_floors_of_samples_of_one_distribution_are_small(self):
        floors = distances.distance_floors(random_motion(2000, 8.0, 1), 500)
        self.assertLess(floors['speed'][0].most, 0.02)
        self.assertGreaterEqual(floors['speed'][1].most, floors['speed'][1].mean)


class ClassifierTest(unittest.TestCase):
    def test_separated_samples_are_distinguished(self):
        areas = distances.areas_of(random_motion(300, 5.0, 1), random_motion(300, 15.0, 2), 1)
        self.assertEqual(areas, (1.0, 1.0))

    def test_a_shift_is_detected_as_well_as_by_the_optimal_rule(self):
        # Normal speeds, one standard deviation apart: the area is the normal distribution function of 1 / sqrt(2).
        areas = distances.areas_of(random_motion(1500, 8.0, 1), random_motion(1500, 9.0, 2), 1)
        self.assertAlmostEqual(areas.logistic, 0.760, delta=0.03)
        self.assertAlmostEqual(areas.forest, 0.760, delta=0.03)

    def test_matches_share_class_and_band_and_prefer_the_same_scene(self):
        attacks = motion.motion_of(drives(2, np.array([3.0, 8.0]), scenes=2))
        recorded = motion.motion_of(drives(8, np.array([3.0, 8.0, 3.0, 8.0, 3.0, 8.0, 8.0, 20.0]), scenes=8))
        matched, matches = distances.match(attacks, recorded, np.random.default_rng(1))
        self.assertEqual(list(matched.scene), ['scene-0', 'scene-1'])
        self.assertEqual(sorted(matches.scene[matches.band == '2-5 m/s']), ['scene-0', 'scene-2', 'scene-4'])
        of_second = list(matches.scene[matches.band == '5-10 m/s'])
        self.assertEqual((len(of_second), of_second[0]), (3, 'scene-1'))


class ProgramTest(unittest.TestCase):
    """Test the program on a small motion.csv."""

    def write(self, folder, attacks, recorded):
        columns = ('driver', 'scene', 'type', 'tta', 'attacker', 'class', 'length', 'width') + motion.ROAD_COLUMNS + \
            motion.PEAK_COLUMNS + ('least_gap', 'window') + tuple('max_' + peak for peak in motion.PEAK_COLUMNS)
        with open(str(folder / 'motion.csv'), 'w', newline='') as file:
            writer = csv.writer(file)
            writer.writerow(columns)
            for driver, found in (('search', attacks), ('recorded', recorded)):
                for scene, window in zip(found.scene, found.windows):
                    asked = ('rear_end', '3') if driver == 'search' else ('', '')
                    text = ' '.join(['7'] + ['{:.6f}'.format(number) for number in window.ravel()])
                    text = '' if np.isnan(window).any() else text
                    writer.writerow((driver, scene) + asked + ('a', 'car', 4.6, 1.9, 1.0, 0.0, 0.0, 0.0, 0.0, 0.2, 1.0, 2.0,
                                                               '', text, 0.4, 10.0, 8.0))

    def test_three_files_are_written_reproducibly(self):
        rng = np.random.default_rng(1)
        with tempfile.TemporaryDirectory() as path:
            folder = Path(path)
            attacks = drives(101, rng.normal(8.0, 1.0, 101))
            attacks.windows[0] = np.nan
            self.write(folder, attacks, drives(401, np.append(rng.normal(8.0, 1.0, 400), 0.9)))
            names = ('scorecard.md', 'scorecard.csv', 'scorecard.png')
            found = []
            for _ in range(2):
                with mock.patch.object(distances, 'DRAWS', 2), mock.patch('sys.argv', ['scorecard.py', path]):
                    scorecard.main()
                found.append([(folder / name).read_bytes() for name in names])
            self.assertEqual(found[0], found[1])
            with open(str(folder / 'scorecard.csv')) as file:
                lines = {(row['measure'], row['method'], row['group']): row for row in csv.DictReader(file)}
            self.assertEqual(lines['on_lane', 'search', 'RE']['value'], '1.0000')
            self.assertEqual(lines['on_lane', 'recorded', 'RE']['trials'], '0')
            self.assertEqual(lines['on_lane', 'recorded', 'all']['trials'], '400', 'slow ones are left out')
            self.assertEqual(lines['peak_steering_rate_quantile_50', 'search', 'all']['value'], '0.5000')
            self.assertFalse(('peak_steering_rate_quantile_50', 'recorded', 'all') in lines)
            self.assertAlmostEqual(float(lines['area', 'search', 'car']['value']), 0.5, delta=0.15)
            self.assertIn('search: 101 attacks, 100 windows of 3 s that count', (folder / 'scorecard.md').read_text())
            self.assertIn('Distances from recorded vehicles, search', (folder / 'scorecard.md').read_text())

    def test_an_interval_needs_five_scenes_and_contains_the_mean(self):
        values = np.tile([0.0, 1.0, 1.0], 40)
        scenes = np.array(['scene-{}'.format(index) for index in np.arange(120) % 12])
        statistics = scorecard.Statistics(1000, 0.95, 1)
        low, high = scorecard.interval_of(values, scenes, statistics)
        self.assertTrue(0.3 < low < 2.0 / 3.0 < high < 1.0)
        self.assertIsNone(scorecard.interval_of(values, np.full(120, 'one'), statistics))


if __name__ == '__main__':
    unittest.main()
