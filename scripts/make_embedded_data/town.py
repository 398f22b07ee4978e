"""The road network: one small town, described as SUMO plain-XML sources.

The right-hand town is written out below. The left-hand town is its mirror
image (x -> MIRROR_SUM - x) with fewer lanes on its arterial road.

              RN          N            C
              |           |            |
        RW --(R)----------U----------T-'     R roundabout, U unsignalised
              |           |          |       junction, T T-junction
              RS          |          TS
                          |
        W ================S================ E    S signalised junction
                          |
                          D
"""
import math
from dataclasses import dataclass
from xml.sax.saxutils import quoteattr

MIRROR_SUM = 1300.0
LANE_WIDTH = 3.5
BIKE_LANE_WIDTH = 1.6
SIDEWALK_WIDTH = 2.0

RING_CENTRE = (400.0, 850.0)
RING_RADIUS = 20.0
RING_HALF_ANGLE = math.radians(25.0)   # from an arm's axis to its entry and exit
RING_ENTRY_TURN = math.radians(35.0)   # turn of an entry before it meets the ring
ARM_SPLIT_DISTANCE = 60.0              # metres from the centre of the ring to the split of an arm
CURVE_RADIUS = 45.0
STREET_CORNER_RADIUS = 9.0
RING_CORNER_RADIUS = 1.5

NODES = {
    "W": (300.0, 600.0, "dead_end"), "S": (650.0, 600.0, "traffic_light"),
    "E": (1000.0, 600.0, "dead_end"), "D": (650.0, 340.0, "dead_end"),
    "U": (650.0, 850.0, "priority"), "N": (650.0, 1100.0, "dead_end"),
    "T": (880.0, 850.0, "priority"), "TS": (880.0, 680.0, "dead_end"),
    "C": (1020.0, 1100.0, "dead_end"),
    "RW": (180.0, 850.0, "dead_end"), "RN": (400.0, 1080.0, "dead_end"),
    "RS": (400.0, 670.0, "dead_end"),
}
ARMS = {"e": (0.0, "U"), "n": (90.0, "RN"), "w": (180.0, "RW"), "s": (270.0, "RS")}


@dataclass(frozen=True)
class Street:
    """A two-way road between two nodes."""
    start: str
    end: str
    lanes: int
    speed: float
    priority: int
    sidewalk: bool = False
    bike_lane: bool = False
    curve: tuple = ()


@dataclass(frozen=True)
class OneWay:
    """A one-lane one-way road along a given line."""
    name: str
    start: str
    end: str
    speed: float
    priority: int
    line: tuple


@dataclass(frozen=True)
class Town:
    """A driving side and the number of lanes each way on the arterial road."""
    location: str
    left_hand: bool
    arterial_lanes: int
    seed: int


TOWNS = (
    Town("embedded-right", left_hand=False, arterial_lanes=3, seed=11),
    Town("embedded-left", left_hand=True, arterial_lanes=2, seed=23),
)


def arc_points(centre, radius, start_deg, end_deg, count):
    """Return points on a circle from one angle to another, both ends included."""
    angles = [math.radians(start_deg + (end_deg - start_deg) * i / (count - 1))
              for i in range(count)]
    return tuple((centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a))
                 for a in angles)


def streets(town):
    """Return all two-way roads of the town."""
    bend = arc_points((1020.0 - CURVE_RADIUS, 850.0 + CURVE_RADIUS), CURVE_RADIUS, -90, 0, 31)
    arterial = dict(lanes=town.arterial_lanes, speed=13.9, priority=5, sidewalk=True,
                    bike_lane=True)
    return (
        Street("W", "S", **arterial), Street("S", "E", **arterial),
        Street("D", "S", 1, 11.1, 4, sidewalk=True),
        Street("S", "U", 1, 11.1, 2, sidewalk=True),
        Street("U", "N", 1, 11.1, 2, sidewalk=True),
        Street("Ae", "U", 1, 11.1, 4), Street("U", "T", 1, 11.1, 4),
        Street("T", "C", 1, 11.1, 4, curve=bend), Street("TS", "T", 1, 10.0, 2),
        Street("RW", "Aw", 1, 11.1, 3), Street("RN", "An", 1, 11.1, 3),
        Street("RS", "As", 1, 11.1, 3),
    )


def bezier(p0, p1, p2, p3, count):
    """Return points of a cubic Bezier curve, both ends included."""
    points = []
    for i in range(count):
        t = i / (count - 1)
        w = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
        points.append(tuple(sum(wi * p[k] for wi, p in zip(w, (p0, p1, p2, p3)))
                            for k in (0, 1)))
    return tuple(points)


def entry_line():
    """Return the entry lane of the arm along +x, for a ring at the origin."""
    start = (ARM_SPLIT_DISTANCE, LANE_WIDTH / 2)
    end = (RING_RADIUS * math.cos(RING_HALF_ANGLE), RING_RADIUS * math.sin(RING_HALF_ANGLE))
    heading = math.pi - RING_ENTRY_TURN
    return bezier(start, (start[0] - 18.0, start[1]),
                  (end[0] - 12.0 * math.cos(heading), end[1] - 12.0 * math.sin(heading)), end, 25)


