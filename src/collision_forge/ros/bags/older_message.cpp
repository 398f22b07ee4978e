#include "collision_forge/ros/bags/older_message.h"

#include <algorithm>
#include <cstring>

#include "collision_forge/ros/bags/bag_error.h"

namespace forge {
namespace {

using Shape = MessageField::Shape;
using Bytes = std::vector<std::uint8_t>;

/// The rest of a serialised message.
class Rest {
 public:
  Rest(const MessageType& message, const Bytes& bytes)
      : message_(&message), place_(bytes.data()), left_(bytes.size()) {}

  const std::uint8_t* place() const { return place_; }

  void skip(std::size_t size) {
    if (size > left_) fail();
    place_ += size;
    left_ -= size;
  }

  std::uint32_t takeLength() {
    std::uint32_t length = 0;
    const std::uint8_t* const begin = place_;
    skip(sizeof(length));
    std::memcpy(&length, begin, sizeof(length));
    return length;
  }

  /// Returns the number of elements that follow.
  std::size_t takeCount(const MessageField& field) {
    const std::size_t count = field.shape == Shape::kArray ? takeLength() : field.count;
    if (count > left_ / std::max<std::size_t>(field.min_size, 1)) fail();
    return count;
  }

 private:
  [[noreturn]] void fail() const {
    throw BagError(message_->name + ": a message ends within a field");
  }

  const MessageType* message_;
  const std::uint8_t* place_;
  std::size_t left_;
};

void skipField(const MessageField& field, Rest& rest);

void skipElement(const MessageField& field, Rest& rest) {
  if (field.is_fixed_size) {
    rest.skip(field.min_size);
  } else if (field.message != nullptr) {
    for (const MessageField& inner : field.message->fields) skipField(inner, rest);
  } else {
    rest.skip(rest.takeLength());
  }
}

void skipField(const MessageField& field, Rest& rest) {
  const std::size_t count = rest.takeCount(field);
  for (std::size_t i = 0; i < count; ++i) skipElement(field, rest);
}

bool isAlike(const MessageField& one, const MessageField& other) {
  const bool is_message = one.message != nullptr;
  return one.name == other.name && one.shape == other.shape && one.count == other.count &&
         is_message == (other.message != nullptr) && one.type == other.type;
}

void appendDefault(const MessageField& field, Bytes& out) {
  if (field.shape == Shape::kArray) {
    out.insert(out.end(), sizeof(std::uint32_t), 0);
    return;
  }
  for (std::size_t i = 0; i < field.count; ++i) {
    if (field.message == nullptr || field.is_fixed_size) {
      out.insert(out.end(), field.min_size, 0);  // of a string: its length
      continue;
    }
    for (const MessageField& inner : field.message->fields) appendDefault(inner, out);
  }
}

void appendMessage(const MessageType& from, const MessageType& to, Rest& rest, Bytes& out);

/// Appends a field to which isAlike() holds.
void appendField(const MessageField& from, const MessageField& to, Rest rest, Bytes& out) {
  const std::uint8_t* begin = rest.place();
  const std::size_t count = rest.takeCount(from);
  out.insert(out.end(), begin, rest.place());
  for (std::size_t i = 0; i < count; ++i) {
    if (from.message != nullptr) {
      appendMessage(*from.message, *to.message, rest, out);
      continue;
    }
    begin = rest.place();
    skipElement(from, rest);
    out.insert(out.end(), begin, rest.place());
  }
}

void appendMessage(const MessageType& from, const MessageType& to, Rest& rest, Bytes& out) {
  std::vector<Rest> places;
  for (const MessageField& field : from.fields) {
    places.push_back(rest);
    skipField(field, rest);
  }
  for (const MessageField& field : to.fields) {
    const auto same = std::find_if(from.fields.begin(), from.fields.end(),
                                   [&](const auto& old) { return isAlike(old, field); });
    if (same == from.fields.end()) {
      appendDefault(field, out);
    } else {
      appendField(*same, field, places[static_cast<std::size_t>(same - from.fields.begin())], out);
    }
  }
}

}  // namespace

Bytes convertMessage(const MessageType& from, const MessageType& to, const Bytes& bytes) {
  Rest rest(from, bytes);
  Bytes converted;
  appendMessage(from, to, rest, converted);
  return converted;
}

}  // namespace forge
