#include "collision_forge/ros/bags/message_fields.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <optional>
#include <sstream>
#include <utility>

#include "collision_forge/ros/bags/bag_error.h"

namespace forge {
namespace {

using Shape = MessageField::Shape;

bool isInteger(BuiltinType type) {
  return type >= BuiltinType::kInt8 && type <= BuiltinType::kUint64;
}

bool isNumber(BuiltinType type) {
  return type >= BuiltinType::kBool && type <= BuiltinType::kFloat64;
}

/// Returns true for an array of uint8, which kText reads as one text.
bool isBytes(const MessageField& field) {
  return field.message == nullptr && field.builtin == BuiltinType::kUint8 &&
         field.shape != Shape::kSingle;
}

bool isOfKind(const MessageField& field, FieldKind kind) {
  if (field.message != nullptr) return false;
  if (kind == FieldKind::kNumber) return isNumber(field.builtin);
  if (kind == FieldKind::kTime) return field.builtin == BuiltinType::kTime;
  return field.builtin == BuiltinType::kString || isInteger(field.builtin);
}

const char* wantedOf(FieldKind kind) {
  if (kind == FieldKind::kNumber) return "a number";
  if (kind == FieldKind::kTime) return "a time";
  return "a string, an integer or an array of uint8";
}

std::string typeOf(const MessageField& field) {
  if (field.shape == Shape::kSingle) return field.type;
  const bool is_fixed = field.shape == Shape::kFixedArray;
  return field.type + "[" + (is_fixed ? std::to_string(field.count) : "") + "]";
}

std::string namesOf(const MessageType& type) {
  std::string names;
  for (const MessageField& field : type.fields) names += (names.empty() ? "" : ", ") + field.name;
  return names.empty() ? "none" : names;
}

/// One element of a path, as "size[0]".
struct PathPart {
  std::string name;
  std::optional<std::string> element;  ///< text after the opening bracket, as "0]"
};

std::vector<PathPart> partsOf(const std::string& path) {
  std::vector<PathPart> parts;
  std::istringstream names(path + ".");
  for (std::string name; std::getline(names, name, '.');) {
    const std::size_t bracket = name.find('[');
    parts.push_back({name.substr(0, bracket), std::nullopt});
    if (bracket != std::string::npos) parts.back().element = name.substr(bracket + 1);
  }
  return parts;
}

/// Returns the index in `element`, 0 for "0]"; nullopt if there is none.
std::optional<std::size_t> indexIn(const std::string& element) {
  std::size_t index = 0;
  const char* const end = element.data() + element.size();
  const auto [after, error] = std::from_chars(element.data(), end, index);
  if (error != std::errc() || std::string(after, end) != "]") return std::nullopt;
  return index;
}

}  // namespace

/// Reads one message into rows.
class MessageFields::Cursor {
 public:
  Cursor(const std::vector<Way>& ways, const MessageType& message, const std::uint8_t* bytes,
         std::size_t size)
      : ways_(ways), message_(message), place_(bytes), left_(size), rows_(ways.size()) {}

  std::vector<FieldRows> read() {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      all.push_back(i);
      if (!ways_[i].has_rows) rows_[i].emplace_back();
    }
    readMessage(message_, 0, all);
    if (left_ > 0) {
      throw BagError(message_.name + ": a message has " + std::to_string(left_) +
                     " bytes more than its fields");
    }
    return std::move(rows_);
  }

 private:
  using Taken = std::vector<std::size_t>;  ///< indices of the paths through the current field

  const Step& stepOf(std::size_t way, std::size_t depth) const { return ways_[way].steps[depth]; }

  void readMessage(const MessageType& type, std::size_t depth, const Taken& ways) {
    if (ways.empty() && type.is_fixed_size) {
      skip(type.min_size);
      return;
    }
    for (std::size_t i = 0; i < type.fields.size(); ++i) {
      Taken taken;
      for (const std::size_t way : ways) {
        if (stepOf(way, depth).field == i) taken.push_back(way);
      }
      fields_.push_back(&type.fields[i]);
      readField(type.fields[i], depth, taken);
      fields_.pop_back();
    }
  }

