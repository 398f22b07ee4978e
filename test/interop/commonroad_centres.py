#!/usr/bin/python3
"""usage: commonroad_centres.py FOLDER: the lanelets' centrelines in the .xml of a folder, in commonroad-io.

Prints one JSON: {name of the file without its ending: {id of the lanelet: list of [x, y]}}.
"""
import json
import sys
from pathlib import Path

from commonroad.common.file_reader import CommonRoadFileReader


def centres(path):
    scenario, _ = CommonRoadFileReader(str(path)).open()
    return {str(lanelet.lanelet_id): lanelet.center_vertices.tolist()
            for lanelet in scenario.lanelet_network.lanelets}


if __name__ == '__main__':
    print(json.dumps({path.stem: centres(path) for path in sorted(Path(sys.argv[1]).glob('*.xml'))}))
