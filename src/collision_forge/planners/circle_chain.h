#pragma once

#include <vector>

#include "collision_forge/geometry/oriented_box.h"

namespace forge {

/// A box as a row of equal circles along its length, as wide as the box (or as long, if it is wider
/// than long), the outer ones touching its ends.
struct CircleChain {
  double radius = 0.0;  ///< m
  double reach = 0.0;   ///< m from the middle of the box to that of the outer circles
  int count = 0;
};

CircleChain circlesOf(const BoxSize& size, int count);

/// A chain at a place: the middles of its circles.
struct PlacedChain {
  Vector2 middle{0.0, 0.0};
  std::vector<Vector2> centers;
};

PlacedChain placed(const CircleChain& chain, const Pose2& pose);

/// The least distance of two circles' middles, metres.
double centerDistance(const PlacedChain& a, const PlacedChain& b);

}  // namespace forge
