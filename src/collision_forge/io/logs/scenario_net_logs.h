#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/io/logs/pickle_workers.h"

namespace forge {

/// Prefix of the names of description files that this package writes.
inline constexpr const char* kOwnDescriptions = "sd_collision_forge_v1_";

/// The format of ScenarioNet's scenario descriptions (Li et al., NeurIPS 2023): a folder, with any
/// subfolders, of sd_*.pkl files. A scene's name is the file name without ending and
/// kOwnDescriptions. ScenarioNet converts Waymo, nuPlan and Argoverse to this format.
const LogFormat& scenarioNetFormat();

/// Reads one description.
/// - Times are `metadata.ts`, shifted to start at 1 s or later: a bag cannot hold time 0.
/// - The ego is `metadata.sdc_id` with the configured box; another box in the file adds a warning.
/// - Frames are the file's steps; in a file of this package, the recorded ones.
/// - Unknown agent types get a class by type and length.
/// - A lane without an outline becomes a strip of kLaneWidth. The drivable area is the union of the
///   lane outlines, unless a file of this package gives it.
///
/// Throws PickleError; std::runtime_error naming file and field if a needed field is missing or has
/// another shape; InputError for values beyond the limits.
LoggedScene readScenarioNet(const std::string& path, PickleWorkers& workers,
                            const DataOptions& options,
                            std::vector<std::string>* warnings = nullptr);

}  // namespace forge
