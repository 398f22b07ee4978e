"""Reads the roads from SUMO's network file."""
import math
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

from plane import without_repeats

SHORTEST_WAY = 0.2   # metres; lanes with a smaller gap are connected directly


@dataclass
class Lane:
    """A lane of a road, or the path of one connection through a junction."""
    name: str
    edge: str
    index: int
    width: float
    shape: list
    is_car: bool
    is_walk: bool
    incoming: list = field(default_factory=list)
    outgoing: list = field(default_factory=list)
    in_junction: bool = False


@dataclass
class Edge:
    """One direction of a road between two junctions."""
    name: str
    start: str
    end: str
    lanes: list


@dataclass
class Connection:
    """A path through a junction, from lane to lane."""
    start: Lane
    end: Lane
    way: Lane
    state: str


@dataclass
class Network:
    """Lanes by name, edges by name, junction kinds and connections of lanes."""
    lanes: dict
    edges: dict
    junctions: dict
    connections: list
    crossings: dict


def read_points(text):
    return without_repeats([tuple(float(v) for v in point.split(",")[:2])
                            for point in text.split()])


def read_lane(row, edge_name):
    allowed = row.get("allow", "").split()
    return Lane(row.get("id"), edge_name, int(row.get("index")), float(row.get("width")),
                read_points(row.get("shape")),
                is_car=not allowed or "passenger" in allowed,
                is_walk=allowed == ["pedestrian"])


def joined_shape(parts):
    """Return the joined shape of successive lanes."""
    points = list(parts[0].shape)
    for part in parts[1:]:
        points += part.shape[1:]
    return without_repeats(points)


def read_connections(root, lanes, internal):
    """Return the connections; joins paths that SUMO splits at a waiting point."""
    rows = root.findall("connection")
    follows = {f'{row.get("from")}_{row.get("fromLane")}': row.get("via")
               for row in rows if row.get("from").startswith(":")}
    connections = []
    for row in rows:
        start = lanes.get(f'{row.get("from")}_{row.get("fromLane")}')
        end = lanes.get(f'{row.get("to")}_{row.get("toLane")}')
        if start is None or end is None or start.is_walk or end.is_walk:
            continue
        if math.dist(start.shape[-1], end.shape[0]) < SHORTEST_WAY:
            start.outgoing.append(end.name)
            end.incoming.append(start.name)
            end.shape[0] = start.shape[-1]
            continue
        parts = [internal[row.get("via")]]
        while follows.get(parts[-1].name):
            parts.append(internal[follows[parts[-1].name]])
        way = Lane(parts[0].name, parts[0].edge, 0, min(start.width, end.width),
                   joined_shape(parts), is_car=start.is_car and end.is_car, is_walk=False,
                   incoming=[start.name], outgoing=[end.name], in_junction=True)
        start.outgoing.append(way.name)
        end.incoming.append(way.name)
        connections.append(Connection(start, end, way, row.get("state")))
    return connections


def read_network(path):
    root = ElementTree.parse(path).getroot()
    edges, lanes, internal, crossings = {}, {}, {}, {}
    for row in root.findall("edge"):
        found = [read_lane(lane, row.get("id")) for lane in row.findall("lane")]
        function = row.get("function")
        if function == "internal":
            internal.update((lane.name, lane) for lane in found)
        elif function == "crossing":
            crossings[row.get("id")] = (found[0], row.get("crossingEdges").split())
        elif function is None:
            edges[row.get("id")] = Edge(row.get("id"), row.get("from"), row.get("to"), found)
            lanes.update((lane.name, lane) for lane in found)
    junctions = {row.get("id"): row.get("type") for row in root.findall("junction")
                 if row.get("type") != "internal"}
    connections = read_connections(root, lanes, internal)
    return Network(lanes, edges, junctions, connections, crossings)
