#pragma once

#include <optional>

#include "collision_forge/attack/search/hiding.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Returns true if, at the contact, a vehicle of the input's future stands ahead of the attacker:
/// with at most 6 m (own choice) between both boxes along the attacker's heading, and at most 1.5 m
/// between their centres across it.
bool isQueued(const HidingInput& input);

/// Finds a place for a car (config/search.yaml, added.kinds) that stands ahead of the attacker in
/// its lane from the first frame on, wholly on the drivable area and clear of all agents until the
/// end of the attacker's motion: the second target of UN R157. The attacker must stand at the
/// contact, and options.added.kinds must have a car. Returns nullopt if there is no such place;
/// `refusal` then gets its code, kRoadDoesNotAllow if all places are off the road, and the reason,
/// worded to follow "no queue can be added: ".
std::optional<SupportVehicle> findQueuedVehicle(const HidingInput& input,
                                                const AttackOptions& options, Status& refusal);

}  // namespace forge
