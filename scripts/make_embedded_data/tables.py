"""The 13 tables of the nuScenes schema."""
import math

from scenes import KEYFRAME_STEPS, SCENE_STEPS
from tokens import token
from traffic import EGO, KINDS, PARKED, PEDESTRIAN

FIRST_TIMESTAMP = 1600000000000000   # microseconds; of the first scene
SCENE_PERIOD = 100000000             # microseconds between the starts of scenes
STEP_PERIOD = 100000
DATE = "2020-09-13"
VEHICLE = "embedded-ego"
CHANNEL = "LIDAR_TOP"
STANDING_SPEED = 0.3

ATTRIBUTES = {
    "vehicle.moving": "Vehicle is moving.",
    "vehicle.stopped": "Vehicle, with a driver in it, is standing.",
    "vehicle.parked": "Vehicle stands in a parking place.",
    "cycle.with_rider": "There is a rider on the bicycle.",
    "pedestrian.moving": "The person is walking.",
    "pedestrian.standing": "The person is standing.",
}
VISIBILITIES = (("1", "v0-40", "0 and 40"), ("2", "v40-60", "40 and 60"),
                ("3", "v60-80", "60 and 80"), ("4", "v80-100", "80 and 100"))
TABLES = ("attribute", "calibrated_sensor", "category", "ego_pose", "instance", "log", "map",
          "sample", "sample_annotation", "sample_data", "scene", "sensor", "visibility")


def rotation(yaw):
    """Return a yaw as a quaternion w, x, y, z."""
    return [round(math.cos(yaw / 2.0), 9), 0.0, 0.0, round(math.sin(yaw / 2.0), 9)]


def neighbours(tokens, i):
    """Return the fields prev and next of row i in a chain."""
    return {"prev": tokens[i - 1] if i > 0 else "",
            "next": tokens[i + 1] if i + 1 < len(tokens) else ""}


def attribute_of(motion, step):
    moving = motion.speed(step) > STANDING_SPEED
    if motion.name.startswith(PARKED):
        return "vehicle.parked"
    if motion.kind == PEDESTRIAN:
        return "pedestrian.moving" if moving else "pedestrian.standing"
    if motion.kind == "bicycle":
        return "cycle.with_rider"
    return "vehicle.moving" if moving else "vehicle.stopped"


def fixed_tables(recordings):
    """Return the tables that do not depend on a drive."""
    categories = sorted({kind.category for name, kind in KINDS.items() if name != EGO})
    locations = sorted({recording.spec.location for recording in recordings})
    logs = {location: log_tokens(recordings, location) for location in locations}
    return {
        "attribute": [{"token": token("attribute", name), "name": name, "description": text}
                      for name, text in ATTRIBUTES.items()],
        "category": [{"token": token("category", name), "name": name, "description": name}
                     for name in categories],
        "visibility": [{"token": key, "level": level,
                        "description": f"visibility of whole object is between {span}%"}
                       for key, level, span in VISIBILITIES],
        "sensor": [{"token": token("sensor", CHANNEL), "channel": CHANNEL, "modality": "lidar"}],
        "calibrated_sensor": [{"token": token("calibrated_sensor", CHANNEL),
                               "sensor_token": token("sensor", CHANNEL),
                               "translation": [0.95, 0.0, 1.84],
                               "rotation": [1.0, 0.0, 0.0, 0.0], "camera_intrinsic": []}],
        "map": [{"token": token("map", location), "category": "semantic_prior",
                 "filename": f"maps/{location}.png", "log_tokens": logs[location]}
                for location in locations],
    }


def log_tokens(recordings, location):
    return [token("log", recording.spec.name) for recording in recordings
            if recording.spec.location == location]


