#include "collision_forge/ros/bags/ros2_message.h"

#include <ros/serialization.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "collision_forge/ros/bags/bag_error.h"

namespace forge {
namespace {

using Shape = MessageField::Shape;

constexpr char kHeader[] = "std_msgs/Header";
constexpr char kTypeLine[] = "MSG: ";
constexpr char kRos1Package[] = "collision_forge/";

/// A nested type that a converted definition may need.
struct NestedType {
  const char* name;
  const char* fields;
};
// common_interfaces and rcl_interfaces, branch humble.
constexpr NestedType kNestedTypes[] = {
    {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
    {"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"},
    {"sensor_msgs/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n"},
    {"visualization_msgs/UVCoordinate", "float32 u\nfloat32 v\n"},
    {"visualization_msgs/MeshFile", "string filename\nuint8[] data\n"}};

/// Fields of a type that ROS 2 adds after one of ROS 1.
struct AddedFields {
  const char* type;
  const char* after;
  const char* fields;
};
// visualization_msgs/Marker.msg, common_interfaces, branch humble.
constexpr AddedFields kAddedFields[] = {
    {"visualization_msgs/Marker", "colors",
     "string texture_resource\nsensor_msgs/CompressedImage texture\n"
     "visualization_msgs/UVCoordinate[] uv_coordinates\n"},
    {"visualization_msgs/Marker", "mesh_resource", "visualization_msgs/MeshFile mesh_file\n"}};

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return std::tolower(letter); });
  return text;
}

/// Returns package/Type of a ROS 1 type in ROS 2.
std::string renamed(const std::string& type) {
  if (type == "tf/tfMessage") return "tf2_msgs/TFMessage";
  if (type.rfind(kRos1Package, 0) != 0) return type;
  return std::string(kRos2Package) + type.substr(type.find('/'));
}

/// Returns the type of a field, such as "time[]", in ROS 2.
std::string fieldType(const std::string& written) {
  const std::size_t bracket = std::min(written.find('['), written.size());
  const std::string type = written.substr(0, bracket);
  const std::string array = written.substr(bracket);
  if (type == "Header") return kHeader + array;
  if (type == "time") return "builtin_interfaces/Time" + array;
  if (type == "duration") return "builtin_interfaces/Duration" + array;
  return renamed(type) + array;
}

/// Returns a line with a field or a constant of `owner` in ROS 2, with the fields that follow it.
std::string converted(const std::string& line, const std::string& owner) {
  const std::string code = line.substr(0, line.find('#'));
  std::istringstream words(code);
  std::string type;
  std::string name;
  if (!(words >> type >> name)) return line + "\n";
  const std::size_t equals = code.find('=');
  if (equals != std::string::npos) {
    if (type != "string") return line + "\n";
    // A string constant extends to the end of the line; ROS 2 needs quotes.
    const std::string value = line.substr(equals + 1);
    std::string quoted;
    for (const char letter : value) {
      if (letter == '"' || letter == '\\') quoted += '\\';
      quoted += letter;
    }
    return line.substr(0, equals + 1) + '"' + quoted + "\"\n";
  }
  if (owner == kHeader && name == "seq") return "";
  std::string lines = fieldType(type) + " " + lowerCase(name) + line.substr(code.size()) + "\n";
  if (code.size() < line.size()) lines.insert(lines.find('#'), "  ");
  for (const AddedFields& added : kAddedFields) {
    if (owner == added.type && name == added.after) lines += added.fields;
  }
  return lines;
}

std::string separator() { return std::string(80, '=') + "\n"; }

/// Returns a ROS 1 definition as ros2msg.
std::string ros2Text(const std::string& type, const std::string& definition) {
  std::string text;
  std::string owner = type;
  std::istringstream lines(definition);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.rfind(kTypeLine, 0) == 0) {
      owner = line.substr(sizeof kTypeLine - 1);
      text += kTypeLine + renamed(owner) + "\n";
    } else if (line.rfind("====", 0) == 0) {
      text += separator();
    } else {
      text += converted(line, owner);
    }
  }
  for (const NestedType& nested : kNestedTypes) {
    const std::string name = nested.name;
    if (text.find(name) == std::string::npos) continue;
    if (text.find(kTypeLine + name + "\n") != std::string::npos) continue;
    text += separator() + kTypeLine + name + "\n" + nested.fields;
  }
  return text;
}

/// Writes CDR; alignment counts from the end of the encapsulation header.
class CdrWriter {
 public:
  void align(std::size_t size) {
    while ((bytes_.size() - kHeaderSize) % size != 0) bytes_.push_back('\0');
  }
  void put(const std::uint8_t* data, std::size_t size) {
    bytes_.append(reinterpret_cast<const char*>(data), size);
  }
  void putZeros(std::size_t count) { bytes_.append(count, '\0'); }
  void putLength(std::uint32_t length) {
    align(sizeof length);
    put(reinterpret_cast<const std::uint8_t*>(&length), sizeof length);
  }
  std::string take() { return std::move(bytes_); }

 private:
  static constexpr std::size_t kHeaderSize = 4;
  std::string bytes_ = std::string("\0\1\0\0", kHeaderSize);  // CDR_LE, no options
};

std::size_t alignmentOf(const MessageField& field) {
  return field.builtin == BuiltinType::kString ? sizeof(std::uint32_t) : field.min_size;
}

