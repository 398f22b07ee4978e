#!/usr/bin/python3
"""Writes the scorecard of forge study evaluate: compares attackers with the recorded vehicles of the same scenes.

Reads FOLDER/motion.csv; writes FOLDER/scorecard.md, scorecard.csv and scorecard.png. docs/protocols.md describes them."""
import argparse
from pathlib import Path
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from scipy.stats import bootstrap
from threadpoolctl import threadpool_limits

import charts
from distances import MIN_WINDOWS, QUANTITIES, SEED, distance_floors, distances_of, two_sample_test
from motion import (BANDS, BUCKETS, INNER, PEAK_COLUMNS, RECORDED, TYPES, Drives, Motion, motion_of, moves, read_drives,
                    states_of, with_recorded_noise)

MIN_GENERATED = 3  # generated samples in an attack's window; windows with fewer are left out
MIN_SCENES = 5  # needed for an interval
VEHICLES = ('all', 'car', 'truck', 'bus')
WHOLE = 1.0 - 1e-3  # shares have four decimals

# Name in scorecard.csv, title, True if the chart has a bar for it, function that returns the value of each drive.
SHARES = (
    ('wholly_on_lane', 'On a lane throughout', True, lambda road: road['on_lane'] >= WHOLE),
    ('on_lane', 'On a lane, mean share of the time', True, lambda road: road['on_lane']),
    ('wrong_way', 'Against its lane at some time', True, lambda road: road['wrong_way'] > 0.0),
    ('on_island', 'On an island at some time', True, lambda road: road['on_island'] > 0.0),
    ('on_walkway', 'On a walkway at some time', True, lambda road: road['on_walkway'] > 0.0),
    ('off_road', 'Off the drivable area, mean share of the box', True, lambda road: road['off_road']),
    ('wrong_way_share', 'Against its lane, mean share of the time', False, lambda road: road['wrong_way']),
    ('on_island_share', 'On an island, mean share of the time', False, lambda road: road['on_island']),
    ('on_walkway_share', 'On a walkway, mean share of the time', False, lambda road: road['on_walkway']))


class Statistics(NamedTuple):
    """Settings of the bootstrap for intervals; section `statistics` of evaluation.yaml."""
    resamples: int
    confidence: float
    seed: int


class Report:
    """Collects the contents of scorecard.md and scorecard.csv."""

    def __init__(self) -> None:
        self.markdown: List[str] = []
        self.rows = ['measure,method,group,trials,value,low,high']

    def add_table(self, title: str, columns: Sequence[str], rows: List[List[str]]) -> None:
        """Add a table below a title, unless it has no rows."""
        if rows:
            lines = [columns, ['---'] * len(columns)] + rows
            self.markdown += ['', title, ''] + ['|' + '|'.join(' {} '.format(cell) if cell != '---' else cell
                                                               for cell in line) + '|' for line in lines]

    def add_value(self, measure: str, method: str, group: str, trials: int, value: Optional[float],
                  interval: Optional[Tuple[float, float]] = None) -> None:
        """Add a row of scorecard.csv."""
        numbers = ['' if number is None else '{:.4f}'.format(number) for number in (value,) + (interval or (None, None))]
        self.rows.append(','.join([measure, method, group, str(trials)] + numbers))


def groups_of(driver: str, drives: Drives) -> Dict[str, np.ndarray]:
    """Return masks of the drives of each type, of each bucket of the TTA, and of all drives, by name.

    Recorded windows have no type and no TTA."""
    after, masks = 0.0, {}
    for name, short in TYPES.items():
        masks[short] = drives.type == name
    for bucket, last in BUCKETS:
        masks[bucket] = (drives.tta > after) & (drives.tta <= last)
        after = last
    masks['all'] = np.full(len(drives.scene), True)
    return masks if driver != RECORDED else {name: mask & (name == 'all') for name, mask in masks.items()}


def interval_of(values: np.ndarray, scenes: np.ndarray, statistics: Statistics) -> Optional[Tuple[float, float]]:
    """Return the bootstrap interval of the mean, with scenes as clusters; None below MIN_SCENES."""
    names, index = np.unique(scenes, return_inverse=True)
    if len(names) < MIN_SCENES:
        return None
    sums = (np.bincount(index, values), np.bincount(index))
    return tuple(bootstrap(sums, lambda value, count, axis: value.sum(axis) / count.sum(axis), paired=True,
                           n_resamples=statistics.resamples, confidence_level=statistics.confidence,
                           method='percentile', random_state=statistics.seed).confidence_interval)


