#pragma once

#include <collision_forge/AgentArray.h>

#include <vector>

namespace forge {

inline constexpr double kSameTime = 1e-3;  ///< s; frames closer in time than this count as one

/// Interpolates x, y and z of a point or vector linearly; `ratio` 0 returns `before`, 1 `after`; a
/// ratio outside of [0, 1] extrapolates.
template <typename Message>
Message between(const Message& before, const Message& after, double ratio) {
  Message message;
  message.x = before.x + ratio * (after.x - before.x);
  message.y = before.y + ratio * (after.y - before.y);
  message.z = before.z + ratio * (after.z - before.z);
  return message;
}

/// Returns the frame at the share `ratio`, in (0, 1), of the time between two recorded frames, with
/// the stamp of that time. It has only the agents that are in both frames, in the order of
/// `before`: positions and velocities are interpolated linearly, orientations along the shorter
/// rotation; all else is from `before`.
collision_forge::AgentArray frameBetween(const collision_forge::AgentArray& before,
                                         const collision_forge::AgentArray& after, double ratio);

/// Returns the agents at `stamp`: of the frame with exactly this stamp (the first of several), else
/// by frameBetween() of the two neighbours in `frames` (sorted by stamp). Returns none before the
/// first and after the last frame (at their stamps: their agents), without frames, and between
/// frames that are more than kMaxGap apart.
std::vector<collision_forge::Agent> agentsAt(const std::vector<collision_forge::AgentArray>& frames,
                                             const ros::Time& stamp);

/// Returns the recorded frame `newest` with the stamp `stamp` (later) and its agents extrapolated
/// to it like shownPose(), so by kLongestGuess at most. Their motion is derived from their poses in
/// `before`, the recorded frame before `newest`. Agents that are not in `before` stand still, as do
/// all if it is null. The velocity of each agent is that in `newest`, rotated with its box.
collision_forge::AgentArray frameAfter(const collision_forge::AgentArray* before,
                                       const collision_forge::AgentArray& newest,
                                       const ros::Time& stamp);

}  // namespace forge
