#pragma once

#include <collision_forge/AgentArray.h>

#include <vector>

namespace forge {

inline constexpr double kSameTime = 1e-3;  ///< s; frames closer in time than this count as one

/// Interpolates linearly; `ratio` 0 is `before`, 1 is `after`.
template <typename Message>
Message between(const Message& before, const Message& after, double ratio) {
  Message message;
  message.x = before.x + ratio * (after.x - before.x);
  message.y = before.y + ratio * (after.y - before.y);
  message.z = before.z + ratio * (after.z - before.z);
  return message;
}

/// Returns the frame at `ratio`, in (0, 1), of the time between two recorded frames, with the stamp
/// of that time. It has only the agents that are in both frames: positions and velocities are
/// interpolated linearly, headings along the shorter rotation; all else is from `before`.
collision_forge::AgentArray frameBetween(const collision_forge::AgentArray& before,
                                         const collision_forge::AgentArray& after, double ratio);

/// Returns the agents at `stamp`, by frameBetween() of the two neighbours in `frames` (sorted by
/// stamp); none outside of them and in gaps above kMaxGap.
std::vector<collision_forge::Agent> agentsAt(const std::vector<collision_forge::AgentArray>& frames,
                                             const ros::Time& stamp);

/// Extrapolates the agents of the recorded frame `newest` to `stamp` like shownPose(). `before`,
/// the recorded frame before it, is used to derive their motion. Agents that are not in `before`
/// stand still, as do all if it is null. Velocities rotate with the boxes.
collision_forge::AgentArray frameAfter(const collision_forge::AgentArray* before,
                                       const collision_forge::AgentArray& newest,
                                       const ros::Time& stamp);

}  // namespace forge
