#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/io/logs/pickle_workers.h"

namespace forge {

/// Prefix of the names of description files that this package writes.
inline constexpr const char* kOwnDescriptions = "sd_collision_forge_v1_";

/// Returns the format of ScenarioNet's scenario descriptions (Li et al., NeurIPS 2023): a folder,
/// with any subfolders, of sd_*.pkl files. A scene's name is the file name without ending and
/// kOwnDescriptions. ScenarioNet converts Waymo, nuPlan and Argoverse to this format. The object
/// lives until the program ends.
const LogFormat& scenarioNetFormat();

/// Reads the description in the file `path`. Poses and points keep the file's frame, which becomes
/// the map frame.
/// - Times are `metadata.ts` (in a file of this package, plus the recorded start), shifted to start
///   at 1 s or later: a bag cannot hold time 0.
/// - The ego is `metadata.sdc_id` with the box in the file, else the configured one. A box that is
///   wider than long is turned, with a warning.
/// - Frames are the file's steps; in a file of this package, the recorded ones.
/// - Unknown agent types get a class by type and length.
/// - A lane without an outline becomes a strip of kLaneWidth. The drivable area is as a file of
///   this package gives it, else roadArea(), else the union of the lane outlines. The driving side
///   is as a file of this package gives it, else as configured for `metadata.map`, else right.
///
/// Throws PickleError; std::runtime_error naming file and field if a needed field is missing or has
/// another shape; InputError for values beyond the limits. Appends a line per kind of problem to
/// `warnings`, if not null.
LoggedScene readScenarioNet(const std::string& path, PickleWorkers& workers,
                            const DataOptions& options,
                            std::vector<std::string>* warnings = nullptr);

}  // namespace forge
