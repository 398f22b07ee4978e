"""Compares two samples of motion: distances of each quantity, and the accuracy of classifiers that separate them."""
from typing import Dict, List, NamedTuple, Optional, Set, Tuple

import numpy as np
from scipy.spatial.distance import jensenshannon
from scipy.stats import wasserstein_distance
from sklearn.ensemble import HistGradientBoostingClassifier
from sklearn.linear_model import LogisticRegression
from sklearn.metrics import roc_auc_score
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

from motion import INNER, Motion

MIN_WINDOWS = 30  # in each sample of a comparison; comparisons of smaller samples are left out
MATCHED = 3  # recorded windows for each attack in the two-sample test
DRAWS = 10  # random halves of the recorded scenes, for the floors
SEED = 1  # of all draws


class Quantity(NamedTuple):
    """A compared quantity. Values outside the histogram are counted in its first and last bin."""
    unit: str
    lowest: float
    highest: float
    bins: int
    step: float  # features of the classifier are rounded to multiples of this


# Bins of speed, acceleration, yaw rate and yaw acceleration as in the Waymo Open Sim Agents Challenge
# (waymo-research/waymo-open-dataset, wdl_limited/sim_agents_metrics, configuration of 2025). The challenge has none for
# the others, whose bins cover 99.9 % of recorded motion. A step is about the standard deviation that annotation noise
# causes at the middle sample.
QUANTITIES = {
    'speed': Quantity('m/s', 0.0, 25.0, 10, 0.25),
    'acceleration': Quantity('m/s2', -12.0, 12.0, 11, 0.3),
    'jerk': Quantity('m/s3', -10.0, 10.0, 20, 0.5),
    'yaw rate': Quantity('rad/s', -0.628, 0.628, 11, 0.02),
    'yaw acceleration': Quantity('rad/s2', -3.14, 3.14, 11, 0.05),
    'lateral acceleration': Quantity('m/s2', -4.0, 4.0, 20, 0.15),
    'steering angle': Quantity('rad', -0.6, 0.6, 20, 0.01),
    'steering rate': Quantity('rad/s', -0.4, 0.4, 20, 0.02),
}
ALONG = ('speed', 'acceleration', 'jerk')  # quantities whose sign is a feature of the classifier


class Floor(NamedTuple):
    """A measure between two samples of recorded motion, over the draws."""
    mean: float
    most: float


class Areas(NamedTuple):
    """Areas under the ROC curves of both classifiers; 0.5: the samples cannot be separated."""
    logistic: float
    forest: float

    @property
    def larger(self) -> float:
        return max(self.logistic, self.forest)


class TwoSampleTest(NamedTuple):
    """Result of a comparison of attacks with matching recorded windows."""
    areas: Areas
    noisy: Areas  # of attacks with the noise of recordings
    floor: Floor  # of Areas.larger
    attacks: int
    unmatched: int  # attacks skipped for lack of a matching window


def values_of(motion: Motion, quantity: str) -> np.ndarray:
    """Return the known values at the inner samples of all windows."""
    values = motion.states[quantity][:, INNER].ravel()
    return values[~np.isnan(values)]


def distances_of(first: Motion, second: Motion, quantity: str) -> Optional[Tuple[float, float]]:
    """Return the Jensen-Shannon divergence (bit) of the histograms and the Wasserstein-1 distance.

    The distance is in the unit of the quantity. Returns None if one sample has no values."""
    samples = [values_of(motion, quantity) for motion in (first, second)]
    if min(map(len, samples)) == 0:
        return None
    _, lowest, highest, bins, _ = QUANTITIES[quantity]
    counts = [np.histogram(np.clip(values, lowest, highest), bins, (lowest, highest))[0] for values in samples]
    return jensenshannon(*counts, base=2) ** 2, wasserstein_distance(*samples)


def scene_halves(rng: np.random.Generator, *samples: np.ndarray) -> np.ndarray:
    """Return a random half of the scenes: of each set of scenes with windows of the same samples, half (rounded up)."""
    scenes = rng.permutation(np.unique(np.concatenate(samples)))
    return scenes[np.lexsort([np.isin(scenes, sample) for sample in samples])][::2]


def recorded_halves(recorded: Motion, rng: np.random.Generator) -> Tuple[Motion, Motion]:
    """Return the windows of two random halves of the scenes."""
    first = np.isin(recorded.scene, scene_halves(rng, recorded.scene))
    return recorded.of(first), recorded.of(~first)


def distance_floors(recorded: Motion, windows: int) -> Dict[str, List[Floor]]:
    """Return the distances of each quantity between two random halves of the recorded scenes.

    The first half is reduced to `windows` windows, because small samples differ more by chance."""
    rng = np.random.default_rng(SEED)
    draws: Dict[str, List[Tuple[float, float]]] = {quantity: [] for quantity in QUANTITIES}
    for _ in range(DRAWS):
        first, second = recorded_halves(recorded, rng)
        first = first.of(rng.permutation(len(first.scene))[:windows])
        for quantity, found in draws.items():
            distances = distances_of(first, second, quantity)
            if distances:
                found.append(distances)
    return {quantity: [Floor(np.mean(values), max(values)) for values in zip(*found)]
            for quantity, found in draws.items()}