def add_share(report: Report, name: str, title: str, shares: Dict[str, np.ndarray], drives: Dict[str, Drives],
              statistics: Statistics) -> None:
    """Add the mean of a share in each group."""
    rows, counts = [], []
    for driver, of_driver in drives.items():
        row, count = [driver], ['of, ' + driver]
        for group, mask in groups_of(driver, of_driver).items():
            values = shares[driver][mask].astype(float)
            mean = values.mean() if len(values) else None
            interval = interval_of(values, of_driver.scene[mask], statistics) if len(values) else None
            report.add_value(name, driver, group, len(values), mean, interval)
            row.append('-' if mean is None else '{:.1f}'.format(100.0 * mean) +
                       (' [{:.0f}, {:.0f}]'.format(*(100.0 * end for end in interval)) if interval else ''))
            count.append(str(len(values)))
        rows.append(row)
        counts.append(count)
    report.add_table(title + ', %', ['method'] + list(groups_of(driver, of_driver)), rows + counts)


def add_quantiles(report: Report, name: str, title: str, scale: float, shares: Sequence[float],
                  values: Dict[str, np.ndarray], drives: Dict[str, Drives]) -> None:
    """Add quantiles of a value in each group; the value is NaN for drives without it."""
    rows = []
    for driver, of_driver in drives.items():
        if np.isnan(values[driver]).all():
            continue
        rows.append([driver])
        for group, mask in groups_of(driver, of_driver).items():
            found = values[driver][mask & ~np.isnan(values[driver])]
            if len(found) < MIN_WINDOWS:
                rows[-1].append('-')
                continue
            quantiles = np.quantile(found, shares)
            rows[-1].append(' / '.join('{:.1f}'.format(scale * quantile) for quantile in quantiles))
            for share, quantile in zip(shares, quantiles):
                report.add_value('{}_quantile_{:g}'.format(name, 100.0 * share), driver, group, len(found), quantile)
    report.add_table(title + ': quantiles ' + ' / '.join('{:g} %'.format(100.0 * share) for share in shares),
                     ['method'] + list(groups_of(driver, of_driver)), rows)


def add_driving(report: Report, drives: Dict[str, Drives]) -> None:
    """Add smallest gaps, and the peaks of each drive as shares of the limits of its class."""
    add_quantiles(report, 'least_gap', 'Least gap to anybody but the ego until the contact, m (recorded: to anybody)', 1.0,
                  (0.05, 0.5), {driver: found.values['least_gap'] for driver, found in drives.items()}, drives)
    for peak in PEAK_COLUMNS:
        quantity = peak.replace('_', ' ')
        driven, fitted = {}, {}
        for driver, found in drives.items():
            limit = found.values['max_' + peak]
            driven[driver] = found.values[peak] / limit if driver != RECORDED else np.full(len(limit), np.nan)
            fitted[driver] = np.full(len(limit), np.nan)
            moving = moves(found)
            inner = states_of(found.windows[moving], found.length[moving])[quantity][:, INNER]
            fitted[driver][moving] = np.nan_to_num(np.abs(inner)).max(axis=1) / limit[moving]
        for name, title, values in (('peak_', 'until the contact', driven), ('fitted_', 'of the fit over 3 s', fitted)):
            add_quantiles(report, name + peak, 'Greatest {} {}, % of the class\'s limit'.format(quantity, title), 100.0,
                          (0.5, 0.9, 0.99, 1.0), values, drives)


def add_comparisons(report: Report, drives: Dict[str, Drives]) -> None:
    """Add the classifier tests of all methods by class and by type, then the distances of each method."""
    recorded = motion_of(drives[RECORDED])
    classifiers: List[List[str]] = []
    tables = []
    for method, found in drives.items():
        if method == RECORDED:
            continue
        windows = found.of(moves(found))
        counted = windows.of(windows.generated >= MIN_GENERATED)
        report.markdown += ['', '{}: {} attacks, {} windows of 3 s that count, {} with too few generated samples; {} '
                                'recorded windows'.format(method, len(found.scene), len(counted.scene),
                                                          len(windows.scene) - len(counted.scene), len(recorded.scene))]
        attacks = motion_of(counted)
        noisy = motion_of(with_recorded_noise(counted, drives[RECORDED], np.random.default_rng(SEED)))
        noisy = noisy._replace(band=attacks.band)
        of_class = [(name, in_group(attacks, name), in_group(recorded, name)) for name in VEHICLES]
        of_type = [(name, counted.type == name, in_group(recorded, 'all')) for name in TYPES]
        for group, chosen, others in of_class + of_type:
            classifiers += add_test(report, method, group, attacks.of(chosen), noisy.of(chosen), recorded.of(others))
        tables.append((method, [row for group, chosen, others in of_class for band in ('all',) + BANDS
                                for row in add_distances(report, method, group, band,
                                                         *(in_band(motion, band) for motion in (
                                                             attacks.of(chosen), noisy.of(chosen), recorded.of(others))))]))
    report.add_table('Area under the curve of a classifier, attacks against recorded vehicles (0.5: alike); larger of the '
                     'two, with the recordings\' noise, and the floor between recorded vehicles, mean (largest)',
                     ['method', 'attacks', 'unmatched', 'larger', 'logistic', 'forest', 'noisy', 'floor'], classifiers)
    for method, rows in tables:
        report.add_table('Distances from recorded vehicles, {}: as they are, with the recordings\' noise, and the floor '
                         'between recorded vehicles, mean (largest)'.format(method),
                         ['vehicles', 'quantity', 'attacks', 'Jensen-Shannon', 'noisy', 'floor', 'Wasserstein', 'noisy',
                          'floor'], rows)


