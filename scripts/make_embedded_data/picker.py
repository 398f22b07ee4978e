"""Chooses, for each scene, the ego candidate and the 20 s with the most traffic."""
import math
from dataclasses import dataclass

from motion import drive_figures, motion_of, parked_motion, speed_error
from plane import boxes_overlap
from scenes import KEYFRAME_STEPS, SCENE_STEPS
from simulation import STEP
from town import MIRROR_SUM
from traffic import PARKED, PEDESTRIAN, RECORDED, WARM_UP

ANNOTATED_RANGE = 68.0      # metres from the ego car
ASIDE_RANGE = 38.0          # metres, for parked cars and pedestrians
LARGEST_SPEED_ERROR = 0.5   # m/s, of the ego car's poses against SUMO's speeds
BUSY_RANGE = 60.0
MOST_AGENTS = 22            # annotated in one keyframe, the nearest ones
LANDMARK_STEPS = (80, 100, 120)   # steps from the start until the ego car passes the landmark
SLOWEST_MEAN = 5.0          # m/s
MOST_STANDING = 0.15        # share of the scene in which the ego car may stand
STANDING_SPEED = 0.5
MOVING_SPEED = 2.0


def annotated_range(motion):
    """Return the distance from the ego car up to which a motion is annotated, m."""
    aside = motion.kind == PEDESTRIAN or motion.name.startswith(PARKED)
    return ASIDE_RANGE if aside else ANNOTATED_RANGE


@dataclass
class Recording:
    """A chosen scene: the motions of the ego car and of agents near it, and the first step."""
    spec: object
    first_step: int
    ego: object
    others: list

    def keyframes(self):
        return range(self.first_step, self.first_step + SCENE_STEPS + 1, KEYFRAME_STEPS)

    def steps(self):
        return range(self.first_step, self.first_step + SCENE_STEPS + 1)

    def near(self, step):
        """Return the motions annotated on a step, nearest first."""
        centre = self.ego.box(step)[:2]
        found = [(math.dist(centre, other.box(step)[:2]), other.name, other)
                 for other in self.others if other.has(step)]
        found = sorted(item for item in found if item[0] < annotated_range(item[2]))
        return [item[2] for item in found[:MOST_AGENTS]]


def landmark_step(track, landmark):
    """Return the step on which a track passes closest to a point."""
    distances = [math.dist(point, landmark) for point in track.points]
    return track.first_step + distances.index(min(distances))


def windows(spec, tracks, left_hand):
    """Yield (track, first step) of all candidate windows of a scene."""
    x, y = spec.landmark
    landmark = (MIRROR_SUM - x if left_hand else x, y)
    prefix = "ego:" + ":".join(spec.route) + ":"
    for name in sorted(name for name in tracks if name.startswith(prefix)):
        track = tracks[name]
        middle = landmark_step(track, landmark)
        for before in LANDMARK_STEPS:
            first = middle - before
            covered = track.index_at(first) is not None
            if covered and track.index_at(first + SCENE_STEPS) is not None:
                if first >= round(WARM_UP / STEP) and first + SCENE_STEPS < (
                        WARM_UP + RECORDED) / STEP:
                    yield track, first


def score(track, first, tracks):
    """Return a measure of the traffic near the ego car; None if the drive is too slow."""
    start = track.index_at(first)
    speeds = track.speeds[start:start + SCENE_STEPS + 1]
    standing = sum(v < STANDING_SPEED for v in speeds) / len(speeds)
    if sum(speeds) / len(speeds) < SLOWEST_MEAN or standing > MOST_STANDING:
        return None
    total = 0.0
    for step in range(first, first + SCENE_STEPS + 1, 2 * KEYFRAME_STEPS):
        centre = track.points[track.index_at(step)]
        for other in tracks.values():
            index = other.index_at(step)
            if index is None or other is track or other.kind == PEDESTRIAN:
                continue
            if math.dist(other.points[index], centre) < BUSY_RANGE:
                total += 1.0 if other.speeds[index] > MOVING_SPEED else 0.2
    return total


def parked_near(parked, first):
    """Return the parked cars as motions over a scene's steps."""
    return [parked_motion(name, kind, pose, first, SCENE_STEPS + 1)
            for name, kind, pose in parked]


def record(spec, track, first, tracks, parked):
    """Return the recording of a chosen window."""
    ego = motion_of(track)
    others = []
    for other in tracks.values():
        if other is track:
            continue
        for step in range(first, first + SCENE_STEPS + 1, KEYFRAME_STEPS):
            index = other.index_at(step)
            if index is not None and math.dist(
                    other.points[index], ego.rear_axle(step)[:2]) < ANNOTATED_RANGE + 10.0:
                others.append(motion_of(other))
                break
    return Recording(spec, first, ego, others + parked_near(parked, first))


def is_clean(recording):
    """Return True if no boxes overlap and all motions are smooth."""
    boxes = {}
    for step in recording.keyframes():
        present = [recording.ego, *recording.near(step)]
        boxes[step] = [motion.box(step) for motion in present]
    for row in boxes.values():
        for i, box in enumerate(row):
            if any(boxes_overlap(box, other) for other in row[i + 1:]):
                return False
    return all(is_smooth(motion, recording) for motion in [recording.ego, *recording.others])


def is_smooth(motion, recording):
    """Return True if a motion keeps the limits over the scene; pedestrians have none."""
    if motion.kind == PEDESTRIAN:
        return True
    steps = [step for step in recording.steps() if motion.has(step)]
    poses = [motion.rear_axle(step) for step in steps]
    figures = drive_figures(poses, STEP)
    if motion is recording.ego:
        speeds = [motion.speed(step) for step in steps]
        if speed_error(poses, speeds, STEP) > LARGEST_SPEED_ERROR:
            return False
    hardest = 4.5 if motion is recording.ego else 8.0
    return (figures.yaw_rate < 1.0 and figures.lateral_acceleration < 5.0
            and figures.acceleration < hardest and figures.slip < math.radians(10.0))


def pick(spec, tracks, parked, left_hand, taken):
    """Return the best clean window of a scene whose ego track is not taken by another scene."""
    scored = []
    for track, first in windows(spec, tracks, left_hand):
        value = score(track, first, tracks)
        if value is not None and (spec.location, track.name) not in taken:
            scored.append((-value, track.name, first))
    for _, name, first in sorted(scored):
        recording = record(spec, tracks[name], first, tracks, parked)
        if is_clean(recording):
            taken.add((spec.location, name))
            return recording
    raise RuntimeError(f"{spec.name}: none of {len(scored)} windows is clean")
