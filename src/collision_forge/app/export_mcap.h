#pragma once

#include <string>
#include <vector>

namespace forge {

struct Config;

/// Writes each bag as FOLDER/NAME.mcap, and FOLDER/layout.json for Foxglove and Lichtblick. A file
/// that is there is complete, and is not written again. What cannot be exported is told on stderr,
/// and the others go on. Returns an exit code. Throws std::invalid_argument for two bags of one
/// name.
int exportMcap(const std::vector<std::string>& bags, const std::string& out, const Config& config);

}  // namespace forge
