#pragma once

#include <memory>

#include "collision_forge/export/crash_writer.h"

namespace forge {

/// ScenarioNet's scenario description (Li et al., NeurIPS 2023), which MetaDrive replays:
/// sd_collision_forge_v1_NAME.pkl, and of all crashes dataset_summary.pkl and dataset_mapping.pkl.
///
/// Tracks are those of the ego, which is the self-driving car, of the attacker and of the others,
/// zeros where one is not seen. The map has lanes with their links, walkways, and lines where
/// drivable ground ends. Everything lies at z = 0. What was asked for and answered is in the
/// metadata below "collision_forge". Throws std::invalid_argument for a free ego: every track needs
/// its states.
std::unique_ptr<CrashWriter> makeScenarioNetWriter(const ExportPlan& plan);

}  // namespace forge
