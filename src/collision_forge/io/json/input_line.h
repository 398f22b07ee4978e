#pragma once

#include <cstddef>
#include <istream>
#include <string>

#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// Throws InputError, naming `where`, for a line of more bytes than limits.max_line.
void checkLineLength(const std::string& where, std::size_t length, const InputLimits& limits);

/// std::getline() of what others wrote: throws as checkLineLength(), without holding the whole
/// line. The stream is then behind it, and the next can be read.
bool readInputLine(std::istream& stream, std::string& line, const std::string& where,
                   const InputLimits& limits);

}  // namespace forge
