#pragma once

#include <cstddef>
#include <istream>
#include <string>

#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// Throws InputError, naming `where`, for a line longer than limits.max_line bytes.
void checkLineLength(const std::string& where, std::size_t length, const InputLimits& limits);

/// Reads a line of untrusted input into `line`, without its line end; returns false at the end of
/// the stream. `where` names file and line in errors. Throws as checkLineLength() without holding
/// the whole line in memory; the stream is then at the next line.
bool readInputLine(std::istream& stream, std::string& line, const std::string& where,
                   const InputLimits& limits);

}  // namespace forge
