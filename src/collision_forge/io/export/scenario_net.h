#pragma once

#include <memory>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// Returns a writer of ScenarioNet scenario descriptions, which MetaDrive replays: one file per
/// crash (scenario_net_description.h) and summaries of all. Tracks: the ego (the self-driving car),
/// the attacker and the other agents. Request and result are in the metadata under
/// "collision_forge". Throws std::invalid_argument for a free ego: every track needs its states.
std::unique_ptr<CrashWriter> makeScenarioNetWriter(const ExportPlan& plan);

}  // namespace forge
