"""Shared by the tests of this folder: forge, the package's embedded data, and bags to make, read and damage."""
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import rosbag
import roslib.message
import rospkg
import rosunit
from genpy import Duration, Time

PACKAGE = 'collision_forge'
PACKAGE_FOLDER = Path(rospkg.RosPack().get_path(PACKAGE))
DATAROOT = PACKAGE_FOLDER / 'data' / 'embedded'
VERSION = 'v1.0-embedded'
TIMEOUT = 120.0  # s; a command takes less than one

CODES = ['OK', 'UNKNOWN_TYPE', 'TTA_OUT_OF_RANGE', 'UNKNOWN_ATTACKER', 'ABSENT_ATTACKER', 'TOO_LITTLE_HISTORY',
         'NO_CANDIDATE', 'NO_ATTACK_WITHIN_LIMITS', 'NO_SCENE', 'NO_RECORDING', 'BEYOND_RECORDING', 'INVALID_INPUT',
         'NODE_UNAVAILABLE', 'LOW_CONFIDENCE', 'NOT_BELIEVABLE', 'ROAD_DOES_NOT_ALLOW',
         'STALE_SCENE', 'INTERNAL_ERROR']  # GenerateCollision.srv, by number

TOPICS_AT_NOW = ['/attack', '/attack_request', '/attack_path', '/attack_ego_path']
ATTACK_TOPICS = TOPICS_AT_NOW + ['/attack_markers', '/map_markers', '/tested_report']  # what forge inject adds
ATTACKED_TOPICS = ['/agents', '/annotation_markers', '/agent_objects']  # with further frames in between
EGO_TOPICS = ['/tf', '/odom']  # rewritten after the contact, unless the ego drives on


def run(*arguments):
    """Run forge and return the completed process with exit code, stdout and stderr."""
    return subprocess.run(['forge'] + [str(argument) for argument in arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, universal_newlines=True,
                          timeout=TIMEOUT, check=False)


def copy_config(folder):
    """The shipped configuration in another folder."""
    shutil.copytree(str(PACKAGE_FOLDER / 'config'), str(folder))
    return folder


def convert(out, *arguments, dataroot=DATAROOT, version=VERSION):
    return run('convert', '--dataroot', dataroot, '--version', version, '--out', out, *arguments)


def inject(bag, out, collision_type, tta, now, *arguments):
    return run('inject', '--bag', bag, '--out', out, '--type', collision_type, '--tta', tta, '--now', now,
               *arguments)


def leave_part(path, text, header=False, lines_per_item=1):
    """Create the files of an interrupted run: PATH.part, and the checksums of its complete items (FNV-1a, chained)."""
    part = Path(str(path) + '.part')
    part.write_bytes(text)
    lines = text.split(b'\n')[int(header):-1]
    value, sums = 0xcbf29ce484222325, ''
    for first in range(0, len(lines) - lines_per_item + 1, lines_per_item):
        for byte in b'\n'.join(lines[first:first + lines_per_item]):
            value = (value ^ byte) * 0x100000001b3 % 2 ** 64
        sums += '{:016x}\n'.format(value)
    Path(str(part) + '.sums').write_text(sums)


def is_not_as_asked(injection):
    """Return True if a run of forge inject wrote a bag that does not show the requested crash."""
    return injection.returncode == 3 and injection.stderr.splitlines()[-1].startswith('NOT_AS_ASKED: ')


def code_of(injection):
    """Return the status code of a run of forge inject; OK whenever it wrote an attack."""
    if injection.returncode == 0 or is_not_as_asked(injection):
        return 'OK'
    if injection.returncode == 3:
        return {code.lower(): code for code in CODES}[injection.stderr.splitlines()[-1].split(':')[0].lower()]
    raise AssertionError('forge inject: exit code {}: {}'.format(injection.returncode, injection.stderr))


class RoadTest(unittest.TestCase):
    """A test with a temporary folder that contains the bags of SCENES, scenes of the embedded data."""
    SCENES = []

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='collision_forge_test_')
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = Path(temporary.name)
        if cls.SCENES:
            result = convert(cls.folder, '--scene', *cls.SCENES)
            assert result.returncode == 0, result.stderr

    def bag(self, scene):
        return self.folder / (scene + '.bag')

    def path(self, name):
        """Return a path for a file that only this test uses."""
        return self.folder / (self.id().rsplit('.', 1)[-1] + '_' + name)

    def assert_close(self, actual, expected, tolerance=1e-6, name='message'):
        """Check that two messages (or parts) are equal, numbers and times within the tolerance; ignore header.seq."""
        if isinstance(expected, (Time, Duration)):
            actual, expected = actual.to_sec() - expected.to_sec(), 0.0
        if hasattr(expected, '__slots__'):
            self.assertIs(type(actual), type(expected), name)
            for field in expected.__slots__:
                if field == 'seq' and hasattr(expected, 'frame_id'):
                    continue  # counts the publisher's messages
                self.assert_close(getattr(actual, field), getattr(expected, field), tolerance, name + '.' + field)
        elif isinstance(expected, (list, tuple)):
            self.assertEqual(len(actual), len(expected), 'length of ' + name)
            for index, pair in enumerate(zip(actual, expected)):
                self.assert_close(*pair, tolerance, '{}[{}]'.format(name, index))
        elif isinstance(expected, float):
            self.assertLessEqual(abs(actual - expected), tolerance, name)
        else:
            self.assertEqual(actual, expected, name)


def messages_of(bag, topics=None):
    """Like bag.read_messages(), but with the installed message classes, which can be compared."""
    for topic, (datatype, data, md5sum, _, class_of_bag), time in bag.read_messages(topics, raw=True):
        message_class = roslib.message.get_message_class(datatype) or class_of_bag
        assert message_class._md5sum == md5sum, '{} was recorded with another {}'.format(topic, datatype)
        yield topic, message_class().deserialize(data), time


def read(path, topic):
    """Return the messages of a topic with their record times."""
    with rosbag.Bag(str(path)) as bag:
        return [(message, time) for _, message, time in messages_of(bag, topic)]


def read_one(path, topic):
    (message, _), = read(path, topic)
    return message


def read_raw(path):
    """Return {topic: [(time in ns, bytes)]}."""
    messages = {}
    with rosbag.Bag(str(path)) as bag:
        for topic, raw, time in bag.read_messages(raw=True):
            messages.setdefault(topic, []).append((time.to_nsec(), raw[1]))
    return messages


def copy_bag(source, target, change):
    """Copy a bag; `change(topic, message)` returns the message to write instead, None for no message."""
    with rosbag.Bag(str(source)) as bag, rosbag.Bag(str(target), 'w') as changed:
        for topic, message, time in messages_of(bag):
            message = change(topic, message)
            if message is not None:
                changed.write(topic, message, time)


def yaw_of(quaternion):
    return math.atan2(2.0 * (quaternion.w * quaternion.z + quaternion.x * quaternion.y),
                      1.0 - 2.0 * (quaternion.y ** 2 + quaternion.z ** 2))


def angle_between(first, second):
    return math.remainder(second - first, 2.0 * math.pi)


def main():
    """Run the tests of the calling script."""
    rosunit.unitrun(PACKAGE, Path(sys.argv[0]).stem, '__main__')
