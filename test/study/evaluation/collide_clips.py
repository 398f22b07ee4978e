"""Make clips in COLLIDE's layout for tests: with random motion, and from the embedded recordings."""
import json
import math
import random
from pathlib import Path

NOW = 7              # frame
INTERVAL = 500000    # microseconds between frames
START = 1600000000123456
EGO_MIDDLE = 1.385   # m ahead of the recorded pose, config/ego_vehicle.yaml
ATTACKER = 'a77ac4e5'


def write_clip(folder, tracks, kind, city, scene, angle, timestamps, placement=4):
    """Write a clip and return its path. `tracks`: by id, per frame (speed, x, y, yaw in degrees) or None if missing."""
    last = len(timestamps) - 1
    name = 'data_hcis_v4.5_trainval_{}_{}_{}_{}-0-{!r}-{}_{!r}_{}.csv'.format(
        city, kind, scene, placement, (last - 8) / 12, last, round(angle, 2), ATTACKER)
    path = Path(folder, name)
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(str(path), 'w') as file:
        file.write('TRACK_ID,TIMESTAMP,V,X,Y,YAW\n')
        for key in sorted(tracks):
            for time, state in zip(timestamps, tracks[key]):
                file.write('{},{},{}\n'.format(key, time, ','.join(repr(float(value)) for value in state or (0,) * 4)))
    return path


# ---- random motion ----

def random_track(generator, timestamps, spread):
    """Return a track on an arc at nearly constant speed that passes near the origin at a random frame."""
    speed, turn = generator.uniform(-2.0, 12.0), generator.uniform(-0.3, 0.3)
    yaw = generator.uniform(-math.pi, math.pi)
    x, y = generator.gauss(0.0, spread), generator.gauss(0.0, spread)
    middle = timestamps[generator.randrange(len(timestamps))]
    states = []
    for time in timestamps:
        t = (time - middle) * 1e-6
        heading = yaw + 0.5 * turn * t
        degrees = math.degrees(yaw + turn * t + generator.gauss(0.0, 0.02))
        states.append((abs(speed), x + speed * t * math.cos(heading), y + speed * t * math.sin(heading),
                       (degrees + 180.0) % 360.0 - 180.0))
    return states


def with_missing_frames(generator, states):
    """Remove leading and trailing frames, or a gap, from a track."""
    first = generator.choice([0, 0, generator.randrange(len(states))])
    last = generator.choice([len(states), len(states), generator.randrange(len(states))])
    gap = generator.choice([None, generator.randrange(len(states))])
    return [state if first <= frame < last and frame != gap else None for frame, state in enumerate(states)]


def write_random_clips(folder, count, city, seed):
    generator = random.Random(seed)
    for number in range(count):
        last = generator.randrange(8, 21)
        timestamps = [START + INTERVAL * frame + generator.randrange(-50000, 50000) for frame in range(last + 1)]
        tracks = {'ego': random_track(generator, timestamps, 3.0), ATTACKER: random_track(generator, timestamps, 6.0)}
        for _ in range(generator.randrange(4)):
            key = '{:08x}'.format(generator.getrandbits(32))
            tracks[key] = with_missing_frames(generator, random_track(generator, timestamps, 40.0))
        kind = generator.choice(['LC', 'HO', 'RE', 'JC', 'LTAP'])
        write_clip(folder, tracks, kind, city, 'scene-{:04d}'.format(number // 4), generator.uniform(0.0, 180.0),
                   timestamps)


# ---- from the embedded recordings ----

def yaw_of(rotation):
    w, x, y, z = rotation
    return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


class Recording:
    """Return ego and vehicles of an embedded scene: by id, (x, y, yaw in rad) per keyframe, None while absent."""

    def __init__(self, tables, scene):
        def table(name):
            return json.loads(Path(tables, name + '.json').read_text())

        row, = (row for row in table('scene') if row['name'] == scene)
        self.city, = (log['location'] for log in table('log') if log['token'] == row['log_token'])
        samples = sorted((sample for sample in table('sample') if sample['scene_token'] == row['token']),
                         key=lambda sample: sample['timestamp'])
        frames = {sample['token']: frame for frame, sample in enumerate(samples)}
        self.timestamps = [sample['timestamp'] for sample in samples]
        poses = {pose['token']: pose for pose in table('ego_pose')}
        self.tracks = {'ego': [None] * len(samples)}
        for data in table('sample_data'):
            if data['sample_token'] in frames and data['is_key_frame']:
                pose = poses[data['ego_pose_token']]
                x, y, yaw = pose['translation'][0], pose['translation'][1], yaw_of(pose['rotation'])
                self.tracks['ego'][frames[data['sample_token']]] = (
                    x + EGO_MIDDLE * math.cos(yaw), y + EGO_MIDDLE * math.sin(yaw), yaw)
        for annotation in table('sample_annotation'):
            if annotation['sample_token'] in frames:
                track = self.tracks.setdefault(annotation['instance_token'], [None] * len(samples))
                track[frames[annotation['sample_token']]] = (
                    annotation['translation'][0], annotation['translation'][1], yaw_of(annotation['rotation']))

    def cut(self, first, last):
        """Return the tracks between two frames with speeds and degrees; omit agents that are absent in all frames."""
        cut = {}
        for key, track in self.tracks.items():
            states = track[first:last + 1]
            if any(states):
                cut[key] = [state and self.with_speed(states, frame) for frame, state in enumerate(states)]
        return cut

    @staticmethod
    def with_speed(states, frame):
        x, y, yaw = states[frame]
        before = states[frame - 1] if frame > 0 else None
        speed = math.hypot(x - before[0], y - before[1]) / (INTERVAL * 1e-6) if before else 0.0
        return speed, x, y, math.degrees(yaw)


def write_embedded_clip(folder, tables, scene, first, last):
    """Return a vehicle that approaches the ego's rear: 4 m behind it in the last frame, always 4 m/s faster."""
    recording = Recording(tables, scene)
    tracks = recording.cut(first, last)
    timestamps = recording.timestamps[first:last + 1]
    end = tracks['ego'][-1]
    yaw = math.radians(end[3])
    speed = end[0] + 4.0
    attacker = []
    for time in timestamps:
        behind = 4.0 + speed * (timestamps[-1] - time) * 1e-6
        attacker.append((speed, end[1] - behind * math.cos(yaw), end[2] - behind * math.sin(yaw), end[3]))
    tracks[ATTACKER] = attacker
    return write_clip(folder, tracks, 'RE', recording.city, scene, 0.0, timestamps)
