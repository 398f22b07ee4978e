#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Size of a box: length along x, width along y, metres.
struct BoxSize {
  double length = 0.0;
  double width = 0.0;
};

/// A rectangle on the ground, x along its length. Functions of two boxes need both in one frame.
struct OrientedBox {
  Pose2 center;  ///< centre of the rectangle; the yaw is the direction of its length
  BoxSize size;
};

/// Returns the corners counter-clockwise, front left first, in the frame of `box.center`.
std::array<Vector2, 4> corners(const OrientedBox& box);

/// Number of the sample points of samplePointsOf().
inline constexpr std::size_t kBoxSamples = 9;
/// Returns sample points of a box for quick queries about the ground below it: a grid of three by
/// three, spaced 0.4 of the length and 0.4 of the width around the centre, rear row first, each row
/// from right to left, in the frame of `box.center`.
std::array<Vector2, kBoxSamples> samplePointsOf(const OrientedBox& box);

/// Returns the box with every side moved inwards by `margin` (m; outwards if negative); sides stay
/// >= 0.
OrientedBox shrunk(const OrientedBox& box, double margin);

/// The gap between the projections of two boxes on an axis.
struct AxisGap {
  Vector2 axis;      ///< unit vector, pointing from the first box's centre towards the second's
  double gap = 0.0;  ///< m, negative by the depth of the overlap if the projections overlap
};

/// Returns the gaps along the x and y axis of `a`, then of `b` (separating axes). The boxes share a
/// point if no gap is positive; else their distance is between the largest gap and sqrt(2) times
/// that.
std::array<AxisGap, 4> axisGaps(const OrientedBox& a, const OrientedBox& b);

/// Returns the shortest distance (m) between a point and the rectangle; 0 inside.
double distanceToPoint(const OrientedBox& box, const Vector2& point);

/// Returns true if the closed rectangles share a point (separating axes).
bool overlaps(const OrientedBox& a, const OrientedBox& b);

/// Returns the shortest distance (m) between the rectangles; 0 if they overlap.
double distance(const OrientedBox& a, const OrientedBox& b);

/// Returns the area (m2) of the intersection of the rectangles.
double intersectionArea(const OrientedBox& a, const OrientedBox& b);

/// Returns the centroid of the intersection of the rectangles; nullopt if its area is 0.
std::optional<Vector2> intersectionCentroid(const OrientedBox& a, const OrientedBox& b);

/// Returns the area of the intersection over the area of the union, [0, 1]; 0 if both areas are 0.
double intersectionOverUnion(const OrientedBox& a, const OrientedBox& b);

/// A side of a box, in the box's frame: the front is the side at positive x, left at positive y.
enum class Side { kFront, kRear, kLeft, kRight };
/// Returns "front", "rear", "left" or "right".
const char* toString(Side side);
/// Returns the side of a name as toString() spells it; nullopt for another name.
std::optional<Side> sideFromString(const std::string& name);

/// Returns the side of `box` that `other` touches: the side beyond whose line `other` lies farthest
/// (for boxes that overlap: the side with the least depth), the first of equals in the order of
/// Side. Intended for boxes that just touch.
Side touchedSide(const OrientedBox& box, const OrientedBox& other);

/// Returns the share, [0, 1], of a side of `box` that `other` covers in projection on the side,
/// however far away it is: 1 if it covers the side from corner to corner, 0 if not at all. `box`
/// must have a size above 0.
double sideOverlap(const OrientedBox& box, Side side, const OrientedBox& other);

/// Returns the front side of `box`, as a box of length 0 with the same width and yaw.
OrientedBox frontEdge(const OrientedBox& box);

/// Returns the radius (m) of the circle around the centre that contains the box.
double circumradius(const BoxSize& size);

}  // namespace forge
