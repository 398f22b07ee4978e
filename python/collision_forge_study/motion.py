"""Reads vehicle motion in windows of 3 s from a file of forge study evaluate, and derives speed, acceleration etc."""
import csv
from collections import defaultdict
from typing import Dict, List, NamedTuple

import numpy as np

RECORDED = 'recorded'  # the driver of recorded windows
SAMPLES = 7  # per window, about 0.5 s apart
MIDDLE = SAMPLES // 2
# The middle sample and its neighbours. The derivatives of a least-squares cubic are noisy further out: with position
# noise of s m, the standard deviation of the second derivative is 0.9 s m/s2 at the middle, 1.8 s beside it, and 3.4 s
# and 5 s at the last two samples.
INNER = slice(MIDDLE - 1, MIDDLE + 2)
MIN_SPEED = 1.0  # m/s at every sample; annotations of slower vehicles are mostly noise
MIN_STEERING_SPEED = 2.0  # m/s; below it, no steering angle is derived from the yaw rate
# Wheelbase over length: Ford Escort .56, BMW 320i .57 (CommonRoad vehicle models 2020a), Renault Zoe .63.
WHEELBASE_SHARE = 0.58

ROAD_COLUMNS = ('on_lane', 'wrong_way', 'off_road', 'on_walkway', 'on_island')
PEAK_COLUMNS = ('steering_rate', 'jerk', 'lateral_acceleration')
BUCKETS = (('0.5-1 s', 1.25), ('1.5-2.5 s', 2.75), ('3-4.5 s', 4.75), ('5-6.5 s', 7.0))  # of the TTA; ends in s
TYPES = {'lane_change': 'LC', 'opposite_direction': 'OD', 'rear_end': 'RE', 'junction_crossing': 'JC', 'ltap': 'LTAP'}
CLASS_GROUPS = {'car': 'car', 'emergency_vehicle': 'car', 'truck': 'truck', 'construction_vehicle': 'truck', 'bus': 'bus'}
BANDS = ('2-5 m/s', '5-10 m/s', '10+ m/s')
BAND_STARTS = (2.0, 5.0, 10.0)  # m/s at the middle sample


class Drives(NamedTuple):
    """Attacks or recorded windows; every array has one row per drive."""
    scene: np.ndarray
    type: np.ndarray  # collision type; empty for recorded windows
    tta: np.ndarray  # s
    group: np.ndarray  # of vehicle classes, as in CLASS_GROUPS
    length: np.ndarray  # m
    values: Dict[str, np.ndarray]  # columns of the file by name; NaN where a cell is empty
    generated: np.ndarray  # samples of the window that the method generated; 0 without a window
    windows: np.ndarray  # (drives, SAMPLES, 4): time (s), x, y (m), yaw (rad, unwrapped); NaN without a window

    def of(self, chosen: np.ndarray) -> 'Drives':
        """Return the drives at these indices, or where a mask is true."""
        return Drives(*(field[chosen] if isinstance(field, np.ndarray) else
                        {name: column[chosen] for name, column in field.items()} for field in self))


class Motion(NamedTuple):
    """Motion derived from windows; the arrays of `states` are (windows, SAMPLES)."""
    scene: np.ndarray
    group: np.ndarray
    band: np.ndarray  # speed band; empty below the first one
    states: Dict[str, np.ndarray]  # by quantity; NaN where a vehicle is too slow for a steering angle

    def of(self, chosen: np.ndarray) -> 'Motion':
        """Return the windows at these indices, or where a mask is true."""
        return Motion(self.scene[chosen], self.group[chosen], self.band[chosen],
                      {name: values[chosen] for name, values in self.states.items()})


def read_drives(path: str) -> Dict[str, Drives]:
    """Return the drives of each driver in the order of the file; the driver RECORDED is always included."""
    rows: Dict[str, List[Dict[str, str]]] = defaultdict(list)
    with open(path, newline='') as file:
        for row in csv.DictReader(file):
            rows[row['driver']].append(row)
    rows[RECORDED] = rows.pop(RECORDED, [])
    return {driver: drives_of(of_driver) for driver, of_driver in rows.items()}


def drives_of(rows: List[Dict[str, str]]) -> Drives:
    """Return the rows of one driver as arrays."""
    def texts(name: str) -> np.ndarray:
        return np.array([row[name] for row in rows], dtype=str)

    def numbers(name: str) -> np.ndarray:
        return np.array([row[name] or 'nan' for row in rows], dtype=float)

    numeric = ROAD_COLUMNS + PEAK_COLUMNS + tuple('max_' + name for name in PEAK_COLUMNS) + ('least_gap',)
    samples = np.full((len(rows), 1 + 4 * SAMPLES), np.nan)
    samples[:, 0] = 0.0
    for sample, row in zip(samples, rows):
        if row['window']:
            sample[:] = np.fromstring(row['window'], sep=' ')
    windows = samples[:, 1:].reshape(-1, SAMPLES, 4)
    windows[:, :, 3] = np.unwrap(windows[:, :, 3], axis=1)
    group = np.array([CLASS_GROUPS.get(row['class'], '') for row in rows], dtype=str)
    return Drives(texts('scene'), texts('type'), numbers('tta'), group, numbers('length'),
                  {name: numbers(name) for name in numeric}, samples[:, 0].astype(int), windows)


