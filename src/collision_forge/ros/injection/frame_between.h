#pragma once

#include <collision_forge/AgentArray.h>

namespace forge {

inline constexpr double kSameTime = 1e-3;  ///< seconds; frames are no nearer to each other

/// Returns the linear interpolation of two points or vectors; `ratio` 0..1.
template <typename Message>
Message between(const Message& before, const Message& after, double ratio) {
  Message message;
  message.x = before.x + ratio * (after.x - before.x);
  message.y = before.y + ratio * (after.y - before.y);
  message.z = before.z + ratio * (after.z - before.z);
  return message;
}

/// Returns a frame of agents between two recorded ones, at `ratio` of the time between them, in
/// (0, 1): all agents in both frames, with positions interpolated and yaw turned the shorter way.
collision_forge::AgentArray frameBetween(const collision_forge::AgentArray& before,
                                         const collision_forge::AgentArray& after, double ratio);

/// A frame of agents soon after a recorded one: its agents, moved on as in shownPose(), with what
/// `before`, the recorded frame before it, shows of their motion. An agent that is not in `before`
/// (or if it is null) stands still. Velocities turn with their boxes.
collision_forge::AgentArray frameAfter(const collision_forge::AgentArray* before,
                                       const collision_forge::AgentArray& newest,
                                       const ros::Time& stamp);

}  // namespace forge
