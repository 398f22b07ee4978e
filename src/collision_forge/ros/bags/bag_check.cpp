#include "collision_forge/ros/bags/bag_check.h"

#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/LaneMap.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/chunked_file.h>
#include <rosbag/constants.h>
#include <rosbag/exceptions.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "collision_forge/ros/bags/bag_error.h"
#include "collision_forge/ros/bags/message_fields.h"

namespace forge {
namespace {

using Fields = std::map<std::string_view, std::string_view>;

/// Thrown for damage of a bag; `problem` completes "the record at byte N ".
struct Damage {
  std::string problem;
};

std::uint32_t numberAt(const char* at) {
  std::uint32_t number = 0;
  std::memcpy(&number, at, sizeof(number));
  return number;
}

/// Removes and returns the block at the front: a length of four bytes, then so many bytes. `what`
/// names it in errors.
std::string_view takeBlock(std::string_view& bytes, const char* what) {
  constexpr std::size_t kLength = sizeof(std::uint32_t);
  if (bytes.size() < kLength) throw Damage{std::string("ends before the length of its ") + what};
  const std::size_t length = numberAt(bytes.data());
  if (length > bytes.size() - kLength) {
    throw Damage{std::string("has a ") + what + " of " + std::to_string(length) +
                 " bytes, more than the " + std::to_string(bytes.size() - kLength) +
                 " that are left"};
  }
  const std::string_view block = bytes.substr(kLength, length);
  bytes.remove_prefix(kLength + length);
  return block;
}

Fields fieldsOf(std::string_view header) {
  Fields fields;
  while (!header.empty()) {
    const std::string_view field = takeBlock(header, "field");
    const std::size_t delimiter = field.find('=');
    if (delimiter == std::string_view::npos) throw Damage{"has a field without a name"};
    fields.emplace(field.substr(0, delimiter), field.substr(delimiter + 1));
  }
  return fields;
}

template <typename Number>
Number numberOf(const Fields& fields, const std::string& name) {
  const auto field = fields.find(name);
  Number number = 0;
  if (field == fields.end() || field->second.size() != sizeof(number)) {
    throw Damage{"has no field " + name};
  }
  std::memcpy(&number, field->second.data(), sizeof(number));
  return number;
}

struct Record {
  explicit Record(std::string_view& bytes)
      : fields(fieldsOf(takeBlock(bytes, "header"))), data(takeBlock(bytes, "content")) {}

  std::uint8_t op() const { return numberOf<std::uint8_t>(fields, rosbag::OP_FIELD_NAME); }

  Fields fields;
  std::string_view data;
};

using Types = std::map<std::string, std::unique_ptr<const MessageFields>, std::less<>>;

/// Returns checkers of messages by md5sum, for the types that this package deserialises: roscpp
/// allocates as many elements as the length of an array says, present or not.
Types readTypes() {
  Types types;
  const auto add = [&](auto message) {
    using Message = decltype(message);
    namespace traits = ros::message_traits;
    types[traits::md5sum<Message>()] = std::make_unique<const MessageFields>(
        traits::datatype<Message>(), traits::definition<Message>(), std::vector<FieldPath>());
  };
  add(collision_forge::AgentArray());
  add(collision_forge::Attack());
  add(collision_forge::AttackRequest());
  add(collision_forge::CollisionReport());
  add(collision_forge::LaneMap());
  add(nav_msgs::Odometry());
  add(tf2_msgs::TFMessage());
  return types;
}

/// Checks the records of one bag from front to back.
class RecordWalk {
 public:
  explicit RecordWalk(std::string_view bag) : bag_(bag) {}

  /// Throws Damage.
  void check() {
    std::string_view rest = bag_.substr(kFirstLine.size());
    std::uint64_t index = 0;
    bool has_index = false;
    while (!rest.empty()) {
      at_ = bag_.size() - rest.size();
      const Record record(rest);
      if (record.op() == rosbag::OP_FILE_HEADER) {
        index = numberOf<std::uint64_t>(record.fields, rosbag::INDEX_POS_FIELD_NAME);
        const auto encryptor = record.fields.find(rosbag::ENCRYPTOR_FIELD_NAME);
        const bool is_encrypted = encryptor != record.fields.end() && !encryptor->second.empty();
        if (index == 0 || is_encrypted) return;
      }
      has_index = has_index || at_ == index;
      checkRecord(record);
    }
    if (!has_index && index != bag_.size()) {
      throw Damage{"is the last; none is at byte " + std::to_string(index) +
                   ", where the index should begin"};
    }
  }

  std::size_t at() const { return at_; }

  static constexpr std::string_view kFirstLine = "#ROSBAG V2.0\n";

 private:
  void checkRecord(const Record& record) {
    switch (record.op()) {
      case rosbag::OP_CHUNK:
        chunks_.push_back(at_);
        checkChunk(record);
        break;
      case rosbag::OP_INDEX_DATA:
        checkIndex(record);
        break;
      case rosbag::OP_CHUNK_INFO:
        if (!std::binary_search(
                chunks_.begin(), chunks_.end(),
                numberOf<std::uint64_t>(record.fields, rosbag::CHUNK_POS_FIELD_NAME))) {
          throw Damage{"refers to a chunk that does not exist"};
        }
        break;
      case rosbag::OP_CONNECTION:
        addConnection(record);
        break;
      default:
        break;
    }
  }

