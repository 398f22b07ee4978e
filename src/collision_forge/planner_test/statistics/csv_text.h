#pragma once

#include <algorithm>
#include <string>

namespace forge {

/// As a column of a CSV file that nobody quotes: commas and line ends would break the row.
inline std::string csvText(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace_if(
      text.begin(), text.end(),
      [](char character) { return character == '\n' || character == '\r'; }, ' ');
  return text;
}

}  // namespace forge
