"""Checks the files of the embedded data and prints a table of its scenes."""
import json
import math

from arcs import path_poses
from map_mask import drivable_polygons, mask_png
from motion import drive_figures
from picker import BUSY_RANGE
from plane import boxes_overlap, inside_polygon, shifted, wrap_angle
from tables import TABLES
from traffic import EGO, KINDS, PEDESTRIAN

LARGEST_SIZE = 6_000_000        # bytes
POSE_PERIOD = 0.1               # seconds
MOVING_STEP = 0.5               # metres between keyframes 0.5 s apart
SMOOTHING_STEPS = 5             # poses are rounded to 1 mm, so motion is derived over 0.5 s
END_MARGIN = 0.1                # metres at a lane's ends that are not checked: they may lie on an area's border
LINKS = {"sample_token": "sample", "instance_token": "instance", "log_token": "log",
         "ego_pose_token": "ego_pose", "calibrated_sensor_token": "calibrated_sensor",
         "sensor_token": "sensor", "category_token": "category", "scene_token": "scene",
         "visibility_token": "visibility", "first_sample_token": "sample",
         "last_sample_token": "sample", "first_annotation_token": "sample_annotation",
         "last_annotation_token": "sample_annotation"}


def yaw_of(row):
    w, _, _, z = row["rotation"]
    return 2.0 * math.atan2(z, w)


def annotation_box(row):
    width, length, _ = row["size"]
    return (*row["translation"][:2], yaw_of(row), length, width)


def ego_box(pose):
    """Return the ego car's box from its rear axle pose."""
    body = KINDS[EGO]
    x, y = pose["translation"][:2]
    yaw = yaw_of(pose)
    return (*shifted((x, y), yaw, body.length / 2.0 - body.rear_overhang), yaw,
            body.length, body.width)


class Data:
    """All tables by name, and rows by token."""

    def __init__(self, folder):
        self.tables = {name: json.loads((folder / f"{name}.json").read_text())
                       for name in TABLES}
        self.rows = {name: {row["token"]: row for row in rows}
                     for name, rows in self.tables.items()}

    def get(self, table, token):
        return self.rows[table][token]


def link_faults(data):
    """Yield faults of tokens: missing, repeated, or linked in one direction only."""
    for name, rows in data.tables.items():
        if len(data.rows[name]) != len(rows):
            yield f"{name}: repeated tokens"
        for row in rows:
            for key, target in LINKS.items():
                if key in row and row[key] not in data.rows[target]:
                    yield f"{name} {row['token']}: {key} names no {target}"
            for attribute in row.get("attribute_tokens", []):
                if attribute not in data.rows["attribute"]:
                    yield f"{name} {row['token']}: unknown attribute"
            following = row.get("next")
            if following and data.rows[name].get(following, {}).get("prev") != row["token"]:
                yield f"{name} {row['token']}: next and prev disagree"


def lane_faults(name, roads):
    """Yield faults of centrelines that do not match their poses or do not meet their neighbours."""
    paths, links = roads["arcline_path_3"], roads["connectivity"]
    lanes = {row["token"] for layer in ("lane", "lane_connector") for row in roads[layer]}
    if lanes != set(paths) or lanes != set(links):
        yield f"{name}: lanes, centrelines and connectivity differ"
    for token, path in paths.items():
        for item, following in zip(path, path[1:] + [None]):
            end = path_poses([item], 1e9)[-1]
            for pose in [item["end_pose"]] + ([following["start_pose"]] if following else []):
                if not poses_meet(end, pose):
                    yield f"{name} {token}: primitives do not meet"
        for other in links[token]["outgoing"]:
            if not poses_meet(path[-1]["end_pose"], paths[other][0]["start_pose"]):
                yield f"{name} {token}: does not meet {other}"
            if token not in links[other]["incoming"]:
                yield f"{name} {token}: {other} does not lead back"


def poses_meet(a, b):
    return (math.dist(a[:2], b[:2]) < 0.01
            and abs(wrap_angle(a[2] - b[2])) < math.radians(2.0))


def area_faults(name, roads):
    """Yield points of centrelines, and 1.2 m beside them, off the drivable area."""
    polygons = drivable_polygons(roads)
    for token, path in roads["arcline_path_3"].items():
        ends = (path[0]["start_pose"][:2], path[-1]["end_pose"][:2])
        for x, y, yaw in path_poses(path, 2.0):
            if min(math.dist((x, y), end) for end in ends) < END_MARGIN:
                continue
            for aside in (-1.2, 0.0, 1.2):
                point = shifted((x, y), yaw + math.pi / 2.0, aside)
                if not any(inside_polygon(point, polygon) for polygon in polygons):
                    yield f"{name} {token}: ({x:.1f}, {y:.1f}) is off the drivable area"


def mask_faults(folder, data, maps):
    """Yield map masks that are missing or differ from the drivable area."""
    for row in data.tables["map"]:
        path = folder / row["filename"]
        if not path.is_file() or path.read_bytes() != mask_png(maps[path.stem]):
            yield f"{row['filename']}: is not the mask of its drivable area"


