#pragma once

#include <collision_forge/AgentArray.h>

namespace forge {

inline constexpr double kSameTime = 1e-3;  ///< seconds; frames are no nearer to each other

/// The point or vector at a ratio of the way from one to another.
template <typename Message>
Message between(const Message& before, const Message& after, double ratio) {
  Message message;
  message.x = before.x + ratio * (after.x - before.x);
  message.y = before.y + ratio * (after.y - before.y);
  message.z = before.z + ratio * (after.z - before.z);
  return message;
}

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
