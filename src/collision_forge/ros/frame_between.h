#pragma once

#include <collision_forge/AgentArray.h>

namespace forge {

/// A frame of agents between two recorded ones, at the ratio of the time between them that is in
/// (0, 1): those who are in both, moved linearly and turned the shorter way.
collision_forge::AgentArray frameBetween(const collision_forge::AgentArray& before,
                                         const collision_forge::AgentArray& after, double ratio);

/// A frame of agents soon after a recorded one: its agents, moved on as in shownPose(), with what
/// `before`, the recorded frame before it, tells of their motion. Who is not in that, or where it
/// is null, stands still. Velocities turn with their boxes.
collision_forge::AgentArray frameAfter(const collision_forge::AgentArray* before,
                                       const collision_forge::AgentArray& newest,
                                       const ros::Time& stamp);

}  // namespace forge
