#pragma once

#include <memory>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// Scenario descriptions of ScenarioNet, which MetaDrive replays, a file a crash
/// (scenario_net_description.h), and the summaries of all.
///
/// Tracks are those of the ego, which is the self-driving car, of the attacker and of the others.
/// What was asked for and answered is in the metadata below "collision_forge". Throws
/// std::invalid_argument for a free ego: every track needs its states.
std::unique_ptr<CrashWriter> makeScenarioNetWriter(const ExportPlan& plan);

}  // namespace forge
