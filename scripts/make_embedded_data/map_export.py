"""Converts the roads to the dictionary of a nuScenes map expansion (version 1.3)."""
import math

from arcs import arcline_path, fit
from plane import cumulative_lengths, offset_line, point_at, shifted, simplified, vertex_headings
from tokens import token
from town import LANE_WIDTH

CANVAS = [1400.0, 1400.0]
OUTLINE_TOLERANCE = 0.02    # metres
STOP_LINE_DEPTH = 1.0
BAY_EDGES = ("Ae_U", "U_Ae", "U_T", "T_U")
BAY_DEPTH = 2.3
BAY_LENGTH = 6.2
BAY_MARGIN = 28.0           # metres at both ends of a road without bays
DRIVE_EDGES = ("D_S", "S_D", "S_U", "U_S", "U_N", "N_U", "T_C", "C_T")
DRIVE_WIDTH = 5.0
DRIVE_DEPTH = 9.0           # metres from the kerb, over the walkway
DRIVE_SPACING = 35.0
LAYERS = ("polygon", "line", "node", "drivable_area", "road_segment", "road_block", "lane",
          "ped_crossing", "walkway", "stop_line", "carpark_area", "road_divider", "lane_divider",
          "traffic_light", "lane_connector")


class MapBuilder:
    """Collects the layers of one map. Tokens are hashes of names; equal points share a node."""

    def __init__(self, location):
        self.location = location
        self.layers = {name: [] for name in LAYERS}
        self.nodes = {}

    def token(self, *parts):
        return token(self.location, *parts)

    def node(self, point):
        x, y = round(point[0], 3), round(point[1], 3)
        if (x, y) not in self.nodes:
            self.nodes[x, y] = self.token("node", x, y)
            self.layers["node"].append({"token": self.nodes[x, y], "x": x, "y": y})
        return self.nodes[x, y]

    def polygon(self, name, points):
        row = {"token": self.token("polygon", name),
               "exterior_node_tokens": [self.node(point) for point in points], "holes": []}
        self.layers["polygon"].append(row)
        return row["token"]

    def line(self, name, points):
        row = {"token": self.token("line", name),
               "node_tokens": [self.node(point) for point in points]}
        self.layers["line"].append(row)
        return row["token"]

    def add(self, layer, name, **fields):
        row = {"token": self.token(layer, name), **fields}
        self.layers[layer].append(row)
        return row["token"]


def lane_headings(lane, lanes):
    """Return a lane's headings; a path through a junction takes its end headings from its lanes."""
    headings = vertex_headings(lane.shape)
    if lane.in_junction:
        headings[0] = vertex_headings(lanes[lane.incoming[0]].shape)[-1]
        headings[-1] = vertex_headings(lanes[lane.outgoing[0]].shape)[0]
    return headings


def border(lane, headings, left):
    """Return one border of a lane, simplified."""
    return simplified(offset_line(lane.shape, headings, left), OUTLINE_TOLERANCE)


def outline(lane, headings):
    """Return a lane's polygon, counter-clockwise."""
    right, left = (border(lane, headings, side * lane.width / 2.0) for side in (-1.0, 1.0))
    return right + left[::-1]


def outward(left_hand):
    """Return +1 if the kerb is on the left of a lane, -1 if it is on its right."""
    return 1.0 if left_hand else -1.0


def edge_outline(lanes, left_hand):
    """Return the polygon over all driven lanes of an edge, from the kerb to the middle line."""
    side = outward(left_hand)
    kerb, middle = lanes[0], lanes[-1]
    kerb_border = border(kerb, vertex_headings(kerb.shape), side * kerb.width / 2.0)
    middle_border = border(middle, vertex_headings(middle.shape), -side * middle.width / 2.0)
    polygon = kerb_border + middle_border[::-1]
    return polygon[::-1] if left_hand else polygon


def turn_of(way):
    headings = vertex_headings(way.shape)
    return math.remainder(headings[-1] - headings[0], 2.0 * math.pi)


def junction_outline(junction, network, left_hand):
    """Return a junction's polygon: the kerb sides of the outermost path from each arm."""
    side = outward(left_hand)
    arms = {}
    for connection in network.connections:
        if network.edges[connection.start.edge].end == junction:
            arms.setdefault(connection.start.edge, []).append(connection.way)
    borders = []
    for name in sorted(arms):
        ways = arms[name]
        outermost = max(ways, key=lambda way: (side * turn_of(way), way.name))
        headings = vertex_headings(outermost.shape)
        borders.append(border(outermost, headings, side * outermost.width / 2.0))
    starts = [points[0] for points in borders]
    middle = [sum(p[k] for p in starts) / len(starts) for k in (0, 1)]
    borders.sort(key=lambda points: math.atan2(points[0][1] - middle[1],
                                               points[0][0] - middle[0]), reverse=left_hand)
    polygon = [point for points in borders for point in points]
    return polygon[::-1] if left_hand else polygon


