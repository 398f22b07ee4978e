#!/usr/bin/python3
"""Draws charts of the tables of forge: rates with intervals, confidence calibration, and training curves."""
import argparse
import csv
import io
import os
import sys
from pathlib import Path
from typing import Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

import matplotlib

matplotlib.use('Agg')  # needs no display
from matplotlib import pyplot  # noqa: E402  pylint: disable=wrong-import-position

SIZE = (12.0, 5.0)  # inches, 100 pixels each
SQUARE = (7.0, 7.0)
GROUP_SHARE = 0.8  # share of a group's width for its bars


class Rate(NamedTuple):
    """A share in [0, 1]."""
    measure: str
    method: str
    group: str
    value: float
    interval: Optional[Tuple[float, float]]


def read_rows(path: Path) -> List[Dict[str, str]]:
    """Return the rows of a CSV file with a header."""
    with open(str(path), newline='') as file:
        return list(csv.DictReader(file))


def read_rates(path: Path) -> List[Rate]:
    """Return the rows of a table.csv that have a value."""
    return [Rate(row['measure'], row['method'], row['group'], float(row['value']),
                 (float(row['low']), float(row['high'])) if row['low'] else None)
            for row in read_rows(path) if row['value']]


def whiskers(values: Sequence[float], intervals: Sequence[Optional[Tuple[float, float]]]) -> List[List[float]]:
    """Return the distances of the interval ends below and above the values, in percent; 0 without an interval."""
    ends = [interval or (value, value) for value, interval in zip(values, intervals)]
    return [[100.0 * (value - low) for value, (low, _) in zip(values, ends)],
            [100.0 * (high - value) for value, (_, high) in zip(values, ends)]]


def write(path: Path, content: bytes) -> None:
    """Write a file atomically."""
    part = path.with_name(path.name + '.part')
    part.write_bytes(content)
    os.replace(str(part), str(path))


def save(figure: 'pyplot.Figure', axes: 'pyplot.Axes', path: Path, title: str) -> None:
    """Write a finished chart. Long titles are wrapped."""
    axes.set_title(title, loc='left', wrap=True)
    axes.legend(loc='upper left', bbox_to_anchor=(0.0, -0.12), ncol=2, frameon=False)
    png = io.BytesIO()
    figure.savefig(png, format='png', dpi=100, bbox_inches='tight')
    pyplot.close(figure)
    write(path, png.getvalue())


def draw_rates(path: Path, title: str, rates: List[Rate]) -> None:
    """Draw bars in percent: one colour per method, side by side in each group."""
    figure, axes = pyplot.subplots(figsize=SIZE)
    methods = list(dict.fromkeys(rate.method for rate in rates))
    groups = list(dict.fromkeys(rate.group for rate in rates))
    width = GROUP_SHARE / max(len(methods), 1)
    for index, method in enumerate(methods):
        of_method = [rate for rate in rates if rate.method == method]
        places = [groups.index(rate.group) + (index - 0.5 * (len(methods) - 1)) * width for rate in of_method]
        values = [rate.value for rate in of_method]
        axes.bar(places, [100.0 * value for value in values], width, label=method, capsize=2.0, ecolor='0.3',
                 yerr=whiskers(values, [rate.interval for rate in of_method]))
    axes.set_xticks(range(len(groups)), groups)
    axes.set_ylim(0.0, 100.0)
    axes.set_ylabel('%')
    axes.grid(axis='y', alpha=0.4)
    axes.set_axisbelow(True)
    save(figure, axes, path, title)


def draw_calibration(path: Path, title: str, rows: List[Dict[str, str]]) -> None:
    """Draw the observed rate (kept) over the reported confidence (promised), with the ideal diagonal."""
    figure, axes = pyplot.subplots(figsize=SQUARE)
    axes.plot([0.0, 100.0], [0.0, 100.0], '--', color='0.6')
    for column in dict.fromkeys(row['column'] for row in rows):
        of_column = [row for row in rows if row['column'] == column]
        kept = [float(row['kept']) for row in of_column]
        intervals = [(float(row['low']), float(row['high'])) if row['low'] else None for row in of_column]
        axes.errorbar([100.0 * float(row['promised']) for row in of_column], [100.0 * value for value in kept],
                      whiskers(kept, intervals), marker='o', label=column.replace('_', ' '))
    axes.set(xlim=(0.0, 100.0), ylim=(0.0, 100.0), xlabel='promised, %', ylabel='kept, %', aspect='equal')
    axes.grid(alpha=0.4)
    save(figure, axes, path, title)


def draw_curves(path: Path, title: str, rows: List[Dict[str, str]], columns: Sequence[str]) -> None:
    """Draw columns of a metrics.csv over the epochs."""
    figure, axes = pyplot.subplots(figsize=SIZE)
    for column in columns:
        axes.plot([int(row['epoch']) for row in rows], [float(row[column]) for row in rows], marker='.',
                  label=column.replace('_', ' '))
    axes.set_xlabel('epoch')
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.grid(alpha=0.4)
    save(figure, axes, path, title)


def run(program: Callable[[], None]) -> None:
    """Run the program; for unreadable or unwritable files, exit with a message and exit code 1."""
    try:
        program()
    except (OSError, KeyError, ValueError) as error:
        sys.exit('{}: {}: {}'.format(Path(sys.argv[0]).name, type(error).__name__, error))


def main() -> None:
    """Read the command line, and write charts beside the named files."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--title', default='', help='title of the charts')
    parser.add_argument('--rates', type=Path, metavar='TABLE.csv', help='draws MEASURE.png for each measure')
    parser.add_argument('--measures', nargs='+', metavar='MEASURE', help='measures of --rates; default: all')
    parser.add_argument('--calibration', type=Path, metavar='CALIBRATION.csv', help='draws calibration.png')
    parser.add_argument('--curves', type=Path, metavar='METRICS.csv', help='draws curves.png')
    parser.add_argument('--columns', nargs='+', metavar='COLUMN', default=[], help='columns of --curves')
    arguments = parser.parse_args()
    if arguments.rates:
        rates = read_rates(arguments.rates)
        for measure in arguments.measures or dict.fromkeys(rate.measure for rate in rates):
            draw_rates(arguments.rates.parent / (measure + '.png'),
                       '{}: {}'.format(measure.replace('_', ' '), arguments.title),
                       [rate for rate in rates if rate.measure == measure])
    if arguments.calibration:
        draw_calibration(arguments.calibration.parent / 'calibration.png', 'Confidence: ' + arguments.title,
                         read_rows(arguments.calibration))
    if arguments.curves:
        draw_curves(arguments.curves.parent / 'curves.png', arguments.title, read_rows(arguments.curves),
                    arguments.columns)


if __name__ == '__main__':
    run(main)