def features_of(motion: Motion) -> np.ndarray:
    """Return the features of the classifier, a row per window: means and extremes of its motion.

    The features contain no position, time, class, size or residual of the fit, and do not distinguish left from right.
    Unknown steering is 0. Values are rounded, because annotators repeat a yaw exactly, which does not
    happen in computed motion."""
    def rounded(quantity: str, values: List[np.ndarray]) -> List[np.ndarray]:
        return [QUANTITIES[quantity].step * np.round(value / QUANTITIES[quantity].step) for value in values]

    speed = motion.states['speed']
    features = rounded('speed', [speed[:, 0], speed[:, -1]])
    for quantity in QUANTITIES:
        inner = np.nan_to_num(motion.states[quantity][:, INNER])
        mean, least, most, largest = inner.mean(axis=1), inner.min(axis=1), inner.max(axis=1), np.abs(inner).max(axis=1)
        features += rounded(quantity, [mean, least, most, largest] if quantity in ALONG else
                            [np.abs(mean), largest, most - least])
    return np.column_stack(features)


def areas_of(first: Motion, second: Motion, seed: int) -> Optional[Areas]:
    """Return the areas under the ROC curves of a logistic regression and of boosted trees of depth two.

    This is the classifier two-sample test (Lopez-Paz and Oquab, "Revisiting Classifier Two-Sample Tests", ICLR 2017).
    Each classifier is trained on one half of the scenes and tested on the other, in both directions. Pairs are counted
    within a half, because the scores of two classifiers have no common zero. Returns None if a half lacks a sample."""
    features = np.concatenate([features_of(first), features_of(second)])
    labels = np.repeat([1, 0], [len(first.scene), len(second.scene)])
    half = np.isin(np.concatenate([first.scene, second.scene]),
                   scene_halves(np.random.default_rng(seed), first.scene, second.scene))
    if any(len(np.unique(labels[part])) < 2 for part in (half, ~half)):
        return None
    models = (make_pipeline(StandardScaler(), LogisticRegression(solver='newton-cholesky')),
              HistGradientBoostingClassifier(max_iter=100, max_depth=2, min_samples_leaf=10, l2_regularization=1.0,
                                             early_stopping=False))
    pairs = [labels[part].sum() * (1 - labels[part]).sum() for part in (half, ~half)]
    return Areas(*(np.average([roc_auc_score(labels[part], model.fit(features[~part], labels[~part])
                                             .decision_function(features[part])) for part in (half, ~half)],
                              weights=pairs) for model in models))


class RecordedPool:
    """Recorded windows in random order, by class group and speed band; each can be taken once."""

    def __init__(self, recorded: Motion, rng: np.random.Generator) -> None:
        self.left: Dict[Tuple[str, ...], List[int]] = {}
        self.taken: Set[int] = set()
        for index in rng.permutation(len(recorded.scene)):
            kind = (recorded.group[index], recorded.band[index])
            for key in (kind, kind + (recorded.scene[index],)):
                self.left.setdefault(key, []).append(index)

    def take(self, key: Tuple[str, ...]) -> Optional[int]:
        """Return the index of the next window of a class group, a speed band and optionally a scene, else None."""
        left = self.left.get(key, [])
        while left:
            index = left.pop()
            if index not in self.taken:
                self.taken.add(index)
                return index
        return None


def match(attacks: Motion, recorded: Motion, rng: np.random.Generator) -> Tuple[Motion, Motion]:
    """Return the attacks that have a match, and the matches.

    The matches are up to MATCHED recorded windows for each attack, with its class group and speed band, first from its
    own scene, then from any scene."""
    pool = RecordedPool(recorded, rng)
    found = np.zeros(len(attacks.scene), int)
    matches: List[int] = []
    kinds = list(zip(attacks.group, attacks.band))
    for keys in ([kind + (scene,) for kind, scene in zip(kinds, attacks.scene)], kinds):
        for count in range(MATCHED):
            for attack in np.flatnonzero(found <= count):
                index = pool.take(keys[attack])
                if index is not None:
                    matches.append(index)
                    found[attack] += 1
    return attacks.of(found > 0), recorded.of(np.array(matches, int))


def draw_like(attacks: Motion, recorded: Motion, rng: np.random.Generator) -> Motion:
    """Return one recorded window of the same class group and speed band for each attack, as long as some are left."""
    pool = RecordedPool(recorded, rng)
    drawn = [pool.take(kind) for kind in zip(attacks.group, attacks.band)]
    return recorded.of(np.array([index for index in drawn if index is not None], int))


def areas_of_matched(attacks: Motion, recorded: Motion, seed: int) -> Optional[Areas]:
    """Return areas_of(), or None if a sample has fewer than MIN_WINDOWS windows."""
    return areas_of(attacks, recorded, seed) if min(len(attacks.scene), len(recorded.scene)) >= MIN_WINDOWS else None


def two_sample_test(attacks: Motion, noisy: Motion, recorded: Motion) -> Optional[TwoSampleTest]:
    """Test whether a classifier separates attacks from recorded windows of the same class and speed.

    `noisy` are the same attacks with the noise of recordings. For the floor, recorded windows replace the attacks and
    are compared with windows of other scenes. Returns None for too few windows."""
    areas = []
    for sample in (attacks, noisy):  # with the same random matches and halves
        rng = np.random.default_rng(SEED)
        matched, matches = match(sample, recorded, rng)
        areas.append(areas_of_matched(matched, matches, SEED))
    matched, _ = match(attacks, recorded, np.random.default_rng(SEED))
    if None in areas:
        return None
    floors = []
    for seed in range(SEED, SEED + DRAWS):
        first, second = recorded_halves(recorded, rng)
        drawn = areas_of_matched(*match(draw_like(matched, first, rng), second, rng), seed)
        if drawn:
            floors.append(drawn.larger)
    if not floors:
        return None
    return TwoSampleTest(*areas, Floor(np.mean(floors), max(floors)), len(matched.scene),
                         len(attacks.scene) - len(matched.scene))
