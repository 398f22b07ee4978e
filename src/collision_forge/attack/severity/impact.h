#pragma once

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// A rigid vehicle at the instant of an impact; global map frame.
struct ImpactBody {
  double mass = 0.0;           ///< kg
  double yaw_inertia = 0.0;    ///< kg m2 about the centre of mass
  Vector2 center{0.0, 0.0};    ///< m, centre of mass
  Vector2 velocity{0.0, 0.0};  ///< m/s of the centre of mass
  double yaw_rate = 0.0;       ///< rad/s, counter-clockwise
};

/// Where and how two bodies touch; global map frame.
struct ImpactContact {
  Vector2 point{0.0, 0.0};   ///< m, where the impulse acts on both bodies
  Vector2 normal{1.0, 0.0};  ///< of the contact plane, of length 1; either direction
  double restitution = 0.0;  ///< 0..1, share of the closing speed along the normal that is left
  double friction = 0.0;     ///< >= 0, largest ratio of tangential to normal impulse
};

/// Change of a body's motion by the impulse: value after minus value before, global map frame.
struct ImpactChange {
  Vector2 velocity{0.0, 0.0};  ///< m/s of the centre of mass
  double yaw_rate = 0.0;       ///< rad/s
};

/// Result of planarImpact().
struct Impact {
  Vector2 impulse{0.0, 0.0};  ///< N s on the first body; the second gets the opposite
  ImpactChange first;
  ImpactChange second;
  double energy_lost = 0.0;  ///< J, >= 0
  /// Tangential over normal impulse; 0 if there is no impulse. The normal points from the first to
  /// the second body, the tangent is left of the normal.
  double impulse_ratio = 0.0;
};

/// Returns the velocity (m/s, global map frame) of the first body relative to the second at `point`
/// (m, map frame), yaw rates included.
Vector2 contactVelocity(const ImpactBody& first, const ImpactBody& second, const Vector2& point);

/// Returns the impulse between two bodies: planar impulse-momentum model (R. M. Brach, "Energy loss
/// in vehicle collisions", SAE 871993, and Accident Analysis and Prevention 15, 1983). The
/// tangential impulse stops the sliding between the bodies, but is at most `friction` times the
/// normal impulse. The impulse and all changes are zero if the bodies do not approach each other at
/// the contact point along the normal. If `restitution` would add energy, which can happen if the
/// contact is far from the centres of mass, it counts as 0. Throws std::invalid_argument, naming
/// body and field, for a mass or inertia that is not positive, a number that is not finite, or a
/// contact out of the ranges above.
Impact planarImpact(const ImpactBody& first, const ImpactBody& second,
                    const ImpactContact& contact);

}  // namespace forge
