#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/io/logs/pickle_workers.h"

namespace forge {

/// What the names of this suite's own files begin with.
inline constexpr const char* kOwnDescriptions = "sd_collision_forge_v1_";

/// Scenario descriptions of ScenarioNet (Li et al., NeurIPS 2023): a folder with sd_*.pkl, in
/// folders of its own too, each a scene named as its file
/// without the ending, and without kOwnDescriptions. By them Waymo, nuPlan and Argoverse come
/// in, converted by ScenarioNet.
const LogFormat& scenarioNetFormat();

/// One description. Times are those of `metadata.ts`, from 1 s on where they begin earlier, as a
/// bag has no time 0. The ego is `metadata.sdc_id`; its box is that of the configuration, and
/// `warnings` get a line where the file has another. Frames are the steps of the file, or, of a
/// file of this suite, those that were recorded. What has no class of this suite gets one by type
/// and length. A lane without an outline is a strip as wide as kLaneWidth. Drivable
/// are the lanes' outlines; a file of this suite says it better.
///
/// Throws PickleError, and std::runtime_error naming file and field for a description that lacks
/// what is needed, or has it in another shape; InputError for what is beyond the limits.
LoggedScene readScenarioNet(const std::string& path, PickleWorkers& workers,
                            const DataOptions& options,
                            std::vector<std::string>* warnings = nullptr);

}  // namespace forge