def rotated(line, degrees):
    """Return a line that is rotated around the origin, then moved to the ring's centre."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return tuple((RING_CENTRE[0] + c * x - s * y, RING_CENTRE[1] + s * x + c * y)
                 for x, y in line)


def ring_roads():
    """Return the roads of the ring (counter-clockwise) with its entries and exits."""
    half = math.degrees(RING_HALF_ANGLE)
    entry = entry_line()
    exit_line = tuple((x, -y) for x, y in reversed(entry))
    arms = list(ARMS)
    roads = []
    for i, arm in enumerate(arms):
        angle = ARMS[arm][0]
        following = arms[(i + 1) % len(arms)]
        roads.append(OneWay(f"A{arm}_I{arm}", f"A{arm}", f"I{arm}", 8.0, 3, rotated(entry, angle)))
        roads.append(OneWay(f"O{arm}_A{arm}", f"O{arm}", f"A{arm}", 8.0, 3,
                            rotated(exit_line, angle)))
        roads.append(OneWay(f"O{arm}_I{arm}", f"O{arm}", f"I{arm}", 7.0, 9,
                            arc_points(RING_CENTRE, RING_RADIUS, angle - half, angle + half, 13)))
        roads.append(OneWay(f"I{arm}_O{following}", f"I{arm}", f"O{following}", 7.0, 9,
                            arc_points(RING_CENTRE, RING_RADIUS, angle + half,
                                       angle + 90 - half, 11)))
    return tuple(roads)


def all_nodes():
    """Return all nodes, including the roundabout's: name -> (x, y, type)."""
    nodes = dict(NODES)
    for road in ring_roads():
        nodes[road.start] = (*road.line[0], "priority")
        nodes[road.end] = (*road.line[-1], "priority")
    for arm, (angle, _) in ARMS.items():
        x, y = rotated(((ARM_SPLIT_DISTANCE, 0.0),), angle)[0]
        nodes[f"A{arm}"] = (x, y, "priority")
    return nodes


class TownWriter:
    """Writes a town as the three plain-XML files that netconvert reads."""

    def __init__(self, town):
        self.town = town

    def place(self, point):
        """Return the coordinates in this town of a point in the right-hand town, as text."""
        x = MIRROR_SUM - point[0] if self.town.left_hand else point[0]
        return f"{x:.4f}", f"{point[1]:.4f}"

    def shape(self, points):
        return " ".join(",".join(self.place(p)) for p in points)

    def nodes_xml(self):
        rows = []
        for name, (x, y, kind) in sorted(all_nodes().items()):
            px, py = self.place((x, y))
            radius = STREET_CORNER_RADIUS if name in NODES else RING_CORNER_RADIUS
            rows.append(f'<node id="{name}" x="{px}" y="{py}" type="{kind}" radius="{radius}"/>')
        return wrap("nodes", rows)

    def street_rows(self, street):
        """Yield the edges of both directions of a street."""
        nodes = all_nodes()
        line = [nodes[street.start][:2], *street.curve, nodes[street.end][:2]]
        for start, end, points in ((street.start, street.end, line),
                                   (street.end, street.start, line[::-1])):
            extra = (f' sidewalkWidth="{SIDEWALK_WIDTH}"' if street.sidewalk
                     else ' disallow="pedestrian"')
            extra += f' bikeLaneWidth="{BIKE_LANE_WIDTH}"' if street.bike_lane else ""
            yield (f'<edge id="{start}_{end}" from="{start}" to="{end}" '
                   f'numLanes="{street.lanes}" speed="{street.speed}" width="{LANE_WIDTH}" '
                   f'priority="{street.priority}" shape={quoteattr(self.shape(points))}{extra}/>')

    def edges_xml(self):
        rows = [row for street in streets(self.town) for row in self.street_rows(street)]
        for road in ring_roads():
            rows.append(f'<edge id="{road.name}" from="{road.start}" to="{road.end}" numLanes="1" '
                        f'speed="{road.speed}" width="{LANE_WIDTH}" priority="{road.priority}" '
                        f'spreadType="center" disallow="pedestrian" shape={quoteattr(self.shape(road.line))}/>')
        return wrap("edges", rows)

    def connections_xml(self):
        """Return the pedestrian crossings; netconvert computes the lane connections."""
        rows = [f'<crossing node="S" edges="{a}_S S_{a}" priority="true" width="3"/>'
                for a in ("W", "E", "D", "U")]
        rows += [f'<crossing node="U" edges="{a}_U U_{a}" priority="true" width="3"/>'
                 for a in ("Ae", "T", "S", "N")]
        return wrap("connections", rows)


def wrap(tag, rows):
    return "\n".join([f"<{tag}>", *("    " + row for row in rows), f"</{tag}>", ""])
