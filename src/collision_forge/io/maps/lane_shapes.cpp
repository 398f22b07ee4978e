#include "collision_forge/io/maps/lane_shapes.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/geometry/polyline.h"

namespace forge {
namespace {

constexpr double kSamePoint = 0.01;  // m; closer points give no reliable heading

/// Returns the points that are not close to the kept point before them. The last point of the line
/// replaces the last kept one, unless only two are kept.
std::vector<Vector2> distinctPoints(const std::vector<Vector2>& line) {
  std::vector<Vector2> distinct;
  for (const Vector2& point : line) {
    if (distinct.empty() || (point - distinct.back()).norm() > kSamePoint) {
      distinct.push_back(point);
    }
  }
  if (distinct.size() > 2) distinct.back() = line.back();
  return distinct;
}

}  // namespace

std::vector<Vector2> middleOf(const LaneBounds& bounds) {
  const std::vector<Vector2>& left = bounds.left;
  const std::vector<Vector2>& right = bounds.right;
  std::vector<Vector2> middle;
  std::size_t l = 0;
  std::size_t r = 0;
  const auto add = [&] { middle.push_back(0.5 * (left[l] + right[r])); };
  add();
  while (l + 1 < left.size() || r + 1 < right.size()) {
    const bool is_left_next = r + 1 == right.size() ||
                              (l + 1 < left.size() && (left[l + 1] - right[r]).squaredNorm() <=
                                                          (left[l] - right[r + 1]).squaredNorm());
    ++(is_left_next ? l : r);
    add();
  }
  return middle;
}

std::vector<Pose2> posesAlong(const std::vector<Vector2>& line, double spacing, int max_poses) {
  const std::vector<Vector2> points = distinctPoints(line);
  if (points.size() < 2) return {};
  double count = 1.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    count += std::ceil((points[i] - points[i - 1]).norm() / spacing);
  }
  if (!(count <= max_poses)) return {};
  std::vector<Vector2> dense = {points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector2 step = points[i] - points[i - 1];
    const double pieces = std::ceil(step.norm() / spacing);
    for (double piece = 1.0; piece <= pieces; ++piece) {
      dense.push_back(points[i - 1] + piece / pieces * step);
    }
  }
  const Polyline smooth(dense);
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < smooth.points().size(); ++i) {
    const Vector2& point = smooth.points()[i];
    poses.push_back({point.x(), point.y(), smooth.poseAt(smooth.arcLengths()[i]).yaw});
  }
  return poses;
}

std::vector<Vector2> outlineOf(const LaneBounds& bounds) {
  std::vector<Vector2> outline = bounds.left;
  outline.insert(outline.end(), bounds.right.rbegin(), bounds.right.rend());
  return outline;
}

LaneBounds reversedBounds(const LaneBounds& bounds) {
  return {{bounds.right.rbegin(), bounds.right.rend()}, {bounds.left.rbegin(), bounds.left.rend()}};
}

}  // namespace forge
