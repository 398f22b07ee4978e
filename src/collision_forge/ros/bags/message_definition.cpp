#include "collision_forge/ros/bags/message_definition.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "collision_forge/ros/bags/bag_error.h"

namespace forge {
namespace {

constexpr int kMaxDepth = 32;           // levels of nested types; messages in use have about five
constexpr std::size_t kLengthSize = 4;  // bytes of the length of an array or a string
constexpr std::size_t kManyBytes = std::size_t{1} << 40U;  // more than any message has

struct BuiltinName {
  const char* name;
  BuiltinType type;
  std::size_t size;  // bytes
};
constexpr BuiltinName kBuiltins[] = {
    {"bool", BuiltinType::kBool, 1},       {"int8", BuiltinType::kInt8, 1},
    {"byte", BuiltinType::kInt8, 1},       {"uint8", BuiltinType::kUint8, 1},
    {"char", BuiltinType::kUint8, 1},      {"int16", BuiltinType::kInt16, 2},
    {"uint16", BuiltinType::kUint16, 2},   {"int32", BuiltinType::kInt32, 4},
    {"uint32", BuiltinType::kUint32, 4},   {"int64", BuiltinType::kInt64, 8},
    {"uint64", BuiltinType::kUint64, 8},   {"float32", BuiltinType::kFloat32, 4},
    {"float64", BuiltinType::kFloat64, 8}, {"string", BuiltinType::kString, kLengthSize},
    {"time", BuiltinType::kTime, 8},       {"duration", BuiltinType::kDuration, 8},
};

const BuiltinName* builtinOf(const std::string& name) {
  const auto* const found = std::find_if(std::begin(kBuiltins), std::end(kBuiltins),
                                         [&](const auto& builtin) { return name == builtin.name; });
  return found == std::end(kBuiltins) ? nullptr : found;
}

/// Returns package/Type for a type as written in a field of a message of `package`.
std::string fullName(const std::string& type, const std::string& package) {
  if (type == "Header") return "std_msgs/Header";
  return type.find('/') == std::string::npos ? package + "/" + type : type;
}

std::size_t product(std::size_t count, std::size_t size) {
  if (size == 0 || count < kManyBytes / size) return count * size;
  return kManyBytes;
}

/// Parses a line such as "float64[9] values", without a comment.
MessageField fieldOf(const std::string& line, const std::string& type) {
  const auto fail = [&] {
    throw BagError(type + ": cannot parse the line '" + line + "' of its definition");
  };
  MessageField field;
  std::istringstream words(line);
  std::string rest;
  if (!(words >> field.type >> field.name) || words >> rest) fail();
  const std::size_t bracket = field.type.find('[');
  if (bracket == std::string::npos) return field;
  const std::string count = field.type.substr(bracket + 1);
  field.type.resize(bracket);
  field.shape = MessageField::Shape::kArray;
  if (count == "]") return field;
  field.shape = MessageField::Shape::kFixedArray;
  const char* const end = count.data() + count.size();
  const auto [after, error] = std::from_chars(count.data(), end, field.count);
  if (error != std::errc() || std::string(after, end) != "]") fail();
  return field;
}

}  // namespace

MessageDefinition::MessageDefinition(const std::string& type, const std::string& text) {
  parse(type, text);
  for (auto& [name, parsed] : types_) resolve(parsed);
  MessageType& message = types_.at(type);
  measure(message, 1);
  message_ = &message;
}

void MessageDefinition::parse(const std::string& type, const std::string& text) {
  if (text.find('\0') != std::string::npos) {
    throw BagError(type + ": its definition has a zero byte");
  }
  MessageType* current = &types_[type];
  current->name = type;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.size(), line.find('#')));
    line.resize(line.find_last_not_of(" \t\r") + 1);
    constexpr char kNameOfType[] = "MSG: ";
    if (line.rfind(kNameOfType, 0) == 0) {
      const std::string name = line.substr(sizeof kNameOfType - 1);
      current = &types_[name];
      current->name = name;
      current->fields.clear();
    } else if (!line.empty() && line.find('=') == std::string::npos) {
      current->fields.push_back(fieldOf(line, current->name));
    }
  }
}

void MessageDefinition::resolve(MessageType& type) {
  const std::string package = type.name.substr(0, type.name.find('/'));
  for (MessageField& field : type.fields) {
    if (const BuiltinName* const builtin = builtinOf(field.type)) {
      field.builtin = builtin->type;
      field.min_size = builtin->size;
      field.is_fixed_size = builtin->type != BuiltinType::kString;
      continue;
    }
    const auto found = types_.find(fullName(field.type, package));
    if (found == types_.end()) {
      throw BagError(type.name + ": type " + field.type + " of its field " + field.name +
                     " is not defined");
    }
    field.message = &found->second;
  }
}

/// Computes sizes and height of a type and of its member types, once.
void MessageDefinition::measure(MessageType& type, int depth) {
  if (type.height > 0) return;
  int height = 1;
  type.is_fixed_size = true;
  for (MessageField& field : type.fields) {
    if (field.message != nullptr) {
      if (depth < kMaxDepth) measure(types_.at(field.message->name), depth + 1);
      height = std::max(height, field.message->height + 1);
      if (depth >= kMaxDepth || height > kMaxDepth) {
        throw BagError(type.name + ": its field " + field.name + " nests types " +
                       std::to_string(kMaxDepth) +
                       " levels deep or more; does a type contain itself?");
      }
      field.min_size = field.message->min_size;
      field.is_fixed_size = field.message->is_fixed_size;
    }
    const bool is_array = field.shape == MessageField::Shape::kArray;
    type.is_fixed_size = type.is_fixed_size && field.is_fixed_size && !is_array;
    type.min_size += is_array ? kLengthSize : product(field.count, field.min_size);
    type.min_size = std::min(type.min_size, kManyBytes);
  }
  type.height = height;
}

}  // namespace forge