def driven_lanes(edge):
    return [lane for lane in edge.lanes if not lane.is_walk]


def bay_poses(network, left_hand):
    """Yield (edge, number, centre of the bay as x, y, yaw) of the parking bays."""
    side = outward(left_hand)
    for name in BAY_EDGES:
        lane = driven_lanes(network.edges[name])[0]
        lengths = cumulative_lengths(lane.shape)
        yaw = vertex_headings(lane.shape)[0]
        count = int((lengths[-1] - 2.0 * BAY_MARGIN) / BAY_LENGTH)
        for number in range(count):
            s = BAY_MARGIN + (number + 0.5) * BAY_LENGTH
            aside = side * (lane.width / 2.0 + BAY_DEPTH / 2.0)
            centre = shifted(point_at(lane.shape, lengths, s), yaw + math.pi / 2.0, aside)
            yield name, number, (*centre, yaw)


def bay_strips(network, left_hand):
    """Yield (edge, polygon) of the strip of parking bays along each edge that has one."""
    rows = {}
    for name, _, pose in bay_poses(network, left_hand):
        rows.setdefault(name, []).append(pose)
    for name, poses in rows.items():
        corners = []
        for pose, along in ((poses[0], -1.0), (poses[-1], 1.0)):
            end = shifted(pose[:2], pose[2], along * BAY_LENGTH / 2.0)
            corners.append([shifted(end, pose[2] + math.pi / 2.0, across * BAY_DEPTH / 2.0)
                            for across in (-1.0, 1.0)])
        yield name, [corners[0][0], corners[1][0], corners[1][1], corners[0][1]]


def drives(network, left_hand):
    """Yield (name, polygon) of the drives beside the roads."""
    side = outward(left_hand)
    for name in DRIVE_EDGES:
        lane = driven_lanes(network.edges[name])[0]
        lengths = cumulative_lengths(lane.shape)
        for number in range(1, int((lengths[-1] - BAY_MARGIN) / DRIVE_SPACING) + 1):
            s = number * DRIVE_SPACING
            before = point_at(lane.shape, lengths, s - DRIVE_WIDTH / 2.0)
            after = point_at(lane.shape, lengths, s + DRIVE_WIDTH / 2.0)
            across = math.atan2(after[1] - before[1], after[0] - before[0]) + side * math.pi / 2.0
            kerb = lane.width / 2.0
            yield f"{name} {number}", [shifted(end, across, out) for end, out in (
                (before, kerb), (after, kerb), (after, kerb + DRIVE_DEPTH),
                (before, kerb + DRIVE_DEPTH))]


def add_lanes(builder, network):
    """Add lanes and lane connectors; return centrelines, connectivity and connector polygons."""
    ways = {c.way.name: c.way for c in network.connections if c.way.is_car}
    every = {**{name: lane for name, lane in network.lanes.items() if lane.is_car}, **ways}
    paths, connectivity, polygons = {}, {}, []
    tokens = {name: builder.token("lane_connector" if lane.in_junction else "lane", name)
              for name, lane in every.items()}
    for name, lane in every.items():
        headings = lane_headings(lane, network.lanes)
        polygon = builder.polygon(name, outline(lane, headings))
        if lane.in_junction:
            polygons.append(polygon)
            builder.add("lane_connector", name, polygon_token=polygon)
        else:
            builder.add("lane", name, polygon_token=polygon, lane_type="CAR",
                        from_edge_line_token="", to_edge_line_token="",
                        left_lane_divider_segments=[], right_lane_divider_segments=[])
        paths[tokens[name]] = arcline_path(fit(lane.shape, headings))
        connectivity[tokens[name]] = {
            "incoming": [tokens[other] for other in lane.incoming if other in tokens],
            "outgoing": [tokens[other] for other in lane.outgoing if other in tokens]}
    return paths, connectivity, polygons


