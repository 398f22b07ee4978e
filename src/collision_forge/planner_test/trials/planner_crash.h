#pragma once

#include <optional>
#include <vector>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// The contact of a planner's ego with any vehicle, and the motion after it.
struct PlannerCrash {
  Track other;             ///< the touched vehicle as it drove, from t0 at least to contact
  PostCrashMotion motion;  ///< of the ego and, as attackerAt(), the touched vehicle
};

/// Returns the crash of a rollout that still has its motions; `outcome.attacker` needs id, class
/// and size, too. `ego_size`: m. `recorded`: the agents that replay their recording, from t0 on; a
/// touched vehicle other than the attacker is looked up in `outcome.others` first. nullopt without
/// a contact, and if the touched vehicle is unknown or has no state at contact.
std::optional<PlannerCrash> crashOf(const RolloutOutcome& outcome, const BoxSize& ego_size,
                                    const std::vector<Track>& recorded,
                                    const SeverityOptions& options);

}  // namespace forge