void writeDefault(const MessageField& field, CdrWriter& out);

void writeDefaults(const MessageType& type, CdrWriter& out) {
  for (const MessageField& field : type.fields) writeDefault(field, out);
}

void writeDefault(const MessageField& field, CdrWriter& out) {
  if (field.shape == Shape::kArray) {
    out.putLength(0);
    return;
  }
  for (std::size_t i = 0; i < field.count; ++i) {
    if (field.message != nullptr) {
      writeDefaults(*field.message, out);
    } else if (field.builtin == BuiltinType::kString) {
      out.putLength(1);
      out.putZeros(1);
    } else {
      out.align(field.min_size);
      out.putZeros(field.min_size);
    }
  }
}

}  // namespace

/// Converts one message.
class Ros2Message::Conversion {
 public:
  explicit Conversion(std::string_view bytes)
      : in_(reinterpret_cast<std::uint8_t*>(const_cast<char*>(bytes.data())),
            static_cast<std::uint32_t>(bytes.size())) {}

  void convert(const Plan& plan) {
    bool is_empty = true;
    for (const Move& move : plan) {
      if (move.from == nullptr) {
        writeDefault(*move.to, out_);
      } else if (move.to == nullptr) {
        in_.advance(static_cast<std::uint32_t>(move.from->min_size));
        continue;
      } else {
        convert(move);
      }
      is_empty = false;
    }
    if (is_empty) out_.putZeros(1);  // a struct without fields has a byte
  }

  std::string finish(const std::string& type) {
    if (in_.getLength() == 0) return out_.take();
    throw BagError(type + ": a message has " + std::to_string(in_.getLength()) +
                   " bytes more than its fields");
  }

 private:
  void convert(const Move& move) {
    const MessageField& field = *move.from;
    std::size_t count = field.count;
    if (field.shape == Shape::kArray) {
      std::uint32_t length = 0;
      in_.next(length);
      out_.putLength(length);
      count = length;
    }
    // Elements without bytes would allow 4 billion in an array of 4 bytes.
    if (count > in_.getLength() && field.min_size == 0) ros::serialization::throwStreamOverrun();
    if (field.message != nullptr) {
      for (std::size_t i = 0; i < count; ++i) convert(*move.nested);
    } else if (field.builtin == BuiltinType::kString) {
      for (std::size_t i = 0; i < count; ++i) convertText();
    } else if (count > 0) {
      const bool is_time = move.to->message != nullptr;  // two numbers of 4 bytes
      out_.align(is_time ? sizeof(std::uint32_t) : alignmentOf(field));
      const std::size_t size = count * field.min_size;
      if (size > in_.getLength()) ros::serialization::throwStreamOverrun();
      out_.put(in_.advance(static_cast<std::uint32_t>(size)), size);
    }
  }

  void convertText() {
    std::uint32_t length = 0;
    in_.next(length);
    const std::uint8_t* const text = in_.advance(length);
    out_.putLength(length + 1);
    out_.put(text, length);
    out_.putZeros(1);
  }

  ros::serialization::IStream in_;
  CdrWriter out_;
};

Ros2Message::Ros2Message(const std::string& type, const std::string& definition)
    : text_(ros2Text(type, definition)), from_(type, definition) {
  const std::string name = renamed(type);
  to_ = std::make_unique<const MessageDefinition>(name, text_);
  const std::size_t slash = name.find('/');
  type_ = name.substr(0, slash) + "/msg" + name.substr(std::min(slash, name.size()));
  plan_ = &planOf(from_.message(), to_->message());
}

const Ros2Message::Plan& Ros2Message::planOf(const MessageType& from, const MessageType& to) {
  const auto [found, is_new] = plans_.try_emplace({&from, &to});
  if (!is_new) return found->second;
  Plan plan;
  std::size_t next = 0;
  const auto is_next = [&](const MessageField& field) {
    return next < from.fields.size() && lowerCase(from.fields[next].name) == field.name;
  };
  for (const MessageField& field : to.fields) {
    // The only field that is dropped is the first of std_msgs/Header.
    if (from.name == kHeader && next == 0 && !is_next(field)) {
      plan.push_back({&from.fields[next++], nullptr, nullptr});
    }
    Move move{nullptr, &field, nullptr};
    if (is_next(field)) move.from = &from.fields[next++];
    if (move.from != nullptr && move.from->message != nullptr) {
      move.nested = &planOf(*move.from->message, *field.message);
    }
    plan.push_back(move);
  }
  return plans_.at({&from, &to}) = std::move(plan);
}

std::string Ros2Message::cdrOf(std::string_view bytes) const {
  Conversion conversion(bytes);
  conversion.convert(*plan_);
  return conversion.finish(type_);
}

std::map<std::string, std::string> ownRos2Types(const std::string& type,
                                                const std::string& definition) {
  const std::string package = kRos2Package;
  std::map<std::string, std::string> texts;
  std::string owner = type.substr(0, type.find('/')) + type.substr(type.rfind('/'));
  std::istringstream lines(definition);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("====", 0) == 0) continue;
    if (line.rfind(kTypeLine, 0) == 0) {
      owner = line.substr(sizeof kTypeLine - 1);
    } else if (owner.rfind(package + "/", 0) == 0) {
      texts[owner.substr(package.size() + 1)] += line + "\n";
    }
  }
  return texts;
}

}  // namespace forge
