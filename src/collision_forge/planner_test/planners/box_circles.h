#pragma once

#include <array>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// A box as five circles: one in each corner, as wide as half of the box's shorter side and
/// touching the two edges there, and one in the middle that is as wide as the shorter side.
struct BoxCircles {
  static constexpr std::size_t kCorners = 4;

  std::array<Vector2, kCorners> corners;  ///< middles, m from that of the box; x along its heading
  double corner_radius = 0.0;             ///< m
  double middle_radius = 0.0;             ///< m
  double reach = 0.0;                     ///< m from the middle of the box to the farthest edge
};

BoxCircles circlesOf(const BoxSize& size);

/// The circles of a box at a place.
struct PlacedCircles {
  Vector2 middle{0.0, 0.0};
  std::array<Vector2, BoxCircles::kCorners> corners;
};

/// `heading` is a unit vector.
PlacedCircles placed(const BoxCircles& circles, const Vector2& middle, const Vector2& heading);

/// The least gap between a circle of one box and one of another, metres; negative where they
/// overlap.
double gapBetween(const BoxCircles& a, const PlacedCircles& a_there, const BoxCircles& b,
                  const PlacedCircles& b_there);

}  // namespace forge
