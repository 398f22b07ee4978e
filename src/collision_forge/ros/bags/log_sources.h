#pragma once

#include <string>

#include "collision_forge/io/logs/log_source.h"

namespace forge {

/// Returns the format of bags of `forge convert`: one bag or a folder; each is a scene named after
/// its file.
const LogFormat& bagFormat();

/// Returns the log source at `path` and detects its format: a bag or a folder of bags, a
/// ScenarioNet folder, else a nuScenes root with tables of `version`.
LogSource logSourceAt(const std::string& path, const std::string& version);

}  // namespace forge
