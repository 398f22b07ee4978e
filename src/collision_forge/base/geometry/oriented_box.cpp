#include "collision_forge/base/geometry/oriented_box.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/geometry/enum_words.h"

namespace forge {
namespace {

constexpr EnumWord<Side> kSideWords[] = {
    {Side::kFront, "front"},
    {Side::kRear, "rear"},
    {Side::kLeft, "left"},
    {Side::kRight, "right"},
};

Vector2 leftOf(const Vector2& direction) { return {-direction.y(), direction.x()}; }

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

double squaredDistance(const OrientedBox& box, const Vector2& forward, const Vector2& point) {
  const Vector2 offset = point - box.center.position();
  const double along = std::abs(offset.dot(forward)) - 0.5 * box.size.length;
  const double across = std::abs(offset.dot(leftOf(forward))) - 0.5 * box.size.width;
  return Vector2(std::max(along, 0.0), std::max(across, 0.0)).squaredNorm();
}

// A convex outline of at most 8 corners: a rectangle cut by the 4 sides of another.
struct Outline {
  std::array<Vector2, 8> points;
  std::size_t size = 0;

  void add(const Vector2& point) {
    if (size < points.size()) {
      points[size++] = point;
    }
  }
};

// Returns the part of the outline where normal * point <= limit (Sutherland-Hodgman).
Outline clipped(const Outline& outline, const Vector2& normal, double limit) {
  Outline result;
  for (std::size_t i = 0; i < outline.size; ++i) {
    const Vector2& a = outline.points[i];
    const Vector2& b = outline.points[i + 1 == outline.size ? 0 : i + 1];
    const double a_excess = normal.dot(a) - limit;
    const double b_excess = normal.dot(b) - limit;
    if (a_excess <= 0.0) {
      result.add(a);
    }
    if ((a_excess < 0.0 && b_excess > 0.0) || (a_excess > 0.0 && b_excess < 0.0)) {
      result.add(a + a_excess / (a_excess - b_excess) * (b - a));
    }
  }
  return result;
}

double area(const Outline& outline) {
  double doubled = 0.0;
  for (std::size_t i = 0; i + 2 < outline.size; ++i) {
    doubled +=
        cross(outline.points[i + 1] - outline.points[0], outline.points[i + 2] - outline.points[0]);
  }
  return 0.5 * std::max(doubled, 0.0);
}

/// Returns the intersection relative to b's centre, so that large map coordinates cost no
/// precision.
Outline sharedOutline(const OrientedBox& a, const OrientedBox& b) {
  const Vector2 origin = b.center.position();
  Outline outline;
  for (const Vector2& corner : corners(a)) {
    outline.add(corner - origin);
  }
  const Vector2 forward = b.center.heading();
  const Vector2 left = leftOf(forward);
  outline = clipped(outline, forward, 0.5 * b.size.length);
  outline = clipped(outline, -forward, 0.5 * b.size.length);
  outline = clipped(outline, left, 0.5 * b.size.width);
  return clipped(outline, -left, 0.5 * b.size.width);
}

/// The bounds of a box in the axes of a frame.
struct LocalExtent {
  Vector2 low = Vector2::Constant(1e9);
  Vector2 high = Vector2::Constant(-1e9);
};

LocalExtent extentOf(const OrientedBox& box, const Pose2& frame) {
  LocalExtent extent;
  for (const Vector2& corner : corners(box)) {
    const Vector2 local = relativeTo(frame, {corner.x(), corner.y(), 0.0}).position();
    extent.low = extent.low.cwiseMin(local);
    extent.high = extent.high.cwiseMax(local);
  }
  return extent;
}

}  // namespace

std::array<Vector2, 4> corners(const OrientedBox& box) {
  const Vector2 heading = box.center.heading();
  const Vector2 forward = 0.5 * box.size.length * heading;
  const Vector2 left = 0.5 * box.size.width * leftOf(heading);
  const Vector2 middle = box.center.position();
  return {middle + forward + left, middle - forward + left, middle - forward - left,
          middle + forward - left};
}

std::array<Vector2, kBoxSamples> samplePointsOf(const OrientedBox& box) {
  const Vector2 ahead = box.center.heading();
  const Vector2 along = 0.4 * box.size.length * ahead;
  const Vector2 across = 0.4 * box.size.width * leftOf(ahead);
  std::array<Vector2, kBoxSamples> places;
  std::size_t count = 0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      places[count++] = box.center.position() + x * along + y * across;
    }
  }
  return places;
}

OrientedBox shrunk(const OrientedBox& box, double margin) {
  return {box.center,
          {std::max(box.size.length - 2.0 * margin, 0.0),
           std::max(box.size.width - 2.0 * margin, 0.0)}};
}

