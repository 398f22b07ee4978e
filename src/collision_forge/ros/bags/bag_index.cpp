#include "collision_forge/ros/bags/bag_index.h"

#include <cstdint>
#include <fstream>
#include <map>

namespace forge {
namespace {

constexpr char kFirstLine[] = "#ROSBAG V2.0";  // older bags have no such index
constexpr char kChunkInfo = 0x06;              // value of the field `op` of its records

using Fields = std::map<std::string, std::string>;

/// Little-endian, as all numbers of a bag; 0 where there are too few bytes.
template <typename Integer>
Integer numberIn(const std::string& bytes) {
  Integer number = 0;
  for (std::size_t i = 0; i < sizeof number && bytes.size() >= sizeof number; ++i) {
    number |= static_cast<Integer>(static_cast<std::uint8_t>(bytes[i])) << (8 * i);
  }
  return number;
}

std::string take(std::istream& stream, std::uint32_t count) {
  std::string bytes(count, '\0');
  stream.read(bytes.data(), count);
  return bytes;
}

std::string takeBlock(std::istream& stream) {
  return take(stream, numberIn<std::uint32_t>(take(stream, sizeof(std::uint32_t))));
}

/// The header of a record: blocks of NAME=VALUE.
Fields takeHeader(std::istream& stream) {
  const std::string header = takeBlock(stream);
  Fields fields;
  for (std::size_t place = 0; place + sizeof(std::uint32_t) <= header.size();) {
    const auto length = numberIn<std::uint32_t>(header.substr(place, sizeof(std::uint32_t)));
    const std::string field = header.substr(place + sizeof(std::uint32_t), length);
    const std::size_t equals = field.find('=');
    if (equals == std::string::npos) break;
    fields[field.substr(0, equals)] = field.substr(equals + 1);
    place += sizeof(std::uint32_t) + length;
  }
  return fields;
}

}  // namespace

bool hasMessageAtZero(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  std::getline(file, line);
  if (line != kFirstLine) return false;
  const auto index = numberIn<std::uint64_t>(takeHeader(file)["index_pos"]);
  file.seekg(static_cast<std::streamoff>(index));
  while (file.peek() != std::ifstream::traits_type::eof()) {
    Fields header = takeHeader(file);
    takeBlock(file);  // data
    const bool is_chunk = header["op"] == std::string(1, kChunkInfo);
    const bool has_messages = numberIn<std::uint32_t>(header["count"]) > 0;
    if (is_chunk && has_messages && numberIn<std::uint64_t>(header["start_time"]) == 0) return true;
  }
  return false;
}

}  // namespace forge
