#!/usr/bin/python3
"""usage: esmini_picture.py NAME.xosc OUT.png: draws esmini's play of a file, from its log over the lanes of NAME.xodr.

Needs esmini in PATH or ESMINI, and matplotlib. Boxes of ego and attacker are drawn every second up to their first contact (without one, to the end); the
boxes of all entities at that time are filled.
"""
import math
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

import matplotlib
from esmini_player import Play, player
from sumo_roads import middle_lines

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402

COLORS = {'ego': 'tab:blue', 'attacker': 'tab:red'}
EVERY = 50  # rows of the log between drawn boxes
AROUND = 25.0  # m around the ego and the attacker


def sizes_of(path):
    """Length, width and distance from the origin to the middle of each entity, m."""
    sizes = {}
    for entity in ElementTree.parse(path).getroot().iter('ScenarioObject'):
        size, middle = next(entity.iter('Dimensions')), next(entity.iter('Center'))
        sizes[entity.get('name')] = [float(size.get('length')), float(size.get('width')), float(middle.get('x'))]
    return sizes


def box(axes, place, size, color, is_last):
    x, y, heading = place
    length, width, ahead = size
    corner = (x + (ahead - length / 2) * math.cos(heading) + width / 2 * math.sin(heading),
              y + (ahead - length / 2) * math.sin(heading) - width / 2 * math.cos(heading))
    axes.add_patch(plt.Rectangle(corner, length, width, angle=math.degrees(heading), edgecolor=color, linewidth=0.8,
                                 facecolor=color if is_last else 'none', alpha=0.9 if is_last else 0.6))


def main(scenario, picture):
    path = Path(scenario)
    with tempfile.TemporaryDirectory() as folder:
        play = Play(player(), path, Path(folder))
    figure, axes = plt.subplots(figsize=(7.2, 4.2))
    root = ElementTree.parse(path.with_suffix('.xodr')).getroot()
    left, low = (float(root.find('header/offset').get(axis)) for axis in 'xy')  # esmini adds them
    for road in root.iter('road'):
        for line in middle_lines(road):
            axes.plot([x + left for x, _ in line], [y + low for _, y in line], color='0.75', linewidth=0.8, zorder=0)
    sizes = sizes_of(path)
    contact = play.contact()
    shown = {name: [state for state in states if contact is None or state[0] <= contact]
             for name, states in play.places.items()}
    end = max(states[-1][0] for states in shown.values() if states)
    for name, states in shown.items():
        if not states or (name not in COLORS and states[-1][0] < end):  # appears later, or has disappeared
            continue
        color = COLORS.get(name, '0.45')
        drawn = [*states[::EVERY], states[-1]] if name in COLORS else states[-1:]
        for state in drawn:
            box(axes, state[1:], sizes[name], color, state is drawn[-1])
    ends = [state for name in COLORS for state in shown[name]]
    axes.set_xlim(min(s[1] for s in ends) - AROUND, max(s[1] for s in ends) + AROUND)
    axes.set_ylim(min(s[2] for s in ends) - AROUND / 2, max(s[2] for s in ends) + AROUND / 2)
    axes.set_aspect('equal')
    axes.set_xlabel('x, m')
    axes.set_ylabel('y, m')
    figure.tight_layout()
    figure.savefig(picture, dpi=100, bbox_inches='tight')


if __name__ == '__main__':
    main(*sys.argv[1:])
