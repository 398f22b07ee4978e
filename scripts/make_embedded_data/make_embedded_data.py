#!/usr/bin/python3
"""Generates the embedded driving data with SUMO, byte for byte the same on every run.

Two small towns, one per driving side, are built with netconvert and driven with
sumo. For each scene, the 20 s of an ego candidate with the most traffic are written in
the nuScenes schema, with a map expansion and a map mask for each town. Needs SUMO's
command line tools.
"""
import argparse
import json
import os
import random
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True

from check import check
from map_export import bay_poses, map_dictionary
from map_mask import mask_png
from picker import pick
from road_network import read_network
from scenes import SCENES, ego_routes
from simulation import build_network, simulate, tool_version
from tables import all_tables
from town import TOWNS
from traffic import PARKED, traffic_xml

DEFAULT_OUT = Path(__file__).resolve().parents[2] / "data" / "embedded"
VERSION = "v1.0-embedded"
PARKED_SHARE = 0.6
PARKED_KINDS = ("car_small", "car_compact", "car_estate", "car_saloon", "car_suv")


def parked_cars(town, network):
    """Return (name, kind, pose of the centre) of the cars in the parking bays."""
    rng = random.Random(town.seed)
    cars = []
    for edge, number, (x, y, yaw) in bay_poses(network, town.left_hand):
        taken = rng.random() < PARKED_SHARE
        kind = rng.choice(PARKED_KINDS)
        pose = (x + rng.uniform(-0.1, 0.1), y + rng.uniform(-0.05, 0.05),
                yaw + rng.uniform(-0.02, 0.02))
        if taken:
            cars.append((f"{PARKED} {edge} {number}", kind, pose))
    return cars


def drive_town(town, folder):
    """Simulate one town; return its map and the recordings of its scenes."""
    network = read_network(build_network(town, folder))
    (folder / "traffic.rou.xml").write_text(traffic_xml(town, ego_routes(town.location)))
    tracks = simulate(town, folder)
    parked = parked_cars(town, network)
    taken = set()
    recordings = [pick(spec, tracks, parked, town.left_hand, taken)
                  for spec in SCENES if spec.location == town.location]
    return map_dictionary(network, town), recordings


def write_bytes(path, content):
    """Write a file atomically."""
    path.parent.mkdir(parents=True, exist_ok=True)
    aside = path.with_name(path.name + ".part")
    aside.write_bytes(content)
    os.replace(aside, path)


def write_text(path, text):
    write_bytes(path, text.encode())


def compact(value):
    return json.dumps(value, separators=(",", ":"))


def table_text(rows):
    """Return the text of a table, one row per line."""
    return "[\n" + ",\n".join(compact(row) for row in rows) + "\n]\n"


def map_text(content):
    """Return the text of a map file, one row or one entry of a dictionary per line."""
    parts = []
    for key, value in content.items():
        if isinstance(value, dict):
            entries = [f"{compact(name)}:{compact(entry)}" for name, entry in value.items()]
            parts.append(f"{compact(key)}:{{\n" + ",\n".join(entries) + "\n}")
        elif value and isinstance(value[0], dict):
            parts.append(f"{compact(key)}:{table_text(value).rstrip()}")
        else:
            parts.append(f"{compact(key)}:{compact(value)}")
    return "{\n" + ",\n".join(parts) + "\n}\n"


def make(out):
    """Generate all data in a folder."""
    recordings = []
    for town in TOWNS:
        with tempfile.TemporaryDirectory() as folder:
            roads, driven = drive_town(town, Path(folder))
        recordings += driven
        write_text(out / "maps" / "expansion" / f"{town.location}.json", map_text(roads))
        write_bytes(out / "maps" / f"{town.location}.png", mask_png(roads))
    for name, rows in all_tables(recordings).items():
        write_text(out / VERSION / f"{name}.json", table_text(rows))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--out", type=Path, default=DEFAULT_OUT,
                        help="folder to write to (default: the repository's data/embedded)")
    parser.add_argument("--check", action="store_true",
                        help="generate nothing; check the existing data and print a table of the scenes")
    options = parser.parse_args()
    if not options.check:
        print(f"made with {tool_version('sumo')}")
        make(options.out)
    return check(options.out, VERSION)


if __name__ == "__main__":
    sys.exit(main())