class SceneCheck:
    """One scene read back from the tables."""

    def __init__(self, data, scene):
        self.data = data
        self.scene = scene
        self.location = data.get("log", scene["log_token"])["location"]
        self.samples = self.chain("sample", scene["first_sample_token"])
        wanted = {row["token"] for row in self.samples}
        messages = [row for row in data.tables["sample_data"] if row["sample_token"] in wanted]
        self.poses = [data.get("ego_pose", row["ego_pose_token"]) for row in messages]
        self.key_poses = {row["sample_token"]: data.get("ego_pose", row["ego_pose_token"])
                          for row in messages if row["is_key_frame"]}
        self.boxes = {token: [] for token in wanted}
        for row in data.tables["sample_annotation"]:
            if row["sample_token"] in wanted:
                self.boxes[row["sample_token"]].append(row)

    def chain(self, table, token):
        rows = []
        while token:
            rows.append(self.data.get(table, token))
            token = rows[-1]["next"]
        return rows

    def speeds(self):
        places = [row["translation"][:2] for row in self.poses]
        return [math.dist(a, b) / POSE_PERIOD for a, b in zip(places, places[1:])]

    def category(self, row):
        instance = self.data.get("instance", row["instance_token"])
        return self.data.get("category", instance["category_token"])["name"]

    def is_moving(self, row):
        """Return True if an annotated vehicle moves between this keyframe and a neighbour."""
        other = row["next"] or row["prev"]
        if not other or self.category(row) == KINDS[PEDESTRIAN].category:
            return False
        place = self.data.get("sample_annotation", other)["translation"]
        return math.dist(row["translation"][:2], place[:2]) > MOVING_STEP

    def moving_counts(self):
        """Return the number of moving vehicles near the ego car on each keyframe."""
        counts = []
        for sample in self.samples:
            ego = ego_box(self.key_poses[sample["token"]])
            counts.append(sum(
                math.dist(row["translation"][:2], ego[:2]) < BUSY_RANGE and self.is_moving(row)
                for row in self.boxes[sample["token"]]))
        return counts

    def faults(self):
        name = self.scene["name"]
        if not len(self.samples) == self.scene["nbr_samples"] == len(self.key_poses) == 41:
            yield f"{name}: not 41 keyframes"
        poses = [(*row["translation"][:2], yaw_of(row)) for row in self.poses][::SMOOTHING_STEPS]
        figures = drive_figures(poses, SMOOTHING_STEPS * POSE_PERIOD)
        if not (figures.yaw_rate < 1.0 and figures.lateral_acceleration < 5.0
                and figures.acceleration < 5.0 and figures.slip < math.radians(10.0)):
            yield f"{name}: the ego car's motion is outside the limits of a car: {figures}"
        for sample in self.samples:
            rows = self.boxes[sample["token"]]
            boxes = [ego_box(self.key_poses[sample["token"]]), *map(annotation_box, rows)]
            for i, box in enumerate(boxes):
                if any(boxes_overlap(box, other) for other in boxes[i + 1:]):
                    yield f"{name}: boxes overlap at {sample['timestamp']}"

    def ego_area_faults(self, polygons):
        for row in self.poses:
            x, y, yaw, _, _ = ego_box(row)
            if not any(inside_polygon((x, y), polygon) for polygon in polygons):
                yield f"{self.scene['name']}: the ego car leaves the drivable area"

    def line(self):
        speeds, counts = self.speeds(), self.moving_counts()
        rows = [row for sample in self.samples for row in self.boxes[sample["token"]]]
        instances = {row["instance_token"]: self.category(row) for row in rows}
        classes = {}
        for category in sorted(instances.values()):
            short = category.split(".")[1]
            classes[short] = classes.get(short, 0) + 1
        text = " ".join(f"{name}:{count}" for name, count in classes.items())
        return (f"{self.scene['name']} {self.location.split('-')[-1]:5} "
                f"{min(speeds):4.1f} {sum(speeds) / len(speeds):4.1f} {max(speeds):4.1f}  "
                f"{len(instances):4}  {min(counts):2} {sum(counts) / len(counts):4.1f} "
                f"{max(counts):2}  {text}")


def check(folder, version):
    """Print the scenes and every fault; return 0 without a fault, else 1."""
    data = Data(folder / version)
    faults = list(link_faults(data))
    maps = {path.stem: json.loads(path.read_text())
            for path in sorted((folder / "maps" / "expansion").glob("*.json"))}
    for name, roads in maps.items():
        faults += [*lane_faults(name, roads), *area_faults(name, roads)]
    faults += mask_faults(folder, data, maps)
    areas = {name: drivable_polygons(roads) for name, roads in maps.items()}
    print("scene      side  ego speed m/s   agents  moving within 60 m (min mean max)  classes")
    for row in data.tables["scene"]:
        scene = SceneCheck(data, row)
        faults += [*scene.faults(), *scene.ego_area_faults(areas[scene.location])]
        print(scene.line())
    size = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
    print(f"{size} bytes in all")
    if size > LARGEST_SIZE:
        faults.append(f"more than {LARGEST_SIZE} bytes")
    for fault in faults:
        print(f"fault: {fault}")
    return 1 if faults else 0
