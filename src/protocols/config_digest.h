#pragma once

#include <string>
#include <vector>

namespace forge {

/// A line "config/NAME = HASH" for every .yaml file in `directory` that results can depend on (all
/// but drawing.yaml), sorted by name; the hash (FNV-1a, 64 bits) is of the file's bytes. Throws
/// std::runtime_error for a file that cannot be read.
std::vector<std::string> digestConfig(const std::string& directory);

}  // namespace forge
