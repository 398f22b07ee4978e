#include "collision_forge/io/json/input_line.h"

#include <limits>

namespace forge {

void checkLineLength(const std::string& where, std::size_t length, const InputLimits& limits) {
  if (length <= static_cast<std::size_t>(limits.max_line)) return;
  throw InputError(where + ": length = " + std::to_string(length) +
                   " bytes is more than max_line = " + std::to_string(limits.max_line));
}

bool readInputLine(std::istream& stream, std::string& line, const std::string& where,
                   const InputLimits& limits) {
  const auto longest = static_cast<std::size_t>(limits.max_line);
  line.clear();
  bool has_end = false;
  for (char byte = 0; !has_end && line.size() <= longest && stream.get(byte);) {
    has_end = byte == '\n';
    if (!has_end) line += byte;
  }
  std::size_t length = line.size();
  if (length > longest) {
    stream.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    length += static_cast<std::size_t>(stream.gcount()) - (stream.eof() ? 0 : 1);
  }
  checkLineLength(where, length, limits);
  return !stream.bad() && (has_end || !line.empty());
}

}  // namespace forge
