"""usage: ros2_export_checks.py BAG MCAP ROSBAG2: counts of messages that other readers find equal, as JSON.

For an environment of their own, without ROS. BAG is of ROS 1, read by rosbags; MCAP of profile ros2, read by mcap and
mcap-ros2-support; ROSBAG2 a folder, read by rosbags. Fields of ROS 2 that ROS 1 lacks must have their default values.
"""
import json
import sys
from pathlib import Path

import numpy
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_typestore

ADDED = {'texture_resource', 'texture', 'uv_coordinates', 'mesh_file'}  # of visualization_msgs/Marker


def plain(value):
    """A decoded message of any reader as lists, dictionaries, numbers and texts."""
    if isinstance(value, numpy.ndarray):
        return value.tolist()
    if isinstance(value, (bytes, bytearray)):
        return list(value)
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    fields = getattr(value, '__dataclass_fields__', None) or getattr(value, '__slots__', None)
    if fields is None:
        return value
    fields = [name for name in fields if not (name.isupper() and len(name) > 1)]  # without constants
    return {name.lower(): plain(getattr(value, name)) for name in fields
            if not name.startswith('_') and name not in ('seq', 'structure_needs_at_least_one_member')}


def is_default(value):
    if isinstance(value, dict):
        return all(map(is_default, value.values()))
    return not value


def is_equal(old, new):
    if isinstance(old, dict):
        added = set(new) - set(old)
        return (set(old) <= set(new) and added <= ADDED and all(is_default(new[name]) for name in added)
                and all(is_equal(old[name], new[name]) for name in old))
    if isinstance(old, list):
        return len(old) == len(new) and all(map(is_equal, old, new))
    return old == new or (old != old and new != new)


def messages_of(path, store=None):
    """Return [topic, time, message] of each message, in the order of time and topic."""
    with AnyReader([Path(path)], default_typestore=store) as reader:
        found = [(connection.topic, time, plain(reader.deserialize(data, connection.msgtype)))
                 for connection, time, data in reader.messages()]
    return sorted(found, key=lambda message: (message[1], message[0]))


def mcap_messages_of(path):
    with open(path, 'rb') as stream:
        reader = make_reader(stream, validate_crcs=True, decoder_factories=[DecoderFactory()])
        return sorted(((channel.topic, message.log_time, plain(decoded))
                       for _, channel, message, decoded in reader.iter_decoded_messages()),
                      key=lambda message: (message[1], message[0]))


def counts(old, new):
    """Return numbers of the messages in the bag, of those found in `new`, and of the equal ones."""
    topics = {message[0] for message in old}
    new = [message for message in new if message[0] in topics]
    return [len(old), len(new), sum(a[:2] == b[:2] and is_equal(a[2], b[2]) for a, b in zip(old, new))]


if __name__ == '__main__':
    bag = messages_of(sys.argv[1], get_typestore(Stores.EMPTY))
    json.dump({'mcap': counts(bag, mcap_messages_of(sys.argv[2])),
               'rosbag2': counts(bag, messages_of(sys.argv[3]))}, sys.stdout)