  void readField(const MessageField& field, std::size_t depth, Taken ways) {
    const std::size_t count = field.shape == Shape::kArray ? take<std::uint32_t>() : field.count;
    if (field.min_size == 0) return;  // elements without bytes have no values
    if (count > left_ / field.min_size) fail();
    if (isBytes(field)) addBytes(count, depth, ways);
    if (ways.empty() && field.is_fixed_size) {
      skip(count * field.min_size);
      return;
    }
    for (std::size_t element = 0; element < count; ++element) {
      readElement(field, depth, waysInto(element, depth, ways));
    }
  }

  /// Returns the paths that lead to this element.
  Taken waysInto(std::size_t element, std::size_t depth, const Taken& ways) {
    Taken taken;
    for (const std::size_t way : ways) {
      const Step& step = stepOf(way, depth);
      if (step.of == Step::Of::kElement && step.element != element) continue;
      if (step.opens_rows) rows_[way].emplace_back();
      taken.push_back(way);
    }
    return taken;
  }

  void readElement(const MessageField& field, std::size_t depth, const Taken& ways) {
    if (field.message != nullptr) {
      readMessage(*field.message, depth + 1, ways);
    } else {
      readBuiltin(field.builtin, ways);
    }
  }

  void readBuiltin(BuiltinType type, const Taken& ways) {
    switch (type) {
      case BuiltinType::kBool:
      case BuiltinType::kUint8:
        return addNumber(take<std::uint8_t>(), ways);
      case BuiltinType::kInt8:
        return addNumber(take<std::int8_t>(), ways);
      case BuiltinType::kInt16:
        return addNumber(take<std::int16_t>(), ways);
      case BuiltinType::kUint16:
        return addNumber(take<std::uint16_t>(), ways);
      case BuiltinType::kInt32:
        return addNumber(take<std::int32_t>(), ways);
      case BuiltinType::kUint32:
        return addNumber(take<std::uint32_t>(), ways);
      case BuiltinType::kInt64:
        return addNumber(take<std::int64_t>(), ways);
      case BuiltinType::kUint64:
        return addNumber(take<std::uint64_t>(), ways);
      case BuiltinType::kFloat32:
        return addNumber(take<float>(), ways);
      case BuiltinType::kFloat64:
        return addNumber(take<double>(), ways);
      case BuiltinType::kString:
        return add(takeText(take<std::uint32_t>()), ways);
      case BuiltinType::kTime:
      case BuiltinType::kDuration:
        return addTime(ways);
    }
  }

  template <typename Number>
  void addNumber(Number number, const Taken& ways) {
    for (const std::size_t way : ways) {
      FieldValue value = static_cast<double>(number);
      if (ways_[way].kind == FieldKind::kText) value = std::to_string(number);
      rows_[way].back().push_back(std::move(value));
    }
  }

  void addTime(const Taken& ways) {
    constexpr std::int64_t kNanoseconds = 1000000000;
    const std::int64_t seconds = take<std::uint32_t>();
    const std::int64_t nanoseconds = take<std::uint32_t>();
    add(seconds * kNanoseconds + nanoseconds, ways);
  }

  void add(const FieldValue& value, const Taken& ways) {
    for (const std::size_t way : ways) rows_[way].back().push_back(value);
  }

  /// Adds an array of uint8 that begins at the cursor to the paths that read it as one text.
  void addBytes(std::size_t count, std::size_t depth, Taken& ways) {
    constexpr char kDigits[] = "0123456789abcdef";
    Taken of_elements;
    for (const std::size_t way : ways) {
      if (stepOf(way, depth).of != Step::Of::kWhole) {
        of_elements.push_back(way);
        continue;
      }
      std::string text;
      for (std::size_t i = 0; i < count; ++i) {
        text += kDigits[place_[i] / 16U];
        text += kDigits[place_[i] % 16U];
      }
      rows_[way].back().emplace_back(std::move(text));
    }
    ways = std::move(of_elements);
  }

