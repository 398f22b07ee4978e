#pragma once

#include <string>

#include "collision_forge/io/logs/log_source.h"

namespace forge {

/// Returns the format of bags of `forge convert`: one bag or a folder; each bag is a scene named
/// after its file, read by readBagAsWritten(). SceneReader::recording() always throws: the scenes
/// are flat.
const LogFormat& bagFormat();

/// Returns the log source at `path` and detects its format: a bag or a folder of bags, a
/// ScenarioNet folder, else a nuScenes root with tables of `version`.
LogSource logSourceAt(const std::string& path, const std::string& version);

}  // namespace forge