def fit(windows: np.ndarray) -> np.ndarray:
    """Fit least-squares cubics to x, y and yaw of each window.

    Return first, second and third derivatives and the residuals: (4, windows, SAMPLES, 3), last axis x, y, yaw."""
    times = windows[:, :, 0] - windows[:, MIDDLE, None, 0]
    powers = times[:, :, None] ** np.arange(4)
    positions = windows[:, :, 1:] - windows[:, MIDDLE, None, 1:]
    coefficients = np.linalg.pinv(powers) @ positions
    _, first, second, third = np.moveaxis(coefficients, 1, 0)[:, :, None, :]
    time = times[:, :, None]
    return np.stack([first + 2.0 * time * second + 3.0 * time ** 2 * third, 2.0 * second + 6.0 * time * third,
                     np.broadcast_to(6.0 * third, positions.shape), positions - powers @ coefficients])


def states_of(windows: np.ndarray, length: np.ndarray) -> Dict[str, np.ndarray]:
    """Return the quantities at each sample by name, from windows and vehicle lengths (m).

    Steering follows the kinematic single-track model (CommonRoad vehicle models 2020a, section 3): angle =
    atan(wheelbase * yaw rate / speed)."""
    first, second, third, _ = fit(windows)
    speed = np.hypot(first[:, :, 0], first[:, :, 1])
    with np.errstate(divide='ignore', invalid='ignore'):
        ahead = np.nan_to_num(first[:, :, :2] / speed[:, :, None])
        acceleration = (second[:, :, :2] * ahead).sum(axis=2)
        yaw_rate, yaw_acceleration = first[:, :, 2], second[:, :, 2]
        curvature = yaw_rate / speed
        slope = WHEELBASE_SHARE * length[:, None] * curvature
        change = WHEELBASE_SHARE * length[:, None] * (yaw_acceleration - curvature * acceleration) / speed
        steers = speed >= MIN_STEERING_SPEED
        return {'speed': speed, 'acceleration': acceleration, 'jerk': (third[:, :, :2] * ahead).sum(axis=2),
                'yaw rate': yaw_rate, 'yaw acceleration': yaw_acceleration, 'lateral acceleration': speed * yaw_rate,
                'steering angle': np.where(steers, np.arctan(slope), np.nan),
                'steering rate': np.where(steers, change / (1.0 + slope ** 2), np.nan)}


def motion_of(drives: Drives) -> Motion:
    """Return the motion in the windows; every drive must have a window."""
    states = states_of(drives.windows, drives.length)
    band = np.array(('',) + BANDS)[np.digitize(states['speed'][:, MIDDLE], BAND_STARTS)]
    return Motion(drives.scene, drives.group, band, states)


def moves(drives: Drives) -> np.ndarray:
    """Return a mask of the drives that have a window with at least MIN_SPEED at every sample."""
    found = ~np.isnan(drives.windows[:, 0, 0])
    found[found] = (states_of(drives.windows[found], drives.length[found])['speed'] >= MIN_SPEED).all(axis=1)
    return found


def with_recorded_noise(drives: Drives, recorded: Drives, rng: np.random.Generator) -> Drives:
    """Return the attacks with the noise of annotations.

    Adds the fit residuals of a random recorded window, in random order, to the positions of the generated samples, in
    vehicle axes. In their original order, the fit would remove the residuals again. The residuals are scaled by
    sqrt(7 / 3), because the fit of a cubic to seven samples removes four sevenths of the variance. Yaws are unchanged,
    because annotated yaws are smooth."""
    if len(recorded.scene) == 0:
        return drives
    residuals = fit(recorded.windows)[3][:, :, :2] * np.sqrt(7.0 / 3.0)
    residuals = in_axes(residuals, -recorded.windows[:, MIDDLE, None, 3])
    drawn = residuals[rng.integers(len(residuals), size=len(drives.scene))]
    drawn = np.take_along_axis(drawn, rng.random(drawn.shape[:2]).argsort(axis=1)[:, :, None], axis=1)
    windows = drives.windows.copy()
    moved = in_axes(drawn, windows[:, :, 3])
    generated = np.arange(SAMPLES) >= SAMPLES - drives.generated[:, None]
    windows[:, :, 1:3] += np.where(generated[:, :, None], moved, 0.0)
    return drives._replace(windows=windows)


def in_axes(vectors: np.ndarray, yaw: np.ndarray) -> np.ndarray:
    """Return the vectors (windows, SAMPLES, 2), rotated by the yaws."""
    cos, sin = np.cos(yaw), np.sin(yaw)
    return np.stack([cos * vectors[:, :, 0] - sin * vectors[:, :, 1], sin * vectors[:, :, 0] + cos * vectors[:, :, 1]],
                    axis=2)
