#pragma once

#include <optional>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// A box moving from one pose to another in unit time: centre linear, yaw along the shorter turn.
/// Poses are box centres; both motions of a test are in one frame.
struct BoxMotion {
  Pose2 start;  ///< at time 0
  Pose2 end;    ///< at time 1
  BoxSize size;
};

/// Returns the first time in [0, 1] at which the moving boxes touch, by conservative advancement
/// (Mirtich 1996, section 2.3): each time step is the distance over a bound on the closing speed,
/// so no contact deeper than `tolerance` (m) is missed at any speed. At the returned time the boxes
/// overlap or are at most `tolerance` apart, and they never overlap before it; 0 if they touch at
/// the start, nullopt if they never do. `tolerance` is raised to 1e-6 m plus 1e-6 of the distance
/// moved, which bounds the work. Throws std::invalid_argument for a number that is not finite.
std::optional<double> firstContact(const BoxMotion& a, const BoxMotion& b, double tolerance = 1e-3);

}  // namespace forge
