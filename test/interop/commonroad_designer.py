#!/usr/bin/python3
"""usage: commonroad_designer.py FOLDER: lanelets that CommonRoad's scenario designer makes of the .xodr of a folder.

Runs in an environment with commonroad-scenario-designer. Prints one JSON a file: {"file": name, "centres": list of
centrelines, each a list of [x, y] in the frame of the file}. Lanelets without
vehicles are left out. The designer projects maps onto another ellipsoid and
subtracts the header's offset; the first is switched off, the second undone.
"""
import json
import logging
import sys
import warnings
from pathlib import Path

from crdesigner.common.config.opendrive_config import open_drive_config
from crdesigner.map_conversion.map_conversion_interface import opendrive_to_commonroad
from commonroad.scenario.lanelet import LaneletType
from lxml import etree

WALKED = {LaneletType.CROSSWALK, LaneletType.SIDEWALK, LaneletType.BORDER, LaneletType.UNKNOWN}

if __name__ == '__main__':
    logging.disable(logging.CRITICAL)
    warnings.simplefilter('ignore')
    open_drive_config.proj_string_odr = None
    for path in sorted(Path(sys.argv[1]).glob('*.xodr')):
        offset = etree.parse(str(path)).find('header/offset')
        shift = [float(offset.get(axis)) for axis in 'xy']
        lanelets = opendrive_to_commonroad(path, odr_conf=open_drive_config).lanelet_network.lanelets
        centres = [(lanelet.center_vertices + shift).tolist() for lanelet in lanelets
                   if not lanelet.lanelet_type & WALKED]
        print(json.dumps({'file': path.name, 'centres': centres}), flush=True)