class SceneTables:
    """The rows of one recorded scene."""

    def __init__(self, recording, number):
        self.recording = recording
        self.name = recording.spec.name
        self.start = FIRST_TIMESTAMP + number * SCENE_PERIOD
        self.sample_tokens = [token("sample", self.name, i)
                              for i in range(SCENE_STEPS // KEYFRAME_STEPS + 1)]

    def timestamp(self, step):
        return self.start + (step - self.recording.first_step) * STEP_PERIOD

    def rows(self):
        poses, data = self.drive()
        instances, annotations = self.agents()
        return {"scene": [self.scene()], "log": [self.log()], "sample": self.samples(),
                "ego_pose": poses, "sample_data": data, "instance": instances,
                "sample_annotation": annotations}

    def scene(self):
        return {"token": token("scene", self.name), "log_token": token("log", self.name),
                "nbr_samples": len(self.sample_tokens),
                "first_sample_token": self.sample_tokens[0],
                "last_sample_token": self.sample_tokens[-1], "name": self.name,
                "description": self.recording.spec.description}

    def log(self):
        return {"token": token("log", self.name), "logfile": f"{VEHICLE}-{self.name}",
                "vehicle": VEHICLE, "date_captured": DATE,
                "location": self.recording.spec.location}

    def samples(self):
        return [{"token": own, "timestamp": self.timestamp(step),
                 **neighbours(self.sample_tokens, i), "scene_token": token("scene", self.name)}
                for i, (own, step) in enumerate(zip(self.sample_tokens,
                                                    self.recording.keyframes()))]

    def drive(self):
        """Return ego poses and the lidar messages that refer to them, at 10 Hz."""
        steps = self.recording.steps()
        tokens = [token("sample_data", self.name, i) for i in range(len(steps))]
        poses, data = [], []
        for i, step in enumerate(steps):
            x, y, yaw = self.recording.ego.rear_axle(step)
            time, is_key = self.timestamp(step), i % KEYFRAME_STEPS == 0
            poses.append({"token": tokens[i], "timestamp": time, "rotation": rotation(yaw),
                          "translation": [round(x, 3), round(y, 3), 0.0]})
            folder = "samples" if is_key else "sweeps"
            data.append({"token": tokens[i],
                         "sample_token": self.sample_tokens[i // KEYFRAME_STEPS],
                         "ego_pose_token": tokens[i],
                         "calibrated_sensor_token": token("calibrated_sensor", CHANNEL),
                         "timestamp": time, "fileformat": "pcd", "is_key_frame": is_key,
                         "height": 0, "width": 0,
                         "filename": f"{folder}/{CHANNEL}/{self.name}__{time}.pcd.bin",
                         **neighbours(tokens, i)})
        return poses, data

    def agents(self):
        """Return instances and their annotations on the keyframes where they are near."""
        seen = {}
        for i, step in enumerate(self.recording.keyframes()):
            for motion in self.recording.near(step):
                seen.setdefault(motion.name, []).append((i, step, motion))
        instances, annotations = [], []
        for name in sorted(seen):
            rows = self.annotations_of(name, seen[name])
            category = seen[name][0][2].body().category
            instances.append({"token": token("instance", self.name, name),
                              "category_token": token("category", category),
                              "nbr_annotations": len(rows),
                              "first_annotation_token": rows[0]["token"],
                              "last_annotation_token": rows[-1]["token"]})
            annotations += rows
        return instances, annotations

    def annotations_of(self, name, appearances):
        tokens = [token("annotation", self.name, name, i) for i, _, _ in appearances]
        rows = []
        for k, (i, step, motion) in enumerate(appearances):
            x, y, yaw, length, width = motion.box(step)
            height = motion.body().height
            attribute = attribute_of(motion, step)
            rows.append({"token": tokens[k], "sample_token": self.sample_tokens[i],
                         "instance_token": token("instance", self.name, name),
                         "visibility_token": "4",
                         "attribute_tokens": [token("attribute", attribute)],
                         "translation": [round(x, 3), round(y, 3), round(height / 2.0, 3)],
                         "size": [width, length, height], "rotation": rotation(yaw),
                         **neighbours(tokens, k), "num_lidar_pts": 50, "num_radar_pts": 0})
        return rows


def all_tables(recordings):
    """Return every table by name, each a list of rows."""
    tables = {name: [] for name in TABLES}
    tables.update(fixed_tables(recordings))
    for number, recording in enumerate(recordings):
        for name, rows in SceneTables(recording, number).rows().items():
            tables[name] += rows
    return tables
