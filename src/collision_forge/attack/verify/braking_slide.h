#pragma once

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Motion of a vehicle that brakes to a stop with constant heading and direction of travel. Times
/// are on the scene clock.
struct StraightBraking {
  double begin = 0.0;          ///< s, scene clock: start of the braking
  Vector2 velocity{0.0, 0.0};  ///< m/s at `begin`, global map frame
  double braking = 0.0;        ///< m/s2, deceleration; must be positive if the vehicle moves

  /// Returns the state at `time` (s, not before `begin`) of a vehicle whose pose at `begin` is
  /// `pose`; the vehicle stands from standTime() on.
  AgentState stateFrom(const Pose2& pose, double time) const;

  /// Returns the time (s) at which the vehicle stops; `begin` if it stands already.
  double standTime() const;
};

/// Returns the motion of an attacker after the last point of its trajectory: from the time and
/// speed of that point straight on along its heading, with the maximum braking of its vehicle
/// class. `trajectory` must have points.
StraightBraking brakingFromEnd(const AttackerTrajectory& trajectory,
                               const DriveLimitOptions& options);

}  // namespace forge