def in_group(motion: Motion, group: str) -> np.ndarray:
    """Return a mask of the vehicles of a class group; `all` is every vehicle."""
    return (motion.group == group) | (group == 'all')


def in_band(motion: Motion, band: str) -> Motion:
    """Return the windows of a speed band; `all` is every window."""
    return motion.of((motion.band == band) | (band == 'all'))


def add_test(report: Report, method: str, group: str, attacks: Motion, noisy: Motion, recorded: Motion) -> List[List[str]]:
    """Return the row of a two-sample test in a list; an empty list for too few windows."""
    test = two_sample_test(attacks, noisy, recorded)
    if test is None:
        return []
    for name, value in (('area', test.areas.larger), ('area_logistic', test.areas.logistic),
                        ('area_forest', test.areas.forest), ('area_noisy', test.noisy.larger),
                        ('area_floor', test.floor.mean), ('area_floor_max', test.floor.most)):
        report.add_value(name, method, group, test.attacks, value)
    return [['{}, {}'.format(method, group), str(test.attacks), str(test.unmatched)] +
            ['{:.3f}'.format(value) for value in (test.areas.larger, *test.areas, test.noisy.larger)] +
            ['{:.3f} ({:.3f})'.format(*test.floor)]]


def add_distances(report: Report, method: str, group: str, band: str, attacks: Motion, noisy: Motion,
                  recorded: Motion) -> List[List[str]]:
    """Return a row of distances for each quantity; an empty list for too few windows."""
    if min(len(attacks.scene), len(recorded.scene)) < MIN_WINDOWS:
        return []
    rows = []
    floors = distance_floors(recorded, len(attacks.scene))
    vehicles = group + ('' if band == 'all' else ' at ' + band)
    for quantity, (unit, *_) in QUANTITIES.items():
        found = distances_of(attacks, recorded, quantity), distances_of(noisy, recorded, quantity)
        if None in found or not floors[quantity]:
            continue
        rows.append([vehicles, quantity, str(len(attacks.scene))])
        for measure, value, of_noisy, floor in zip(('jensen_shannon', 'wasserstein'), *found, floors[quantity]):
            for name, number in (('', value), ('_noisy', of_noisy), ('_floor', floor.mean), ('_floor_max', floor.most)):
                report.add_value(quantity + ' ' + measure + name, method, vehicles, len(attacks.scene), number)
            rows[-1] += ['{:.3f}'.format(value), '{:.3f}'.format(of_noisy), '{:.3f} ({:.3f})'.format(*floor)]
        rows[-1][-1] += ' ' + unit
    return rows


def write_scorecard(folder: Path, heading: str, title: str, statistics: Statistics) -> None:
    """Write scorecard.md, scorecard.csv and scorecard.png."""
    drives = read_drives(str(folder / 'motion.csv'))
    drives[RECORDED] = drives[RECORDED].of(moves(drives[RECORDED]))
    report = Report()
    for name, share_title, _, share in SHARES:
        shares = {driver: share(found.values) for driver, found in drives.items()}
        add_share(report, name, share_title, shares, drives, statistics)
    add_driving(report, drives)
    add_comparisons(report, drives)
    charts.write(folder / 'scorecard.md', '\n'.join([heading.strip()] + report.markdown + ['']).encode())
    charts.write(folder / 'scorecard.csv', '\n'.join(report.rows + ['']).encode())
    charted = [name for name, _, is_charted, _ in SHARES if is_charted]
    charts.draw_rates(folder / 'scorecard.png', 'Where attackers drive: ' + title,
                      [rate._replace(group=rate.measure.replace('_', ' '))
                       for rate in charts.read_rates(folder / 'scorecard.csv')
                       if rate.measure in charted and rate.group == 'all'])


def main() -> None:
    """Read the command line and write the scorecard."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('folder', type=Path, metavar='FOLDER')
    parser.add_argument('--heading', default='Scorecard', help='first line of scorecard.md')
    parser.add_argument('--title', default='', help='title of the chart')
    parser.add_argument('--resamples', type=int, default=1000, help='resamples of the bootstrap over scenes')
    parser.add_argument('--confidence', type=float, default=0.95, help='share of the resamples within an interval')
    parser.add_argument('--seed', type=int, default=1, help='seed of the bootstrap')
    arguments = parser.parse_args()
    with threadpool_limits(1):  # sums of several threads differ in their last bits
        write_scorecard(arguments.folder, arguments.heading, arguments.title,
                        Statistics(arguments.resamples, arguments.confidence, arguments.seed))


if __name__ == '__main__':
    charts.run(main)
