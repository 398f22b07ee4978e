"""usage: mcap_checks.py FILE: what the packages mcap and mcap-ros1-support find in an MCAP file, as JSON.

For an environment of their own, without ROS. Every message is decoded; the CRCs of the chunks, of the data and of the
summary are checked. Messages are told in the order of their time.
"""
import hashlib
import json
import struct
import sys
import zlib

from mcap.reader import make_reader
from mcap.stream_reader import StreamReader
from mcap_ros1.decoder import DecoderFactory

FOOTER = 1 + 8 + 20 + 8  # bytes: opcode, length, content, magic
SHOWN = ('/collision_forge/scene', '/collision_forge/map')


def plain(value):
    """A decoded message as lists, dictionaries and numbers; times in nanoseconds."""
    if hasattr(value, 'to_nsec'):
        return value.to_nsec()
    if hasattr(value, '__slots__'):
        return {name: plain(getattr(value, name)) for name in value.__slots__}
    return [plain(item) for item in value] if isinstance(value, (list, tuple)) else value


def summary_crc(data):
    """Return the checksums (in the footer, computed)."""
    start, _, crc = struct.unpack_from('<QQI', data, len(data) - FOOTER + 9)
    return crc, zlib.crc32(data[start:len(data) - 8 - 4])


def read(path):
    with open(path, 'rb') as file:
        records = [type(record).__name__ for record in StreamReader(file, validate_crcs=True).records]
    with open(path, 'rb') as file:
        data = file.read()
    messages, shown, numbers = [], [], {}
    with open(path, 'rb') as file:
        reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
        header, summary = reader.get_header(), reader.get_summary()
        for schema, channel, message, decoded in reader.iter_decoded_messages():
            messages.append([channel.topic, message.log_time, message.publish_time, message.sequence, channel.id,
                             hashlib.sha256(message.data).hexdigest()])
            if channel.topic in SHOWN:
                shown.append([channel.topic, message.log_time, plain(decoded)])
            if schema.name == 'std_msgs/Float64':
                numbers.setdefault(channel.topic, []).append([message.log_time, decoded.data])
        middle = (messages[0][1] + messages[-1][1]) // 2
        late = [channel.topic for _, channel, _ in reader.iter_messages(topics=['/tf'], starting_at=middle)]
    statistics = summary.statistics
    return {
        'profile': header.profile, 'records': records, 'summary_crc': summary_crc(data), 'messages': messages,
        'shown': shown, 'numbers': numbers, 'middle': middle, 'late': len(late),
        'statistics': {'messages': statistics.message_count, 'schemas': statistics.schema_count,
                       'channels': statistics.channel_count, 'chunks': statistics.chunk_count,
                       'start': statistics.message_start_time, 'end': statistics.message_end_time,
                       'counts': statistics.channel_message_counts},
        'channels': [[channel.id, channel.topic, channel.message_encoding, channel.metadata,
                      summary.schemas[channel.schema_id].name, summary.schemas[channel.schema_id].encoding,
                      summary.schemas[channel.schema_id].data.decode()] for channel in summary.channels.values()],
        'chunks': [[chunk.message_start_time, chunk.message_end_time, chunk.compression, chunk.compressed_size,
                    chunk.uncompressed_size] for chunk in summary.chunk_indexes],
    }


if __name__ == '__main__':
    json.dump(read(sys.argv[1]), sys.stdout)
