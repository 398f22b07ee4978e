#pragma once

#include "collision_forge/scene/attack.h"
#include "collision_forge/verify/drive_limits.h"

namespace forge {

/// What vehicles do where nothing says what they drive: they slide on without turning and brake to
/// a stand.
struct BrakingSlide {
  double begin = 0.0;          ///< seconds
  Vector2 velocity{0.0, 0.0};  ///< m/s at the beginning, global map frame
  double braking = 0.0;        ///< m/s2, positive

  /// Where what was at `pose` at the beginning is at `time`, and how fast; not before the
  /// beginning.
  AgentState stateFrom(const Pose2& pose, double time) const;
};

/// An attacker after the end of its trajectory: straight on, braking as hard as its class can.
BrakingSlide slideFromEnd(const AttackerTrajectory& trajectory, const DriveLimitOptions& options);

/// Ego and attacker after their contact, as if they were one: with the velocity that keeps their
/// momentum, masses as their boxes' areas, braking as hard as the weaker of the two can. It shows a
/// crash and is no model of one. The contact is within the trajectory and the ego's track.
BrakingSlide slideFromContact(double contact_time, const AttackerTrajectory& trajectory,
                              const Track& ego, const DriveLimitOptions& options);

}  // namespace forge
