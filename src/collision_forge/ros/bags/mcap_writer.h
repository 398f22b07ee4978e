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

/// Name of the message encoding and of the schema encoding in MCAP's profile ros1.
inline constexpr char kRos1Encoding[] = "ros1";
inline constexpr char kRos1Definition[] = "ros1msg";

struct McapSchema {
  std::string name;
  std::string encoding;
  std::string text;
};

struct McapChannel {
  std::uint16_t schema = 0;  ///< as addSchema() returned it
  std::string topic;
  std::string message_encoding;
  std::map<std::string, std::string> metadata;
};

/// Writes an MCAP file (mcap.dev/spec): messages in chunks, each an LZ4 frame, with their indexes,
/// and a summary with its offsets. A CRC-32 covers each chunk, the data and the summary. Holds one
/// chunk and what the summary needs. Write errors stay in the stream.
class McapWriter {
 public:
  /// `stream` is binary, at the begin of a file, and outlives this.
  McapWriter(std::ostream& stream, const std::string& profile, const std::string& library);

  /// Returns the schema's number, from 1; an equal schema's number if it exists. Throws
  /// std::length_error beyond 65,535 schemas.
  std::uint16_t addSchema(McapSchema schema);
  /// Returns the channel's number, from 0. Throws as addSchema().
  std::uint16_t addChannel(McapChannel channel);

  /// `time` in nanoseconds, when the message was sent and recorded. Times may go back.
  void write(std::uint16_t channel, std::uint64_t time, std::string_view message);

  /// Ends the file; to be called once, last.
  void finish();

 private:
  /// Time, ns, and offset in the uncompressed chunk of each message.
  using MessagePlaces = std::vector<std::pair<std::uint64_t, std::uint64_t>>;
  using Times = std::pair<std::uint64_t, std::uint64_t>;  ///< of messages, the first and the last

  struct ChunkEntry {
    Times times;
    std::uint64_t offset = 0;                        ///< of its record in the file
    std::uint64_t length = 0;                        ///< of its record
    std::map<std::uint16_t, std::uint64_t> indexes;  ///< where those of its channels are
    std::uint64_t indexes_length = 0;
    std::uint64_t compressed_size = 0;
    std::uint64_t size = 0;
  };

  void put(std::string_view bytes);
  void writeChunk();
  void writeIndexes(ChunkEntry& entry);
  std::string statistics() const;
  static std::string recordOf(const ChunkEntry& chunk);
  std::string writeSummary();

  std::ostream& stream_;
  std::uint64_t offset_ = 0;  ///< bytes written
  std::uint32_t crc_ = 0;     ///< of these, since the last section began
  std::vector<McapSchema> schemas_;
  std::vector<McapChannel> channels_;
  std::vector<std::uint32_t> counts_;  ///< messages of each channel
  std::string chunk_;                  ///< records of the one that is being filled
  Times chunk_times_;
  std::map<std::uint16_t, MessagePlaces> places_;  ///< in that chunk, by channel
  std::vector<ChunkEntry> chunks_;
};

}  // namespace forge
