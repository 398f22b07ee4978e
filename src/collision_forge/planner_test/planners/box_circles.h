#pragma once

#include <array>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// Five circles that approximate a box: one in each corner with half the radius of the middle one,
/// tangent to the two edges there, and one in the middle whose diameter is the box's shorter side.
struct BoxCircles {
  /// Number of corner circles.
  static constexpr std::size_t kCorners = 4;

  /// m, centres in the frame of the box: origin in its middle, x along its heading, y to the left;
  /// front left, front right, rear left, rear right.
  std::array<Vector2, kCorners> corners;
  double corner_radius = 0.0;  ///< m, of each corner circle
  double middle_radius = 0.0;  ///< m, of the middle circle
  double reach = 0.0;          ///< m from the box's middle to the farthest point of any circle
};

/// Returns the five circles of a box of this size (m).
BoxCircles circlesOf(const BoxSize& size);

/// The centres of the five circles of a box at a pose; m, global map frame.
struct PlacedCircles {
  Vector2 middle{0.0, 0.0};  ///< of the middle circle, also the middle of the box
  std::array<Vector2, BoxCircles::kCorners> corners;  ///< in the order of BoxCircles::corners
};

/// Returns the centres of `circles` for a box whose middle is at `middle` (m, global map frame);
/// `heading`: direction of the box, must be a unit vector.
PlacedCircles placed(const BoxCircles& circles, const Vector2& middle, const Vector2& heading);

/// Returns the smallest gap between any circle of box `a` (placed at `a_there`) and any circle of
/// box `b` (at `b_there`), m; negative if circles overlap.
double gapBetween(const BoxCircles& a, const PlacedCircles& a_there, const BoxCircles& b,
                  const PlacedCircles& b_there);

}  // namespace forge
