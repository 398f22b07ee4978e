#pragma once

#include <string>

#include "collision_forge/io/logs/log_source.h"

namespace forge {

/// Returns the format of bags of `forge convert`: one bag or a folder of bags (*.bag, not in its
/// subfolders, sorted by name); each is a scene named after its file without extension, read by
/// readBagAsWritten(). SceneReader::recording() always throws, because such a bag holds a flat
/// scene. The object lives until the program ends.
const LogFormat& bagFormat();

/// Returns the log source at `path` and detects its format: a bag or a folder of bags, a
/// ScenarioNet folder, CommonRoad scenarios, else (also for a missing path) a nuScenes root with
/// tables of `version` (LogSource::version). Throws nothing for a source that cannot be read.
LogSource logSourceAt(const std::string& path, const std::string& version);

}  // namespace forge
