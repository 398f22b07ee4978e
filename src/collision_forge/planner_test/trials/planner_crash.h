#pragma once

#include <optional>
#include <vector>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// The contact of a planner's ego with any vehicle, and what follows it.
struct PlannerCrash {
  Track other;             ///< the touched vehicle as it drove, from now to the contact or longer
  PostCrashMotion motion;  ///< of the ego and, as attackerAt(), of the touched vehicle
};

/// Returns the crash of a rollout by an ego of this size. `recorded`: the vehicles that did not
/// react to it. Empty without a contact, and where the touched vehicle has no state at the contact.
std::optional<PlannerCrash> crashOf(const RolloutOutcome& outcome, const BoxSize& ego_size,
                                    const std::vector<Track>& recorded,
                                    const DriveLimitOptions& options);

}  // namespace forge
