#pragma once

#include <array>

#include "collision_forge/attack/severity/severity.h"

namespace forge {

/// Motion of a crashed vehicle or person on the road after an impact: a rigid body on four wheels
/// that roll, brake or are locked, each with Coulomb friction against its local sliding velocity. A
/// person on foot, animal, rider (motorcycle, bicycle, scooter) or object has no wheels and slides
/// on the same four points.
class SlidingBody {
 public:
  /// `party`: state at the impact; the body starts without yaw rate and with unlocked wheels.
  /// Keeps no references.
  SlidingBody(const CrashedVehicle& party, const SeverityOptions& options);

  /// Adds the change of motion by an impact. The wheels of the end of the vehicle (rear if `point`
  /// is behind the box centre, else front) that faces `point` (m, map frame) are locked from then
  /// on if the change of velocity is at least AfterImpactOptions::locking_delta_v.
  void hit(const ImpactChange& change, const Vector2& point);

  /// Moves the body by `duration` (s, at most 0.01 for a stable integration). `is_braking`: the
  /// driver brakes all wheels.
  void move(double duration, bool is_braking);

  /// Returns true if the body is slower than 0.03 m/s and turns by less than 0.02 rad/s.
  bool stands() const;

  /// Returns the present motion, global map frame.
  const ImpactBody& body() const { return body_; }
  /// Returns the pose of the box centre, which is the centre of mass; global map frame. The yaw is
  /// not wrapped.
  const Pose2& pose() const { return pose_; }

 private:
  Vector2 wheelForce(const Vector2& velocity, double load, bool is_locked, bool is_braking) const;

  ImpactBody body_;
  Pose2 pose_;
  BoxSize size_;
  AfterImpactOptions options_;
  bool has_wheels_ = true;
  std::array<bool, 2> locked_ = {false, false};  // front axle, rear axle
};

}  // namespace forge