std::array<AxisGap, 4> axisGaps(const OrientedBox& a, const OrientedBox& b) {
  const Vector2 a_forward = a.center.heading();
  const Vector2 b_forward = b.center.heading();
  const Vector2 offset = b.center.position() - a.center.position();
  const double cosine = std::abs(a_forward.dot(b_forward));
  const double sine = std::abs(cross(a_forward, b_forward));
  const Vector2 a_half(0.5 * a.size.length, 0.5 * a.size.width);
  const Vector2 b_half(0.5 * b.size.length, 0.5 * b.size.width);

  const auto gap_along = [&](const Vector2& axis, double reach) {
    const double shift = axis.dot(offset);
    return AxisGap{shift < 0.0 ? Vector2(-axis) : axis, std::abs(shift) - reach};
  };
  return {gap_along(a_forward, a_half.x() + b_half.x() * cosine + b_half.y() * sine),
          gap_along(leftOf(a_forward), a_half.y() + b_half.x() * sine + b_half.y() * cosine),
          gap_along(b_forward, b_half.x() + a_half.x() * cosine + a_half.y() * sine),
          gap_along(leftOf(b_forward), b_half.y() + a_half.x() * sine + a_half.y() * cosine)};
}

double distanceToPoint(const OrientedBox& box, const Vector2& point) {
  return std::sqrt(squaredDistance(box, box.center.heading(), point));
}

bool overlaps(const OrientedBox& a, const OrientedBox& b) {
  const auto gaps = axisGaps(a, b);
  return std::all_of(gaps.begin(), gaps.end(), [](const AxisGap& g) { return g.gap <= 0.0; });
}

double distance(const OrientedBox& a, const OrientedBox& b) {
  if (overlaps(a, b)) {
    return 0.0;
  }
  // Two disjoint convex outlines are closest at a corner of one of them.
  const auto a_corners = corners(a);
  const auto b_corners = corners(b);
  const Vector2 a_forward = a.center.heading();
  const Vector2 b_forward = b.center.heading();
  double squared = squaredDistance(a, a_forward, b_corners[0]);
  for (std::size_t i = 0; i < 4; ++i) {
    squared = std::min({squared, squaredDistance(a, a_forward, b_corners[i]),
                        squaredDistance(b, b_forward, a_corners[i])});
  }
  return std::sqrt(squared);
}

double intersectionArea(const OrientedBox& a, const OrientedBox& b) {
  return overlaps(a, b) ? area(sharedOutline(a, b)) : 0.0;
}

std::optional<Vector2> intersectionCentroid(const OrientedBox& a, const OrientedBox& b) {
  const Outline outline = sharedOutline(a, b);
  if (area(outline) <= 0.0) return std::nullopt;
  Vector2 moment = Vector2::Zero();
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < outline.size; ++i) {
    const std::array<Vector2, 3> corners = {outline.points[0], outline.points[i + 1],
                                            outline.points[i + 2]};
    const double doubled = cross(corners[1] - corners[0], corners[2] - corners[0]);
    moment += doubled * (corners[0] + corners[1] + corners[2]) / 3.0;
    sum += doubled;
  }
  return b.center.position() + moment / sum;
}

double intersectionOverUnion(const OrientedBox& a, const OrientedBox& b) {
  const double shared = intersectionArea(a, b);
  const double joint = a.size.length * a.size.width + b.size.length * b.size.width - shared;
  return joint > 0.0 ? std::min(shared / joint, 1.0) : 0.0;
}

const char* toString(Side side) { return wordOf(kSideWords, side); }

std::optional<Side> sideFromString(const std::string& name) { return valueOf(kSideWords, name); }

Side touchedSide(const OrientedBox& box, const OrientedBox& other) {
  const LocalExtent extent = extentOf(other, box.center);
  const double length = 0.5 * box.size.length;
  const double width = 0.5 * box.size.width;
  const std::array<std::pair<double, Side>, 4> gaps = {{{extent.low.x() - length, Side::kFront},
                                                        {-extent.high.x() - length, Side::kRear},
                                                        {extent.low.y() - width, Side::kLeft},
                                                        {-extent.high.y() - width, Side::kRight}}};
  return std::max_element(gaps.begin(), gaps.end(),
                          [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

double sideOverlap(const OrientedBox& box, Side side, const OrientedBox& other) {
  const bool is_across = side == Side::kFront || side == Side::kRear;
  const int axis = is_across ? 1 : 0;
  const double side_length = is_across ? box.size.width : box.size.length;
  const LocalExtent extent = extentOf(other, box.center);
  const double covered = std::min(extent.high[axis], 0.5 * side_length) -
                         std::max(extent.low[axis], -0.5 * side_length);
  return std::clamp(covered / side_length, 0.0, 1.0);
}

OrientedBox frontEdge(const OrientedBox& box) {
  return {compose(box.center, {0.5 * box.size.length, 0.0, 0.0}), {0.0, box.size.width}};
}

double circumradius(const BoxSize& size) { return 0.5 * std::hypot(size.length, size.width); }

}  // namespace forge
