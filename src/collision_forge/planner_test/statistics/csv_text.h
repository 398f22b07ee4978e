#pragma once

#include <algorithm>
#include <string>

namespace forge {

/// Returns the text as a field of an unquoted CSV file: replaces each comma by a semicolon and each
/// line feed or carriage return by a space. Double quotes stay.
inline std::string csvText(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace_if(
      text.begin(), text.end(),
      [](char character) { return character == '\n' || character == '\r'; }, ' ');
  return text;
}

}  // namespace forge
