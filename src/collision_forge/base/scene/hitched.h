#pragma once

#include <vector>

#include "collision_forge/base/scene/track.h"

namespace forge {

/// Returns the agent with which `agent` forms one vehicle, or null. Two agents form one vehicle if
/// they are a car-like vehicle and a trailer at most 3 m apart (kingpin and drawbar are between the
/// boxes), or two parts of a truck or bus at most 0.5 m apart. One must be behind the other and
/// within that distance at all times at which both have a state; at least two such times are
/// needed.
const Track* hitchedTo(const Track& agent, const std::vector<Track>& agents);

}  // namespace forge
