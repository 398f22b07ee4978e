"""Runs SUMO's command line tools and reads their output files."""
import math
import subprocess
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

from town import TownWriter
from traffic import PEDESTRIAN, RECORDED, WARM_UP

STEP = 0.1          # seconds


@dataclass
class RawTrack:
    """SUMO's data of one road user: front points, yaws and speeds on consecutive steps."""
    name: str
    kind: str
    first_step: int
    points: list = field(default_factory=list)
    yaws: list = field(default_factory=list)
    speeds: list = field(default_factory=list)

    def index_at(self, step):
        """Return the index of a step, or None if the road user is absent then."""
        index = step - self.first_step
        return index if 0 <= index < len(self.points) else None


def run_tool(command, folder):
    """Run a tool in a folder; raise RuntimeError with its output if it fails."""
    done = subprocess.run(command, cwd=folder, text=True, capture_output=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{command[0]} failed:\n{done.stdout}{done.stderr}")
    (folder / f"{command[0]}.log").write_text(done.stdout + done.stderr)


def tool_version(tool):
    """Return the first line of a tool's --version, e.g. 'Eclipse SUMO sumo Version 1.15.0'."""
    done = subprocess.run([tool, "--version"], text=True, capture_output=True, check=True)
    return done.stdout.splitlines()[0]


def build_network(town, folder):
    """Write the plain-XML sources of a town and convert them by netconvert; return the path."""
    writer = TownWriter(town)
    (folder / "town.nod.xml").write_text(writer.nodes_xml())
    (folder / "town.edg.xml").write_text(writer.edges_xml())
    (folder / "town.con.xml").write_text(writer.connections_xml())
    run_tool(["netconvert", "--node-files", "town.nod.xml", "--edge-files", "town.edg.xml",
              "--connection-files", "town.con.xml", "--output-file", "town.net.xml",
              "--lefthand", str(town.left_hand).lower(), "--no-turnarounds", "true",
              "--walkingareas", "true", "--offset.disable-normalization", "true",
              "--junctions.internal-link-detail", "20", "--junctions.limit-turn-speed", "2.5",
              "--tls.default-type", "static", "--tls.cycle.time", "50", "--precision", "4"], folder)
    return folder / "town.net.xml"


def simulate(town, folder):
    """Simulate the town's traffic; return the tracks of all road users by name."""
    run_tool(["sumo", "--net-file", "town.net.xml", "--route-files", "traffic.rou.xml",
              "--step-length", str(STEP), "--end", str(WARM_UP + RECORDED),
              "--seed", str(town.seed), "--lanechange.duration", "4",
              "--time-to-teleport", "-1", "--collision.action", "warn",
              "--collision.check-junctions", "true", "--default.speeddev", "0.08",
              "--fcd-output", "fcd.xml", "--device.fcd.begin", str(WARM_UP),
              "--precision", "4", "--no-step-log", "true"], folder)
    return read_tracks(folder / "fcd.xml")


def read_tracks(path):
    """Read SUMO's floating car data. Yaws are in radians, 0 along x (east)."""
    tracks = {}
    for _, step in ElementTree.iterparse(path):
        if step.tag != "timestep":
            continue
        number = round(float(step.get("time")) / STEP)
        for row in step:
            name = row.get("id")
            kind = PEDESTRIAN if row.tag == "person" else row.get("type")
            track = tracks.setdefault(name, RawTrack(name, kind, number))
            track.points.append((float(row.get("x")), float(row.get("y"))))
            track.yaws.append(math.radians(90.0 - float(row.get("angle"))))
            track.speeds.append(float(row.get("speed")))
        step.clear()
    return tracks
