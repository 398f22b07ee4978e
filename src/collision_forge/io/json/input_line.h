#pragma once

#include <cstddef>
#include <istream>
#include <string>

#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// Throws InputError if a line of `length` bytes is longer than limits.max_line (bytes). `where`
/// names file and line in the message.
void checkLineLength(const std::string& where, std::size_t length, const InputLimits& limits);

/// Reads a line of untrusted input into `line`, without its '\n'. Returns false at the end of the
/// stream or after a read error; `line` is then empty or incomplete. An empty line and a last line
/// without '\n' count as lines. Throws as checkLineLength() without holding the whole line in
/// memory; the stream is then at the next line. `where` names file and line in errors.
bool readInputLine(std::istream& stream, std::string& line, const std::string& where,
                   const InputLimits& limits);

}  // namespace forge
