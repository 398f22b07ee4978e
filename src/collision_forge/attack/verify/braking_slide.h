#pragma once

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// A vehicle that brakes to a stand: it keeps its heading and its direction of travel.
struct BrakingSlide {
  double begin = 0.0;          ///< seconds
  Vector2 velocity{0.0, 0.0};  ///< m/s at the beginning, global map frame
  double braking = 0.0;        ///< m/s2, positive

  /// Returns the state at `time` of a vehicle that was at `pose` at the beginning. `time` must not
  /// be before the beginning.
  AgentState stateFrom(const Pose2& pose, double time) const;

  /// Returns the time from which on the vehicle stands, seconds.
  double standTime() const;
};

/// Returns the motion of an attacker after the end of its trajectory: straight on, with the hardest
/// braking of its class. `trajectory` must have points.
BrakingSlide slideFromEnd(const AttackerTrajectory& trajectory, const DriveLimitOptions& options);

}  // namespace forge
