#include "collision_forge/ros/bags/mcap_writer.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "ros/mcap_contents.h"

namespace forge {
namespace {

/// Bit by bit, as the standard has it.
std::uint32_t slowCrc(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0U ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

std::string noise(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::string bytes(size, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

/// Two topics, of one schema each, with messages of 150 kB in turn, every other one a second later.
class McapWriterTest : public testing::Test {
 protected:
  std::string write(int count) {
    std::ostringstream stream;
    McapWriter writer(stream, "ros1", "the test");
    const std::uint16_t numbers = writer.addSchema({"std_msgs/Float64", "ros1msg", "float64 data"});
    const std::uint16_t texts = writer.addSchema({"std_msgs/String", "ros1msg", "string data"});
    const std::uint16_t a = writer.addChannel({numbers, "/a", "ros1", {{"latching", "1"}}});
    const std::uint16_t b = writer.addChannel({texts, "/b", "ros1", {}});
    for (int i = 0; i < count; ++i) {
      const std::string bytes = noise(150000, static_cast<unsigned>(i));
      writer.write(i % 2 == 0 ? a : b, kBegin + static_cast<std::uint64_t>(i / 2) * 1000, bytes);
    }
    writer.finish();
    return stream.str();
  }

  static std::vector<McapRecord> recordsOf(const std::string& file) {
    return mcapRecords(file, kMcapMagic, file.size() - kMcapMagic);
  }
  static std::vector<McapRecord> recordsOf(const std::string& file, int opcode) {
    std::vector<McapRecord> found;
    for (const McapRecord& record : recordsOf(file)) {
      if (record.opcode == opcode) found.push_back(record);
    }
    return found;
  }

  static constexpr std::uint64_t kBegin = 1'500'000'000'123'456'789U;  // ns
};

TEST_F(McapWriterTest, EveryMessageIsReadBackWithItsChannel) {
  const McapContents contents(write(20));
  ASSERT_EQ(contents.messages().size(), 20U);
  for (unsigned i = 0; i < 20; ++i) {
    const McapMessage& message = contents.messages()[i];
    EXPECT_EQ(message.bytes, noise(150000, i));
    EXPECT_EQ(message.log_time, kBegin + i / 2 * 1000);
    EXPECT_EQ(message.publish_time, message.log_time);
    EXPECT_EQ(message.sequence, i / 2) << "counted for each channel";
    EXPECT_EQ(message.topic, i % 2 == 0 ? "/a" : "/b");
    EXPECT_EQ(message.schema, i % 2 == 0 ? "std_msgs/Float64" : "std_msgs/String");
    EXPECT_EQ(message.definition, i % 2 == 0 ? "float64 data" : "string data");
    EXPECT_EQ(message.metadata.count("latching"), i % 2 == 0 ? 1U : 0U);
  }
}

TEST_F(McapWriterTest, CrcsCoverChunksDataAndSummary) {
  const std::string file = write(9);
  for (const McapRecord& record : recordsOf(file, 0x06)) {
    const McapChunk chunk = mcapChunk(record);
    EXPECT_EQ(chunk.crc, slowCrc(chunk.records));
  }
  const McapRecord data_end = recordsOf(file, 0x0F).at(0);
  EXPECT_EQ(McapFields(data_end.content).number<std::uint32_t>(),
            slowCrc(std::string_view(file).substr(0, data_end.offset)));
  McapFields footer(recordsOf(file).back().content);
  const auto summary = static_cast<std::size_t>(footer.number<std::uint64_t>());
  footer.number<std::uint64_t>();
  EXPECT_EQ(summary, data_end.offset + kMcapHead + 4);
  const std::string_view checked =
      std::string_view(file).substr(summary, file.size() - kMcapMagic - 4 - summary);
  EXPECT_EQ(footer.number<std::uint32_t>(), slowCrc(checked));
}

/// Follows a message index into its chunk; returns how many messages of that channel it finds.
std::size_t followIndex(const McapRecord& index, std::uint16_t channel, const McapChunk& chunk) {
  std::size_t count = 0;
  McapFields fields(index.content);
  EXPECT_EQ(index.opcode, 0x07);
  EXPECT_EQ(fields.number<std::uint16_t>(), channel);
  for (McapFields place(fields.text()); !place.isAtEnd(); ++count) {
    const auto time = place.number<std::uint64_t>();
    const auto offset = static_cast<std::size_t>(place.number<std::uint64_t>());
    const McapRecord message = mcapRecordAt(chunk.records, offset);
    McapFields found(message.content);
    EXPECT_EQ(message.opcode, 0x05);
    EXPECT_EQ(found.number<std::uint16_t>(), channel);
    found.number<std::uint32_t>();  // its place in the sequence
    EXPECT_EQ(found.number<std::uint64_t>(), time);
  }
  return count;
}

/// Follows a chunk index to its chunk and on; returns how many messages it finds.
std::size_t followChunkIndex(const std::string& file, const McapRecord& record) {
  McapFields fields(record.content);
  const auto begin = fields.number<std::uint64_t>();
  const auto end = fields.number<std::uint64_t>();
  const auto offset = static_cast<std::size_t>(fields.number<std::uint64_t>());
  const auto length = static_cast<std::size_t>(fields.number<std::uint64_t>());
  const McapRecord chunk_record = mcapRecordAt(file, offset);
  EXPECT_EQ(chunk_record.opcode, 0x06);
  EXPECT_EQ(chunk_record.content.size() + kMcapHead, length);
  const McapChunk chunk = mcapChunk(chunk_record);
  EXPECT_EQ(std::pair(begin, end), std::pair(chunk.begin, chunk.end));
  std::size_t count = 0;
  std::size_t next = offset + length;
  for (McapFields entry(fields.text()); !entry.isAtEnd();) {
    const auto channel = entry.number<std::uint16_t>();
    EXPECT_EQ(entry.number<std::uint64_t>(), next) << "one after the other behind the chunk";
    const McapRecord index = mcapRecordAt(file, next);
    next += index.content.size() + kMcapHead;
    count += followIndex(index, channel, chunk);
  }
  EXPECT_EQ(fields.number<std::uint64_t>(), next - offset - length);
  EXPECT_EQ(fields.text(), "lz4");
  fields.number<std::uint64_t>();  // compressed size
  EXPECT_EQ(fields.number<std::uint64_t>(), chunk.records.size());
  return count;
}

TEST_F(McapWriterTest, IndexesLeadToTheirMessages) {
  const std::string file = write(20);
  std::size_t messages = 0;
  for (const McapRecord& record : recordsOf(file, 0x08)) messages += followChunkIndex(file, record);
  EXPECT_EQ(messages, 20U);
}

}  // namespace
}  // namespace forge
