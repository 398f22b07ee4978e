#pragma once

#include <vector>

#include "collision_forge/base/scene/track.h"

namespace forge {

/// Returns the agent with which `agent` forms one vehicle, or null: the trailer behind a car-like
/// vehicle, at most 3 m from it (kingpin and drawbar are between the boxes), or the other half of a
/// truck or bus that was recorded in two parts, at most 0.5 m. That must hold, with one behind the
/// other, at all times at which both have a state, two at least.
const Track* hitchedTo(const Track& agent, const std::vector<Track>& agents);

}  // namespace forge