def add_surfaces(builder, network, connectors, left_hand):
    """Add road segments, drives, and the drivable area: also connectors and parking bays."""
    area = builder.token("drivable_area", "all")
    polygons = list(connectors)
    for name, edge in network.edges.items():
        polygon = builder.polygon(f"edge {name}", edge_outline(driven_lanes(edge), left_hand))
        builder.add("road_segment", name, polygon_token=polygon, is_intersection=False,
                    drivable_area_token=area)
        polygons.append(polygon)
    for junction in sorted({network.edges[c.start.edge].end for c in network.connections}):
        polygon = builder.polygon(f"junction {junction}",
                                  junction_outline(junction, network, left_hand))
        builder.add("road_segment", f"junction {junction}", polygon_token=polygon,
                    is_intersection=True, drivable_area_token=area)
        polygons.append(polygon)
    polygons += [builder.polygon(f"bays {name}", points)
                 for name, points in bay_strips(network, left_hand)]
    builder.add("drivable_area", "all", polygon_tokens=polygons)
    for name, points in drives(network, left_hand):
        builder.add("carpark_area", name, polygon_token=builder.polygon(f"drive {name}", points))


def add_crossings(builder, network):
    """Add pedestrian crossings and walkways; return crossing tokens by crossed edge."""
    crossed = {}
    for name, (lane, edges) in network.crossings.items():
        polygon = builder.polygon(name, outline(lane, vertex_headings(lane.shape)))
        made = builder.add("ped_crossing", name, polygon_token=polygon, road_segment_token="")
        crossed.update((edge, made) for edge in edges)
    for lane in network.lanes.values():
        if lane.is_walk:
            polygon = builder.polygon(lane.name, outline(lane, vertex_headings(lane.shape)))
            builder.add("walkway", lane.name, polygon_token=polygon)
    return crossed


def add_signal(builder, name, lanes, yaw):
    """Add a traffic light beside the stop line of an edge; return its token."""
    spot = shifted(lanes[0].shape[-1], yaw, 1.0)
    height, pose_yaw = 4.0, round(math.remainder(yaw + math.pi, 2.0 * math.pi), 6)
    items = [{"color": color, "shape": "CIRCLE",
              "rel_pos": {"tx": 0.0, "ty": 0.0, "tz": z, "rx": 0.0, "ry": 0.0, "rz": 0.0},
              "to_road_block_tokens": []}
             for color, z in (("RED", 0.3), ("YELLOW", 0.0), ("GREEN", -0.3))]
    line = builder.line(f"signal {name}", [spot, shifted(spot, yaw + math.pi / 2.0, LANE_WIDTH)])
    return builder.add("traffic_light", name, line_token=line, traffic_light_type="VERTICAL",
                       from_road_block_token="", items=items,
                       pose={"tx": round(spot[0], 3), "ty": round(spot[1], 3), "tz": height,
                             "rx": 0.0, "ry": 0.0, "rz": pose_yaw})


def add_stop_lines(builder, network, crossed, left_hand):
    """Add a stop line to each edge with a signal or with a path that has to yield."""
    waiting = {c.start.edge for c in network.connections
               if c.state == "m" and abs(turn_of(c.way)) < 0.6}
    waiting |= {c.start.edge for c in network.connections if c.start.edge == "TS_T"}
    for name, edge in network.edges.items():
        signal = network.junctions[edge.end] == "traffic_light"
        if not signal and name not in waiting:
            continue
        lanes = driven_lanes(edge)
        yaw = vertex_headings(lanes[0].shape)[-1]
        near = edge_outline([straight_end(lane) for lane in lanes], left_hand)
        polygon = builder.polygon(f"stop line {name}", near)
        lights = [add_signal(builder, name, lanes, yaw)] if signal else []
        builder.add("stop_line", name, polygon_token=polygon,
                    stop_line_type="TRAFFIC_LIGHT" if signal else "YIELD",
                    ped_crossing_tokens=[crossed[name]] if name in crossed else [],
                    traffic_light_tokens=lights, road_block_token="")


def straight_end(lane):
    """Return the last part of a lane, as long as a stop line is deep."""
    yaw = vertex_headings(lane.shape)[-1]
    end = lane.shape[-1]
    shape = [shifted(end, yaw, -STOP_LINE_DEPTH), end]
    return type(lane)(lane.name, lane.edge, lane.index, lane.width, shape, lane.is_car,
                      lane.is_walk)


def map_dictionary(network, town):
    """Return the whole map file as a dictionary."""
    builder = MapBuilder(town.location)
    paths, connectivity, connectors = add_lanes(builder, network)
    add_surfaces(builder, network, connectors, town.left_hand)
    crossed = add_crossings(builder, network)
    add_stop_lines(builder, network, crossed, town.left_hand)
    return {**builder.layers, "arcline_path_3": paths, "connectivity": connectivity,
            "version": "1.3", "canvas_edge": CANVAS}
