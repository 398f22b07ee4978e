#pragma once

#include <charconv>
#include <cstring>
#include <functional>
#include <regex>
#include <string>

#include "collision_forge/io/export/pickle_writer.h"

namespace forge {

/// Returns the written JSON with arrays inlined: [[1,2],[3,4]]; flags as [true,false], a float as
/// its number.
inline std::string inlined(const PickleContent& content) {
  static const std::regex array(R"re(\{"ndarray":\[([\d,]*)\],"dtype":"(..)","at":(\d+)\})re");
  const auto item = [&](std::size_t place, bool is_flag) {
    double value = 0.0;
    std::memcpy(&value, content.items.data() + place * sizeof(value), sizeof(value));
    if (is_flag) return std::string(value == 0.0 ? "false" : "true");
    char digits[32];
    return std::string(digits, std::to_chars(digits, digits + sizeof(digits), value).ptr);
  };
  const auto values = [&](const std::string& shape, bool is_flag, std::size_t at) {
    if (shape.empty()) return item(at, is_flag);
    const std::size_t comma = shape.find(',');
    const std::size_t columns =
        comma == std::string::npos ? 0 : std::stoul(shape.substr(comma + 1));
    std::string text = "[";
    for (std::size_t row = 0; row < std::stoul(shape); ++row) {
      text += row == 0 ? "" : ",";
      text += columns == 0 ? item(at + row, is_flag) : "[";
      for (std::size_t column = 0; column < columns; ++column) {
        text += (column == 0 ? "" : ",") + item(at + row * columns + column, is_flag);
      }
      text += columns == 0 ? "" : "]";
    }
    return text + "]";
  };
  std::string text;
  std::string rest = content.json;
  for (std::smatch found; std::regex_search(rest, found, array); rest = found.suffix()) {
    text += found.prefix().str() + values(found[1], found[2] == "b1", std::stoul(found[3]));
  }
  return text + rest;
}

/// Returns the JSON that `write` writes.
inline std::string inlined(const std::function<void(PickleWriter&)>& write) {
  PickleWriter writer;
  write(writer);
  return inlined(writer.content());
}

}  // namespace forge
