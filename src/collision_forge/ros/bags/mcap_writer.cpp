#include "collision_forge/ros/bags/mcap_writer.h"

#include <lz4frame.h>
#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <tuple>
#include <type_traits>

namespace forge {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr char kCompression[] = "lz4";
constexpr std::size_t kChunkSize = 1U << 20U;  // bytes; a chunk of this size or more is written

enum class Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

/// Appends a number, little-endian.
template <typename Integer>
void append(std::string& bytes, Integer value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    bytes.push_back(static_cast<char>(value >> (8 * i) & 0xFFU));
  }
}

void appendText(std::string& bytes, std::string_view text) {
  append(bytes, static_cast<std::uint32_t>(text.size()));
  bytes.append(text);
}

template <typename Key, typename Value>
void appendMap(std::string& bytes, const std::map<Key, Value>& map) {
  std::string entries;
  for (const auto& [key, value] : map) {
    if constexpr (std::is_same_v<Key, std::string>) {
      appendText(entries, key);
      appendText(entries, value);
    } else {
      append(entries, key);
      append(entries, value);
    }
  }
  appendText(bytes, entries);
}

void appendRecord(std::string& bytes, Opcode opcode, std::string_view content) {
  append(bytes, static_cast<std::uint8_t>(opcode));
  append(bytes, static_cast<std::uint64_t>(content.size()));
  bytes.append(content);
}

std::string record(Opcode opcode, std::string_view content) {
  std::string bytes;
  appendRecord(bytes, opcode, content);
  return bytes;
}

std::uint32_t crcOf(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// Returns the bytes as one LZ4 frame.
std::string compressed(const std::string& bytes) {
  LZ4F_preferences_t preferences = LZ4F_INIT_PREFERENCES;
  preferences.frameInfo.blockSizeID = LZ4F_max1MB;
  preferences.frameInfo.contentSize = bytes.size();
  std::string frame(LZ4F_compressFrameBound(bytes.size(), &preferences), '\0');
  const std::size_t size =
      LZ4F_compressFrame(frame.data(), frame.size(), bytes.data(), bytes.size(), &preferences);
  if (LZ4F_isError(size)) throw std::runtime_error(LZ4F_getErrorName(size));
  frame.resize(size);
  return frame;
}

std::string schemaRecord(std::size_t number, const McapSchema& schema) {
  std::string content;
  append(content, static_cast<std::uint16_t>(number));
  appendText(content, schema.name);
  appendText(content, schema.encoding);
  appendText(content, schema.text);
  return record(Opcode::kSchema, content);
}

std::string channelRecord(std::size_t number, const McapChannel& channel) {
  std::string content;
  append(content, static_cast<std::uint16_t>(number));
  append(content, channel.schema);
  appendText(content, channel.topic);
  appendText(content, channel.message_encoding);
  appendMap(content, channel.metadata);
  return record(Opcode::kChannel, content);
}

std::uint16_t checkedNumber(std::size_t number, const char* what) {
  if (number >= std::numeric_limits<std::uint16_t>::max()) {
    throw std::length_error(std::string("MCAP allows at most 65,535 ") + what);
  }
  return static_cast<std::uint16_t>(number);
}

}  // namespace

