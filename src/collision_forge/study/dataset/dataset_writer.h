#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/study/dataset/attempts.h"
#include "collision_forge/study/dataset/options.h"

namespace forge {

/// Writes the data set to `folder`, which is created if missing: per split the clips in COLLIDE's
/// layout (CollideExporter) and the scenario file scenarios/SPLIT.jsonl, then statistics.csv and
/// statistics.md. Splits the scenes of the chosen attempts by options.split (splitByScene()); a
/// split without clips gets no files. Keeps clip files that exist already and replaces the other
/// files. Returns the text of statistics.md.
///
/// `path` is attempts.jsonl, with one line per element of `attempts`; `chosen` are the ascending
/// indices into `attempts` of the attempts to write, each with Attempt::valid. `limits`: of the
/// values in `path`. `scenes` provides the recordings. Throws std::runtime_error if a file cannot
/// be written, and the exceptions of readScenarioLine() and SceneSource::at().
std::string writeDataset(const std::string& folder, const std::string& path,
                         const std::vector<Attempt>& attempts,
                         const std::vector<std::size_t>& chosen, const DatasetOptions& options,
                         const InputLimits& limits, SceneSource& scenes);

}  // namespace forge
