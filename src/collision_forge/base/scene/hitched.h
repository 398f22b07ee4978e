#pragma once

#include <vector>

#include "collision_forge/base/scene/track.h"

namespace forge {

/// Returns the first of `agents`, other than `agent` itself, with which `agent` forms one vehicle,
/// or null; the pointer is valid until `agents` changes. Two agents form one vehicle if they are a
/// car-like vehicle (isCarLike()) and a trailer behind it, at most 3 m apart (kingpin and drawbar
/// are between the boxes), or two trucks, buses or construction vehicles at most 0.5 m apart, as
/// parts of one. Distances are between the boxes. One must be ahead of the other, more along than
/// across its heading, and within that distance at all times at which both have a state; at least
/// two such times are needed.
const Track* hitchedTo(const Track& agent, const std::vector<Track>& agents);

}  // namespace forge
