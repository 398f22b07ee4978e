#pragma once

#include <algorithm>
#include <string>

namespace forge {

/// Returns the text as a field of an unquoted CSV file: replaces commas by semicolons and line ends
/// by spaces.
inline std::string csvText(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace_if(
      text.begin(), text.end(),
      [](char character) { return character == '\n' || character == '\r'; }, ' ');
  return text;
}

}  // namespace forge
