#pragma once

#include <collision_forge/AgentArray.h>

namespace forge {

/// A frame of agents between two recorded ones, at the ratio of the time between them that is in
/// (0, 1): those who are in both, moved linearly and turned the shorter way.
collision_forge::AgentArray frameBetween(const collision_forge::AgentArray& before,
                                         const collision_forge::AgentArray& after, double ratio);

}  // namespace forge
