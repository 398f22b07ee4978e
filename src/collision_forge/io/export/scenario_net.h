#pragma once

#include <memory>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// Returns a writer of ScenarioNet scenario descriptions, which MetaDrive replays: one file per
/// crash (scenario_net_description.h) and summaries of all. Tracks: the ego (the self-driving car),
/// the attacker and the other agents. The metadata has under "collision_forge": scene, type, mode,
/// tta (s), seed, manoeuvre, attacker (id), attacker_is_added, now (t0) and contact_time (s as ts;
/// None without a contact), and the fields of writeGround(). write() throws std::invalid_argument
/// for a number that is not finite. Throws std::invalid_argument for a free ego: every track needs
/// its states.
std::unique_ptr<CrashWriter> makeScenarioNetWriter(const ExportPlan& plan);

}  // namespace forge
