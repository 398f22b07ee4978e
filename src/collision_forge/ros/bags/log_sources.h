#pragma once

#include <string>

#include "collision_forge/io/logs/log_source.h"

namespace forge {

/// Returns the format for bags of forge convert: a bag or a folder; each bag is a scene named after
/// its file.
const LogFormat& bagFormat();

/// Returns the log source at a path, with the format detected from its files: a bag or folder of
/// bags, a ScenarioNet folder, else a nuScenes root. `version` is for nuScenes.
LogSource logSourceAt(const std::string& path, const std::string& version);

}  // namespace forge
