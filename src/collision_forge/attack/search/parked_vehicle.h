#pragma once

#include <vector>

#include "collision_forge/attack/search/hiding.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Finds one or two parked cars or vans (of the kinds of options.added.kinds) that hide the
/// attacker until it comes into view within `input.visible_for` before the contact. Each stands
/// since the first frame at the kerb side of a lane outside junctions and crosswalks, parallel to
/// the lane, wholly on the drivable area, and clear of the ego and of all agents at all times.
/// Places beside the lanes are preferred to places in a lane; among these, cars are preferred to
/// vans, then places that hide the attacker longer (beyond 1 s all count as equal), then places
/// from behind which it comes into view latest. A second vehicle, of the same kind, is added if the
/// ranking improves. Returns an empty vector if there is no such place; `refusal` then gets its
/// code, kRoadDoesNotAllow if no place is long and wide enough, and the reason, worded to follow
/// "no parked_vehicle can be added: ".
std::vector<SupportVehicle> findParkedVehicles(const HidingInput& input,
                                               const AttackOptions& options, Status& refusal);

}  // namespace forge
