#pragma once

#include <optional>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// A box moving from one pose to another in unit time: centre linear, yaw along the shorter turn.
struct BoxMotion {
  Pose2 start;
  Pose2 end;
  BoxSize size;
};

/// First instant in [0, 1] at which the two moving boxes touch, found by conservative advancement
/// (Mirtich 1996, section 2.3): the time step is the distance over a bound on the closing speed, so
/// no contact deeper than `tolerance` metres is stepped over, whatever the speed.
/// At the instant returned the boxes overlap or are at most `tolerance` apart, and at none before
/// it do they overlap; 0 when they touch at the start. Empty when they stay apart. The tolerance is
/// raised to a micrometre plus a millionth of the way moved, which bounds the work. Throws
/// std::invalid_argument for a number that is not finite.
std::optional<double> firstContact(const BoxMotion& a, const BoxMotion& b, double tolerance = 1e-3);

}  // namespace forge
