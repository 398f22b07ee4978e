#pragma once

#include <string>
#include <vector>

namespace forge {

struct Config;

/// Converts each bag to OUT/NAME.mcap and writes OUT/layout.json for Foxglove and Lichtblick. Skips
/// MCAP files that exist: a file gets its name only when it is complete. Reports bags that cannot
/// be converted on stderr and continues with the next one. Returns kExitError if any bag failed,
/// else kExitOk. Throws std::invalid_argument for two bags of the same name.
int exportMcap(const std::vector<std::string>& bags, const std::string& out, const Config& config);

}  // namespace forge
