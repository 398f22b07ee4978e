#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forge {

/// Encoding names in MCAP's profile ros1: of messages and of their definitions.
inline constexpr char kRos1Encoding[] = "ros1";
inline constexpr char kRos1Definition[] = "ros1msg";
/// The same in profile ros2.
inline constexpr char kRos2Encoding[] = "cdr";
inline constexpr char kRos2Definition[] = "ros2msg";

/// Definition of a message type.
struct McapSchema {
  std::string name;      ///< for ROS 1: package/Type; for ROS 2: package/msg/Type
  std::string encoding;  ///< for example kRos1Definition
  std::string text;      ///< definition in this encoding
};

/// A topic of the file.
struct McapChannel {
  std::uint16_t schema = 0;      ///< number returned by addSchema()
  std::string topic;             ///< name of the topic
  std::string message_encoding;  ///< for example kRos1Encoding
  /// For ROS 1 the header of the connection, for ROS 2 "offered_qos_profiles".
  std::map<std::string, std::string> metadata;
};

/// Returns the profile in the header of an MCAP file, such as "ros1" or "ros2"; empty if the file
/// does not exist or is not an MCAP file, and for a profile of more than 64 bytes.
std::string mcapProfileOf(const std::string& path);

/// Writes an MCAP file (mcap.dev/spec): messages in chunks, each an LZ4 frame, with their indexes,
/// and a summary with its offsets. A CRC-32 covers each chunk, the data and the summary. Keeps one
/// chunk (about 1 MiB) and the summary in memory. The caller checks the stream for write errors.
class McapWriter {
 public:
  /// Writes the header. `stream` must be binary, at the beginning of a file, and outlive the
  /// object. `profile`: "ros1" or "ros2"; `library`: name of the writing program, for people.
  McapWriter(std::ostream& stream, const std::string& profile, const std::string& library);

  /// Adds a schema, unless an equal one exists, and returns its number, from 1. Throws
  /// std::length_error after 65,535 schemas.
  std::uint16_t addSchema(McapSchema schema);
  /// Adds a channel, also if an equal one exists, and returns its number, from 0. Throws like
  /// addSchema().
  std::uint16_t addChannel(McapChannel channel);

  /// Writes the bytes `message` to the channel with the number `channel` (addChannel()). `time`:
  /// ns, both publish and log time; may decrease from call to call. Throws std::runtime_error if
  /// LZ4 fails.
  void write(std::uint16_t channel, std::uint64_t time, std::string_view message);

  /// Writes the last chunk and the summary. Must be called once, as the last call.
  void finish();

 private:
  /// Index of messages: time (ns) and offset (bytes) in the uncompressed chunk.
  using MessagePlaces = std::vector<std::pair<std::uint64_t, std::uint64_t>>;
  using Times = std::pair<std::uint64_t, std::uint64_t>;  ///< ns, earliest and latest message time

  /// Index of a written chunk, for the summary.
  struct ChunkEntry {
    Times times;               ///< 0 for a chunk without messages
    std::uint64_t offset = 0;  ///< of the chunk's record in the file, bytes
    std::uint64_t length = 0;  ///< of the chunk's record, bytes
    /// Offsets in the file, bytes, of the message index records, by channel.
    std::map<std::uint16_t, std::uint64_t> indexes;
    std::uint64_t indexes_length = 0;   ///< bytes of all message index records
    std::uint64_t compressed_size = 0;  ///< bytes of the LZ4 frame
    std::uint64_t size = 0;             ///< bytes of the uncompressed chunk
  };

  void put(std::string_view bytes);  ///< writes bytes to the stream
  void writeChunk();                 ///< writes `chunk_` with its indexes and begins a new one
  /// Writes the message indexes of the current chunk and stores their offsets in `entry`.
  void writeIndexes(ChunkEntry& entry);
  std::string statistics() const;                        ///< the Statistics record
  static std::string recordOf(const ChunkEntry& chunk);  ///< a ChunkIndex record
  /// Writes the summary section; returns its SummaryOffset records.
  std::string writeSummary();

  std::ostream& stream_;
  std::uint64_t offset_ = 0;  ///< bytes written
  std::uint32_t crc_ = 0;     ///< CRC-32 of the bytes since the section (data, summary) began
  std::vector<McapSchema> schemas_;                ///< index: number - 1
  std::vector<McapChannel> channels_;              ///< index: number
  std::vector<std::uint32_t> counts_;              ///< number of messages, by channel
  std::string chunk_;                              ///< records of the current chunk
  Times chunk_times_;                              ///< of the messages in the current chunk
  std::map<std::uint16_t, MessagePlaces> places_;  ///< in the current chunk, by channel
  std::vector<ChunkEntry> chunks_;
};

}  // namespace forge
