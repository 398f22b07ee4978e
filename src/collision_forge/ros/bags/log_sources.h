#pragma once

#include <string>

#include "collision_forge/io/logs/log_source.h"

namespace forge {

/// Bags of forge convert: one, or a folder with some, each a scene named as its file.
const LogFormat& bagFormat();

/// The log source at a path, of whichever format it looks like: a bag or a folder of bags, a
/// ScenarioNet folder, else a nuScenes root. `version` is of the last.
LogSource logSourceAt(const std::string& path, const std::string& version);

}  // namespace forge
