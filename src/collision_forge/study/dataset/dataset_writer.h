#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/study/dataset/attempts.h"
#include "collision_forge/study/dataset/options.h"

namespace forge {

/// Writes all that a data set has of the chosen attempts to a folder: clips and scenario files by
/// split, pictures by type, statistics.csv and statistics.md, whose text is returned. `path`:
/// attempts.jsonl, with a line an attempt. Throws std::runtime_error for what cannot be written.
std::string writeDataset(const std::string& folder, const std::string& path,
                         const std::vector<Attempt>& attempts,
                         const std::vector<std::size_t>& chosen, const DatasetOptions& options,
                         const DrawingOptions& drawing, const InputLimits& limits,
                         SceneSource& scenes);

}  // namespace forge
