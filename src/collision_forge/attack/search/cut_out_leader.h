#pragma once

#include <optional>

#include "collision_forge/attack/search/hiding.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Finds a vehicle that drives ahead of the ego, hides the attacker, which stands in the ego's
/// lane, and leaves into a neighbouring lane of the same direction shortly before it (the cut-out
/// of UN R157). The vehicle drives as the ego does, a time gap earlier, from the first frame on; it
/// keeps the limits of its class, stays on the road, and is clear of the ego and of all agents at
/// all times. The first fitting one is returned, in the order of lane changes that end 0.3 to 2.2 s
/// before the leader would hit the attacker, late ones first. Returns an empty result if there is
/// none; `refusal` then gets the reason, worded to follow "no leader can be added: ", and without a
/// neighbouring lane the code kRoadDoesNotAllow (else its code is unchanged). Uses the cars of
/// options.added.kinds.
std::optional<SupportVehicle> findCutOutLeader(const HidingInput& input,
                                               const AttackOptions& options, Status& refusal);

}  // namespace forge
