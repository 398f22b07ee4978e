#pragma once

#include <vector>

#include "collision_forge/base/scene/track.h"

namespace forge {

/// Returns the agent with which `agent` forms one vehicle, or null: a trailer behind a car-like
/// vehicle, or the other half of a truck or bus that was recorded in two parts. Their boxes are
/// within 0.5 m of each other at all times at which both have a state (the two at least), and one
/// is behind the other.
const Track* hitchedTo(const Track& agent, const std::vector<Track>& agents);

}  // namespace forge
