#pragma once

#include <functional>

#include "properties/random_scenes.h"

namespace forge {

/// A change of a scene: mirrored (y becomes -y) or not, then turned about the origin, moved, and
/// shifted in time. The functions return the changed value.
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
  /// Changes recording, map, time and request.
  AskedMoment asked(AskedMoment of) const;
  /// Changes the request and the attack without its alternatives. A plausible attack may become
  /// implausible, because the cells of drivable ground are at other places.
  Scenario scenario(Scenario of) const;
};

/// Returns a shift in space (within 20 km, by whole cells of drivable ground, 0.5 m) and in time
/// (by whole clock steps).
PlaneChange elsewhere(Random& random);
PlaneChange turned(Random& random);
PlaneChange mirrored(Random& random);
/// Returns a change of all these kinds.
PlaneChange anyChange(Random& random);

using MakeChange = PlaneChange (*)(Random&);

/// Checks a property in random cases. Ten consecutive cases share the attack of one random request,
/// because the search takes most of the time; each has its own change.
void forChangedAnswers(
    const std::vector<Mode>& modes, MakeChange make,
    const std::function<void(const AskedMoment&, const Scenario&, const PlaneChange&)>& check);

}  // namespace forge
