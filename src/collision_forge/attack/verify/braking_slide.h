#pragma once

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Motion of a vehicle that brakes to a stop with constant heading and direction of travel.
struct BrakingSlide {
  double begin = 0.0;          ///< s
  Vector2 velocity{0.0, 0.0};  ///< m/s at `begin`, global map frame
  double braking = 0.0;        ///< m/s2, positive deceleration

  /// Returns the state at `time` (s, not before `begin`) of a vehicle whose pose at `begin` is
  /// `pose`.
  AgentState stateFrom(const Pose2& pose, double time) const;

  /// Returns the time (s) at which the vehicle stops.
  double standTime() const;
};

/// Returns the motion of an attacker after the end of its trajectory: straight on, with the maximum
/// braking of its vehicle class. `trajectory` must have points.
BrakingSlide slideFromEnd(const AttackerTrajectory& trajectory, const DriveLimitOptions& options);

}  // namespace forge