std::string mcapProfileOf(const std::string& path) {
  constexpr std::size_t kOpcode = kMagic.size();
  constexpr std::size_t kSize = kOpcode + 1 + sizeof(std::uint64_t);
  constexpr std::size_t kText = kSize + sizeof(std::uint32_t);
  constexpr std::size_t kLongest = 64;  // bytes of a profile's name
  std::string begin(kText + kLongest, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  if (begin.size() < kText || begin.compare(0, kMagic.size(), kMagic) != 0 ||
      begin[kOpcode] != static_cast<char>(Opcode::kHeader)) {
    return "";
  }
  const auto length = static_cast<std::uint8_t>(begin[kSize]);
  return length <= kLongest ? begin.substr(kText, length) : "";
}

McapWriter::McapWriter(std::ostream& stream, const std::string& profile, const std::string& library)
    : stream_(stream) {
  put(kMagic);
  std::string content;
  appendText(content, profile);
  appendText(content, library);
  put(record(Opcode::kHeader, content));
}

void McapWriter::put(std::string_view bytes) {
  stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  offset_ += bytes.size();
  crc_ = crcOf(bytes, crc_);
}

std::uint16_t McapWriter::addSchema(McapSchema schema) {
  const auto is_equal = [&](const McapSchema& other) {
    return std::tie(schema.name, schema.encoding, schema.text) ==
           std::tie(other.name, other.encoding, other.text);
  };
  const auto known = std::find_if(schemas_.begin(), schemas_.end(), is_equal);
  if (known != schemas_.end()) return static_cast<std::uint16_t>(known - schemas_.begin() + 1);
  const std::uint16_t number = checkedNumber(schemas_.size(), "schemas") + 1;
  chunk_ += schemaRecord(number, schema);
  schemas_.push_back(std::move(schema));
  return number;
}

std::uint16_t McapWriter::addChannel(McapChannel channel) {
  const std::uint16_t number = checkedNumber(channels_.size(), "channels");
  chunk_ += channelRecord(number, channel);
  channels_.push_back(std::move(channel));
  counts_.push_back(0);
  return number;
}

void McapWriter::write(std::uint16_t channel, std::uint64_t time, std::string_view message) {
  if (places_.empty()) chunk_times_ = {time, time};
  chunk_times_.first = std::min(chunk_times_.first, time);
  chunk_times_.second = std::max(chunk_times_.second, time);
  places_[channel].emplace_back(time, chunk_.size());
  std::string head;
  append(head, channel);
  append(head, counts_[channel]++);  // sequence number
  append(head, time);
  append(head, time);
  append(chunk_, static_cast<std::uint8_t>(Opcode::kMessage));
  append(chunk_, static_cast<std::uint64_t>(head.size() + message.size()));
  chunk_.append(head).append(message);
  if (chunk_.size() >= kChunkSize) writeChunk();
}

void McapWriter::writeChunk() {
  const std::string frame = compressed(chunk_);
  std::string content;
  append(content, chunk_times_.first);
  append(content, chunk_times_.second);
  append(content, static_cast<std::uint64_t>(chunk_.size()));
  append(content, crcOf(chunk_));
  appendText(content, kCompression);
  append(content, static_cast<std::uint64_t>(frame.size()));
  content += frame;
  ChunkEntry entry{chunk_times_, offset_, 0, {}, 0, frame.size(), chunk_.size()};
  put(record(Opcode::kChunk, content));
  entry.length = offset_ - entry.offset;
  writeIndexes(entry);
  chunks_.push_back(std::move(entry));
  chunk_.clear();
  chunk_times_ = {};
  places_.clear();
}

void McapWriter::writeIndexes(ChunkEntry& entry) {
  const std::uint64_t begin = offset_;
  for (const auto& [channel, places] : places_) {
    entry.indexes[channel] = offset_;
    std::string content;
    append(content, channel);
    append(content, static_cast<std::uint32_t>(places.size() * 2 * sizeof(std::uint64_t)));
    for (const auto& [time, place] : places) {
      append(content, time);
      append(content, place);
    }
    put(record(Opcode::kMessageIndex, content));
  }
  entry.indexes_length = offset_ - begin;
}

std::string McapWriter::statistics() const {
  std::map<std::uint16_t, std::uint64_t> counts;
  std::uint64_t messages = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (counts_[i] > 0) counts[static_cast<std::uint16_t>(i)] = counts_[i];
    messages += counts_[i];
  }
  Times times{messages > 0 ? std::numeric_limits<std::uint64_t>::max() : 0, 0};
  for (const ChunkEntry& chunk : chunks_) {
    if (chunk.indexes.empty()) continue;
    times = {std::min(times.first, chunk.times.first), std::max(times.second, chunk.times.second)};
  }
  std::string content;
  append(content, messages);
  append(content, static_cast<std::uint16_t>(schemas_.size()));
  append(content, static_cast<std::uint32_t>(channels_.size()));
  append(content, std::uint32_t{0});  // attachments
  append(content, std::uint32_t{0});  // metadata
  append(content, static_cast<std::uint32_t>(chunks_.size()));
  append(content, times.first);
  append(content, times.second);
  appendMap(content, counts);
  return record(Opcode::kStatistics, content);
}

std::string McapWriter::recordOf(const ChunkEntry& chunk) {
  std::string content;
  append(content, chunk.times.first);
  append(content, chunk.times.second);
  append(content, chunk.offset);
  append(content, chunk.length);
  appendMap(content, chunk.indexes);
  append(content, chunk.indexes_length);
  appendText(content, kCompression);
  append(content, chunk.compressed_size);
  append(content, chunk.size);
  return record(Opcode::kChunkIndex, content);
}

/// Writes the summary; returns the SummaryOffset records of its groups.
std::string McapWriter::writeSummary() {
  std::string offsets;
  const auto put_group = [&](Opcode opcode, const std::string& records) {
    if (records.empty()) return;
    std::string content;
    append(content, static_cast<std::uint8_t>(opcode));
    append(content, offset_);
    append(content, static_cast<std::uint64_t>(records.size()));
    appendRecord(offsets, Opcode::kSummaryOffset, content);
    put(records);
  };
  std::string schemas;
  std::string channels;
  std::string chunks;
  for (std::size_t i = 0; i < schemas_.size(); ++i) schemas += schemaRecord(i + 1, schemas_[i]);
  for (std::size_t i = 0; i < channels_.size(); ++i) channels += channelRecord(i, channels_[i]);
  for (const ChunkEntry& chunk : chunks_) chunks += recordOf(chunk);
  put_group(Opcode::kSchema, schemas);
  put_group(Opcode::kChannel, channels);
  put_group(Opcode::kStatistics, statistics());
  put_group(Opcode::kChunkIndex, chunks);
  return offsets;
}

void McapWriter::finish() {
  if (!chunk_.empty()) writeChunk();
  std::string data_crc;
  append(data_crc, crc_);
  put(record(Opcode::kDataEnd, data_crc));
  crc_ = 0;
  const std::uint64_t summary = offset_;
  const std::string offsets = writeSummary();
  const std::uint64_t summary_offsets = offset_;
  put(offsets);
  std::string footer;
  append(footer, static_cast<std::uint8_t>(Opcode::kFooter));
  append(footer, static_cast<std::uint64_t>(2 * sizeof summary + sizeof crc_));
  append(footer, summary);
  append(footer, summary_offsets);
  put(footer);  // the CRC covers the summary up to here
  std::string summary_crc;
  append(summary_crc, crc_);
  put(summary_crc);
  put(kMagic);
}

}  // namespace forge
