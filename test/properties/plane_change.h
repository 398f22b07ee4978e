#pragma once

#include "properties/random_scenes.h"

namespace forge {

/// The same scene elsewhere: mirrored (y becomes -y) or not, then turned about the origin, moved,
/// and at another time.
struct PlaneChange {
  bool is_mirrored = false;
  double turn = 0.0;  ///< rad
  Vector2 shift = Vector2::Zero();
  double later = 0.0;  ///< s

  Vector2 direction(const Vector2& vector) const;
  Vector2 point(const Vector2& at) const { return direction(at) + shift; }
  double yaw(double of) const { return wrapAngle((is_mirrored ? -of : of) + turn); }
  Pose2 pose(const Pose2& of) const;
  AttackerTrajectory trajectory(AttackerTrajectory of) const;
  CollisionReport report(CollisionReport of) const;
  /// Recording, map, time and request.
  AskedMoment asked(AskedMoment of) const;
};

}  // namespace forge
