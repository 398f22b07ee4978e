#include "collision_forge/base/geometry/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "collision_forge/base/geometry/segment.h"

namespace forge {
namespace {

constexpr double kCoincidence = 1e-6;  // m; closer points are merged

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

double yawOf(const Vector2& direction) { return std::atan2(direction.y(), direction.x()); }

// The closest point: on segment `segment`, at share `ratio` of its length.
struct ClosestPoint {
  std::size_t segment = 0;
  double ratio = 0.0;
  double squared_distance = std::numeric_limits<double>::infinity();
};

ClosestPoint closestPoint(const std::vector<Vector2>& points, const Vector2& query) {
  ClosestPoint best;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vector2 span = points[i + 1] - points[i];
    const Vector2 offset = query - points[i];
    const double ratio = nearestShare(points[i], points[i + 1], query);
    const double squared_distance = (offset - ratio * span).squaredNorm();
    if (squared_distance < best.squared_distance) {
      best = {i, ratio, squared_distance};
    }
  }
  return best;
}

}  // namespace

Polyline::Polyline(const std::vector<Vector2>& points) {
  for (const Vector2& point : points) {
    if (!point.allFinite()) {
      throw std::invalid_argument("polyline point is not finite");
    }
    const double step = points_.empty() ? 0.0 : (point - points_.back()).norm();
    if (points_.empty() || step > kCoincidence) {
      arc_lengths_.push_back(points_.empty() ? 0.0 : arc_lengths_.back() + step);
      points_.push_back(point);
    }
  }
  if (points_.size() < 2) {
    throw std::invalid_argument("polyline needs two distinct points");
  }
}

Pose2 Polyline::poseAt(double arc_length) const {
  const auto next = std::upper_bound(arc_lengths_.begin() + 1, arc_lengths_.end() - 1, arc_length);
  const std::size_t i = static_cast<std::size_t>(next - arc_lengths_.begin()) - 1;
  const Vector2 direction = (points_[i + 1] - points_[i]).normalized();
  const Vector2 position = points_[i] + (arc_length - arc_lengths_[i]) * direction;
  const double yaw = yawOf(direction);

  // The neighbouring segment on this half's side, if any, and the arc length of its middle.
  const double middle = 0.5 * (arc_lengths_[i] + arc_lengths_[i + 1]);
  const bool before = arc_length < middle;
  if (before ? i == 0 : i + 2 == points_.size()) {
    return {position.x(), position.y(), yaw};
  }
  const std::size_t j = before ? i - 1 : i + 1;
  const double other_middle = 0.5 * (arc_lengths_[j] + arc_lengths_[j + 1]);
  const double ratio = (arc_length - middle) / (other_middle - middle);
  const double turn = angleBetween(yaw, yawOf(points_[j + 1] - points_[j]));
  return {position.x(), position.y(), wrapAngle(yaw + ratio * turn)};
}

PolylineProjection Polyline::project(const Vector2& point) const {
  const ClosestPoint closest = closestPoint(points_, point);
  const std::size_t i = closest.segment;
  const Vector2 span = points_[i + 1] - points_[i];
  const Vector2 offset = point - (points_[i] + closest.ratio * span);
  const bool beyond_start = i == 0 && closest.ratio == 0.0;
  const bool beyond_end = i + 2 == points_.size() && closest.ratio == 1.0;

  PolylineProjection projection;
  projection.arc_length = arc_lengths_[i] + closest.ratio * (arc_lengths_[i + 1] - arc_lengths_[i]);
  projection.distance = std::sqrt(closest.squared_distance);
  projection.pose = poseAt(projection.arc_length);
  if (beyond_start || beyond_end) {
    projection.lateral = cross(span.normalized(), offset);
    return projection;
  }
  // At a vertex the side follows from the mean of the two directions: either direction alone is
  // wrong on the outside of a turn sharper than a right angle.
  Vector2 tangent = span.normalized();
  if (closest.ratio == 0.0) {
    tangent += (points_[i] - points_[i - 1]).normalized();
  } else if (closest.ratio == 1.0) {
    tangent += (points_[i + 2] - points_[i + 1]).normalized();
  }
  projection.lateral = std::copysign(projection.distance, cross(tangent, offset));
  return projection;
}

}  // namespace forge
