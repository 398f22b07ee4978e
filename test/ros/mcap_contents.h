#pragma once

#include <lz4frame.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// MCAP files as a reader sees them that goes through them from begin to end.
namespace forge {

inline constexpr std::size_t kMcapMagic = 8;  // bytes
inline constexpr std::size_t kMcapHead = 9;   // bytes, of a record: opcode and length

/// The fields of a record, one after the other.
class McapFields {
 public:
  explicit McapFields(std::string bytes) : bytes_(std::move(bytes)) {}

  template <typename Integer>
  Integer number() {
    const std::string taken = take(sizeof(Integer));
    Integer value = 0;
    for (std::size_t i = taken.size(); i-- > 0;) {
      value = static_cast<Integer>((value << 7U << 1U) | static_cast<std::uint8_t>(taken[i]));
    }
    return value;
  }
  std::string text() { return take(number<std::uint32_t>()); }
  std::map<std::string, std::string> texts() {
    std::map<std::string, std::string> map;
    for (McapFields fields(text()); !fields.isAtEnd();) {
      const std::string key = fields.text();
      map[key] = fields.text();
    }
    return map;
  }
  std::string rest() { return take(bytes_.size() - place_); }
  bool isAtEnd() const { return place_ == bytes_.size(); }

 private:
  std::string take(std::size_t count) {
    if (count > bytes_.size() - place_) throw std::out_of_range("a field goes beyond its record");
    place_ += count;
    return bytes_.substr(place_ - count, count);
  }

  std::string bytes_;
  std::size_t place_ = 0;
};

struct McapRecord {
  int opcode = 0;
  std::size_t offset = 0;
  std::string content;
};

inline McapRecord mcapRecordAt(const std::string& bytes, std::size_t offset) {
  McapFields fields(bytes.substr(offset, kMcapHead));
  const int opcode = fields.number<std::uint8_t>();
  const auto length = static_cast<std::size_t>(fields.number<std::uint64_t>());
  if (length > bytes.size() - offset - kMcapHead) throw std::out_of_range("a record is cut off");
  return {opcode, offset, bytes.substr(offset + kMcapHead, length)};
}

/// All records from an offset to another.
inline std::vector<McapRecord> mcapRecords(const std::string& bytes, std::size_t begin,
                                           std::size_t end) {
  std::vector<McapRecord> records;
  while (begin < end) {
    records.push_back(mcapRecordAt(bytes, begin));
    begin += kMcapHead + records.back().content.size();
  }
  return records;
}

struct McapChunk {
  std::uint64_t begin = 0;  ///< ns
  std::uint64_t end = 0;
  std::uint32_t crc = 0;
  std::string records;  ///< uncompressed
};

inline std::string lz4Content(const std::string& frame, std::size_t size) {
  LZ4F_dctx* context = nullptr;
  LZ4F_createDecompressionContext(&context, LZ4F_VERSION);
  std::string content(size, '\0');
  std::size_t written = size;
  std::size_t read = frame.size();
  const std::size_t left =
      LZ4F_decompress(context, content.data(), &written, frame.data(), &read, nullptr);
  LZ4F_freeDecompressionContext(context);
  if (left != 0 || written != size || read != frame.size()) {
    throw std::runtime_error("a chunk is not one whole LZ4 frame of its size");
  }
  return content;
}

inline McapChunk mcapChunk(const McapRecord& record) {
  McapFields fields(record.content);
  McapChunk chunk;
  chunk.begin = fields.number<std::uint64_t>();
  chunk.end = fields.number<std::uint64_t>();
  const auto size = static_cast<std::size_t>(fields.number<std::uint64_t>());
  chunk.crc = fields.number<std::uint32_t>();
  if (fields.text() != "lz4") throw std::runtime_error("a chunk is compressed in another way");
  if (fields.number<std::uint64_t>() != record.content.size() - 8 * 3 - 4 - 4 - 3 - 8) {
    throw std::runtime_error("a chunk has another compressed size");
  }
  chunk.records = lz4Content(fields.rest(), size);
  return chunk;
}

/// A message with all that is known of its channel.
struct McapMessage {
  std::string topic;
  std::string schema;
  std::string schema_encoding;
  std::string definition;
  std::string encoding;
  std::map<std::string, std::string> metadata;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;  ///< ns, as is the next
  std::uint64_t publish_time = 0;
  std::string bytes;
};

/// Reads the messages in the order in which they are in the file.
class McapContents {
 public:
  explicit McapContents(const std::string& file) {
    for (const McapRecord& record : mcapRecords(file, kMcapMagic, file.size() - kMcapMagic)) {
      if (record.opcode == 0x0F) break;
      if (record.opcode != 0x06) continue;
      const std::string records = mcapChunk(record).records;
      for (const McapRecord& inner : mcapRecords(records, 0, records.size())) take(inner);
    }
  }

  const std::vector<McapMessage>& messages() const { return messages_; }
  std::vector<McapMessage> of(const std::string& topic) const {
    std::vector<McapMessage> found;
    for (const McapMessage& message : messages_) {
      if (message.topic == topic) found.push_back(message);
    }
    return found;
  }

 private:
  void take(const McapRecord& record) {
    McapFields fields(record.content);
    if (record.opcode == 0x03) {
      McapMessage& schema = schemas_[fields.number<std::uint16_t>()];
      schema.schema = fields.text();
      schema.schema_encoding = fields.text();
      schema.definition = fields.text();
    } else if (record.opcode == 0x04) {
      const auto number = fields.number<std::uint16_t>();
      McapMessage& channel = channels_[number] = schemas_.at(fields.number<std::uint16_t>());
      channel.topic = fields.text();
      channel.encoding = fields.text();
      channel.metadata = fields.texts();
    } else if (record.opcode == 0x05) {
      messages_.push_back(channels_.at(fields.number<std::uint16_t>()));
      McapMessage& message = messages_.back();
      message.sequence = fields.number<std::uint32_t>();
      message.log_time = fields.number<std::uint64_t>();
      message.publish_time = fields.number<std::uint64_t>();
      message.bytes = fields.rest();
    }
  }

  std::map<std::uint16_t, McapMessage> schemas_;  ///< their fields alone
  std::map<std::uint16_t, McapMessage> channels_;
  std::vector<McapMessage> messages_;
};

}  // namespace forge
