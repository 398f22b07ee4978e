#pragma once

#include <functional>

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
  /// What was asked for, and the answer's attack without its alternatives. A believable attack may
  /// be none elsewhere, where cells of drivable ground lie otherwise.
  Scenario scenario(Scenario of) const;
};

/// Within 20 km, by whole cells of drivable ground, which lie at half metres of the map's frame,
/// and on the clock's steps.
PlaneChange elsewhere(Random& random);
PlaneChange turned(Random& random);
PlaneChange mirrored(Random& random);
/// All of these at once.
PlaneChange anyChange(Random& random);

using MakeChange = PlaneChange (*)(Random&);

/// Tries a property on every case: ten in a row have the answer to the same random request, which
/// costs most, each with a change of its own.
void forChangedAnswers(
    const std::vector<Mode>& modes, MakeChange make,
    const std::function<void(const AskedMoment&, const Scenario&, const PlaneChange&)>& check);

}  // namespace forge
