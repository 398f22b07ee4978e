#pragma once

#include <array>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// Five circles that approximate a box: one in each corner with half the radius of the middle one,
/// tangent to the two edges there, and one in the middle whose diameter is the box's shorter side.
struct BoxCircles {
  static constexpr std::size_t kCorners = 4;

  std::array<Vector2, kCorners>
      corners;                 ///< m, centres relative to the box's middle; x along its heading
  double corner_radius = 0.0;  ///< m
  double middle_radius = 0.0;  ///< m
  double reach = 0.0;          ///< m from the box's middle to the farthest edge of a circle
};

/// Computes the five circles of a box of this size.
BoxCircles circlesOf(const BoxSize& size);

/// The centres of the five circles of a box at a pose; m, global map frame.
struct PlacedCircles {
  Vector2 middle{0.0, 0.0};
  std::array<Vector2, BoxCircles::kCorners> corners;
};

/// Places `circles` at the box's middle `middle` (m); `heading` must be a unit vector.
PlacedCircles placed(const BoxCircles& circles, const Vector2& middle, const Vector2& heading);

/// Returns the smallest gap between any circle of box `a` and any circle of box `b`, m; negative if
/// they overlap.
double gapBetween(const BoxCircles& a, const PlacedCircles& a_there, const BoxCircles& b,
                  const PlacedCircles& b_there);

}  // namespace forge