  std::string takeText(std::size_t length) {
    if (length > left_) fail();
    std::string text(reinterpret_cast<const char*>(place_), length);
    skip(length);
    return text;
  }

  /// Reads a number. ROS serialises little-endian, like the machines that it supports.
  template <typename Number>
  Number take() {
    Number number{};
    if (sizeof number > left_) fail();
    std::memcpy(&number, place_, sizeof number);
    skip(sizeof number);
    return number;
  }

  void skip(std::size_t count) {
    if (count > left_) fail();
    place_ += count;
    left_ -= count;
  }

  [[noreturn]] void fail() const {
    std::string path;
    for (const MessageField* field : fields_) path += (path.empty() ? "" : ".") + field->name;
    if (path.empty()) path = "its fields";
    throw BagError(message_.name + ": the bytes of a message end within " + path);
  }

  const std::vector<Way>& ways_;
  const MessageType& message_;
  const std::uint8_t* place_;
  std::size_t left_;                         ///< bytes
  std::vector<const MessageField*> fields_;  ///< nested fields that contain the cursor
  std::vector<FieldRows> rows_;
};

MessageFields::MessageFields(const std::string& type, const std::string& definition,
                             const std::vector<FieldPath>& paths)
    : definition_(type, definition) {
  for (const FieldPath& path : paths) ways_.push_back(wayOf(path));
}

std::vector<FieldRows> MessageFields::read(const std::uint8_t* bytes, std::size_t size) const {
  return Cursor(ways_, definition_.message(), bytes, size).read();
}

MessageFields::Way MessageFields::wayOf(const FieldPath& path) const {
  const MessageType& message = definition_.message();
  const auto fail = [&](const std::string& problem) {
    throw BagError(message.name + ": field " + path.path + ": " + problem);
  };
  const MessageType* type = &message;
  const MessageField* field = nullptr;
  Way way;
  way.kind = path.kind;
  const std::vector<PathPart> parts = partsOf(path.path);
  for (const PathPart& part : parts) {
    if (type == nullptr) fail(field->name + " is of type " + typeOf(*field) + " and has no fields");
    const auto found = std::find_if(type->fields.begin(), type->fields.end(),
                                    [&](const auto& known) { return known.name == part.name; });
    if (found == type->fields.end()) {
      fail(type->name + " has no field '" + part.name + "'; its fields are " + namesOf(*type));
    }
    field = &*found;
    Step step;
    step.field = static_cast<std::size_t>(found - type->fields.begin());
    const bool is_text = &part == &parts.back() && path.kind == FieldKind::kText && isBytes(*field);
    if (part.element) {
      if (field->shape == Shape::kSingle) fail(part.name + " is not an array");
      const auto index = indexIn(*part.element);
      if (!index && *part.element != "]") fail("'[" + *part.element + "' is not an index");
      if (index && field->shape == Shape::kFixedArray && *index >= field->count) {
        fail(part.name + " has " + std::to_string(field->count) + " elements");
      }
      step.of = index ? Step::Of::kElement : Step::Of::kEvery;
      step.element = index.value_or(0);
      step.opens_rows = !index && !way.has_rows;
      way.has_rows = way.has_rows || !index;
    } else if (field->shape != Shape::kSingle && !is_text) {
      fail(part.name + " is an array: write " + part.name + "[0] or " + part.name + "[]");
    }
    way.steps.push_back(step);
    type = field->message;
  }
  if (!isOfKind(*field, path.kind)) {
    fail(field->name + " is of type " + typeOf(*field) + ", not " + wantedOf(path.kind));
  }
  return way;
}

}  // namespace forge