  /// Sets places_ to the offsets in the chunk to which an index may refer.
  void checkChunk(const Record& record) {
    const std::string_view chunk = unpacked(record);
    places_.clear();
    std::size_t followed = 0;  // number of places up to the last message
    for (std::string_view rest = chunk; !rest.empty();) {
      places_.push_back(static_cast<std::uint32_t>(chunk.size() - rest.size()));
      const Record inner(rest);
      if (inner.op() == rosbag::OP_CONNECTION) {
        addConnection(inner);
      } else {
        checkMessage(inner);
        followed = places_.size();
      }
    }
    places_.resize(followed);
  }

  void addConnection(const Record& record) {
    const Fields connection = fieldsOf(record.data);
    const auto md5sum = connection.find("md5sum");
    const auto type = md5sum == connection.end() ? types_.end() : types_.find(md5sum->second);
    connections_[numberOf<std::uint32_t>(record.fields, rosbag::CONNECTION_FIELD_NAME)] =
        type == types_.end() ? nullptr : type->second.get();
  }

  void checkMessage(const Record& record) const {
    const auto connection =
        connections_.find(numberOf<std::uint32_t>(record.fields, rosbag::CONNECTION_FIELD_NAME));
    if (connection == connections_.end() || !connection->second) return;
    try {
      connection->second->read(reinterpret_cast<const std::uint8_t*>(record.data.data()),
                               record.data.size());
    } catch (const BagError& error) {
      throw Damage{std::string("has ") + error.what()};
    }
  }

  std::string_view unpacked(const Record& record) {
    const auto size = numberOf<std::uint32_t>(record.fields, rosbag::SIZE_FIELD_NAME);
    const auto compression = record.fields.find(rosbag::COMPRESSION_FIELD_NAME);
    const std::string_view name = compression == record.fields.end() ? "" : compression->second;
    if (name == rosbag::COMPRESSION_NONE) {
      if (size != record.data.size()) throw Damage{"differs in size from its header"};
      return record.data;
    }
    constexpr std::uint64_t kLargestRatio = 255;  // of LZ4
    const bool is_lz4 = name == rosbag::COMPRESSION_LZ4;
    if (is_lz4 && size > kLargestRatio * record.data.size()) {
      throw Damage{"cannot hold the " + std::to_string(size) + " bytes of its header"};
    }
    if (!is_lz4 && name != rosbag::COMPRESSION_BZ2) throw Damage{"has an unknown compression"};
    unpacked_.reset(new std::uint8_t[size]);
    std::string packed(record.data);  // rosbag takes no constant bytes
    file_.decompress(is_lz4 ? rosbag::compression::LZ4 : rosbag::compression::BZ2, unpacked_.get(),
                     size, reinterpret_cast<std::uint8_t*>(packed.data()),
                     static_cast<unsigned>(packed.size()));
    return {reinterpret_cast<const char*>(unpacked_.get()), size};
  }

  void checkIndex(const Record& record) const {
    constexpr std::size_t kEntry = 12;  // bytes: s, ns, place
    const std::size_t count = numberOf<std::uint32_t>(record.fields, rosbag::COUNT_FIELD_NAME);
    if (record.data.size() != count * kEntry)
      throw Damage{"has another number of entries than its header"};
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t place = numberAt(record.data.data() + i * kEntry + 8);
      if (!std::binary_search(places_.begin(), places_.end(), place)) {
        throw Damage{"refers to byte " + std::to_string(place) +
                     " of its chunk, where no message begins"};
      }
    }
  }

  std::string_view bag_;
  std::size_t at_ = 0;                 ///< byte at which the current record begins
  std::vector<std::uint64_t> chunks_;  ///< their offsets in the file, ascending
  std::vector<std::uint32_t> places_;  ///< offsets in the newest chunk, ascending
  const Types types_ = readTypes();
  std::map<std::uint32_t, const MessageFields*>
      connections_;  ///< null for types that are not checked
  std::unique_ptr<std::uint8_t[]> unpacked_;
  rosbag::ChunkedFile file_;
};

}  // namespace

void checkBag(const std::string& path) {
  namespace ipc = boost::interprocess;
  constexpr std::string_view kAnyBag = "#ROS";
  std::error_code none;
  const auto size = std::filesystem::file_size(path, none);
  std::ifstream stream(path, std::ios::binary);
  if (none || !stream.is_open()) return;
  std::string begin(kAnyBag.size(), '\0');
  if (!stream.read(begin.data(), static_cast<std::streamsize>(begin.size())) || begin != kAnyBag) {
    throw BagError(path + ": is not a ROS bag" + (size == 0 ? ", but empty" : ""));
  }
  if (size <= RecordWalk::kFirstLine.size()) return;
  const ipc::file_mapping file(path.c_str(), ipc::read_only);
  const ipc::mapped_region region(file, ipc::read_only);
  const std::string_view bag(static_cast<const char*>(region.get_address()), region.get_size());
  if (bag.substr(0, RecordWalk::kFirstLine.size()) != RecordWalk::kFirstLine) {
    // rosbag accepts any word after "#ROS", and also reads the older version.
    throw BagError(path + ": is not a bag of version 2.0");
  }
  RecordWalk walk(bag);
  const auto fail = [&](const std::string& problem) {
    throw BagError(path + ": truncated or damaged: the record at byte " +
                   std::to_string(walk.at()) + " " + problem);
  };
  try {
    walk.check();
  } catch (const Damage& damage) {
    fail(damage.problem);
  } catch (const rosbag::BagException& error) {
    fail(std::string("cannot be unpacked: ") + error.what());
  }
}

}  // namespace forge
