#pragma once

#include <cstdint>
#include <string>

#include "collision_forge/ros/messages/message_error.h"

namespace forge {

/// Converts the constant of a field, at most `last`. `field` names it in errors. Throws
/// MessageError for a larger one.
template <typename Value>
Value enumOf(std::uint8_t value, Value last, const std::string& field) {
  if (value > static_cast<std::uint8_t>(last)) {
    throw MessageError(field + " = " + std::to_string(value) + " does not exist");
  }
  return static_cast<Value>(value);
}

/// Converts the word of a field by `from_string`. Throws MessageError for an unknown word.
template <typename FromString>
auto wordIn(const std::string& word, const char* field, FromString from_string) {
  const auto meaning = from_string(word);
  if (!meaning) throw MessageError(std::string(field) + " = \"" + word + "\" is unknown");
  return *meaning;
}

}  // namespace forge
