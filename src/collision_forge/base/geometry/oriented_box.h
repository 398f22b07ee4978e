#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Length along x, width along y, metres.
struct BoxSize {
  double length = 0.0;
  double width = 0.0;
};

/// A rectangle on the ground; `center` is the middle of the rectangle, x along its length.
struct OrientedBox {
  Pose2 center;
  BoxSize size;
};

/// Corners counter-clockwise, front left first.
std::array<Vector2, 4> corners(const OrientedBox& box);

/// Nine places of a box for quick questions about the ground below it: the middle and what is 0.4
/// of the length ahead of it and behind, with what is 0.4 of the width to the right and left of
/// each.
inline constexpr std::size_t kBoxPlaces = 9;
std::array<Vector2, kBoxPlaces> placesOf(const OrientedBox& box);

/// The same box with every side moved inwards by `margin` (outwards if negative); sides stay >= 0.
OrientedBox shrunk(const OrientedBox& box, double margin);

/// The gap between two boxes' shadows on an axis.
struct AxisGap {
  Vector2 axis;      ///< unit vector, pointing from the first box's centre towards the second's
  double gap = 0.0;  ///< metres, negative where the shadows overlap
};

/// The gaps along both boxes' sides. The boxes share a point when no gap is positive (separating
/// axes); else their distance lies between the largest gap and sqrt(2) times that.
std::array<AxisGap, 4> axisGaps(const OrientedBox& a, const OrientedBox& b);

/// Shortest distance between a point and the rectangle, metres; 0 inside.
double distanceToPoint(const OrientedBox& box, const Vector2& point);

/// True when the closed rectangles share a point (separating axes).
bool overlaps(const OrientedBox& a, const OrientedBox& b);

/// Shortest distance between the rectangles, metres; 0 when they overlap.
double distance(const OrientedBox& a, const OrientedBox& b);

/// Area shared by both rectangles, square metres.
double intersectionArea(const OrientedBox& a, const OrientedBox& b);

/// Shared area over joint area, in [0, 1].
double intersectionOverUnion(const OrientedBox& a, const OrientedBox& b);

/// A side of a box, seen from its middle along its length.
enum class Side { kFront, kRear, kLeft, kRight };
const char* toString(Side side);
std::optional<Side> sideFromString(const std::string& name);

/// The side of `box` at which a box that touches it stands: of the lines along the sides, that with
/// most of `other` beyond it.
Side touchedSide(const OrientedBox& box, const OrientedBox& other);

/// The share of a side of `box` that `other` covers, seen along the side's normal, [0, 1]: 1 where
/// it covers the side from corner to corner, 0 where it stands beside it. `box` must have a size.
double sideOverlap(const OrientedBox& box, Side side, const OrientedBox& other);

/// Its front side, a box without length.
OrientedBox frontEdge(const OrientedBox& box);

/// Radius of the circle around the centre that holds the box, metres.
double circumradius(const BoxSize& size);

}  // namespace forge
