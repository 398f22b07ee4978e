#include "collision_forge/planner_test/planners/pdm_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "collision_forge/base/geometry/segment.h"

namespace forge {
namespace {

constexpr std::size_t kPieces = 16;  // pieces per stretch

bool touchesSquareAt(const Vector2& end, const Vector2& outward, double half_width,
                     const OrientedBox& box) {
  const Vector2 middle = end + 0.5 * half_width * outward;
  const double reach =
      circumradius(box.size) + 1.5 * half_width;  // exceeds the circumradius of the square
  if ((box.center.position() - middle).squaredNorm() > reach * reach) return false;
  const double yaw = std::atan2(outward.y(), outward.x());
  return overlaps({{middle.x(), middle.y(), yaw}, {half_width, 2.0 * half_width}}, box);
}

/// Returns whether a segment touches the rectangle around the origin with these half extents.
bool crosses(const Vector2& from, const Vector2& to, const Vector2& half) {
  const Vector2 span = to - from;
  double first = 0.0;
  double last = 1.0;
  for (const int axis : {0, 1}) {
    if (span[axis] == 0.0) {
      if (std::abs(from[axis]) > half[axis]) return false;
      continue;
    }
    const double low = (-half[axis] - from[axis]) / span[axis];
    const double high = (half[axis] - from[axis]) / span[axis];
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  return first <= last;
}

/// Returns the distance between such a rectangle and a segment. If apart, the closest points
/// include an end of the segment or a corner.
double squaredGap(const Vector2& from, const Vector2& to, const Vector2& half) {
  if (crosses(from, to, half)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2& end : {from, to}) {
    least = std::min(least, (end.cwiseAbs() - half).cwiseMax(0.0).squaredNorm());
  }
  for (const Vector2& corner :
       {half, Vector2(-half), Vector2(half.x(), -half.y()), Vector2(-half.x(), half.y())}) {
    const double share = nearestShare(from, to, corner);
    least = std::min(least, (from + share * (to - from) - corner).squaredNorm());
  }
  return least;
}

}  // namespace

PdmPath::PdmPath(std::vector<Pose2> nodes) : nodes_(std::move(nodes)) {
  progress_.reserve(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (i == 0) {
      progress_.push_back(0.0);
      continue;
    }
    Pose2& node = nodes_[i];
    const Pose2& before = nodes_[i - 1];
    node.yaw = before.yaw + angleBetween(before.yaw, node.yaw);
    progress_.push_back(progress_.back() + (node.position() - before.position()).norm());
  }
  if (nodes_.empty() || !(length() > 0.0)) {
    throw std::invalid_argument("a path needs at least two distinct points");
  }
  for (std::size_t first = 0; first + 1 < nodes_.size(); first += kPieces) {
    Stretch stretch{first, std::min(first + kPieces, nodes_.size() - 1), {}};
    for (std::size_t i = first; i <= stretch.last; ++i) {
      stretch.bounds.extend(nodes_[i].position());
    }
    stretches_.push_back(stretch);
  }
}

Pose2 PdmPath::at(double progress) const {
  const double place = std::clamp(progress, 0.0, length());
  const auto after = std::upper_bound(progress_.begin(), progress_.end() - 1, place);
  const auto next =
      static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - progress_.begin(), 1));
  const Pose2& a = nodes_[next - 1];
  const Pose2& b = nodes_[next];
  const double span = progress_[next] - progress_[next - 1];
  const double ratio = span > 0.0 ? (place - progress_[next - 1]) / span : 0.0;
  return {a.x + ratio * (b.x - a.x), a.y + ratio * (b.y - a.y),
          wrapAngle(a.yaw + ratio * (b.yaw - a.yaw))};
}

double PdmPath::project(const Vector2& point) const {
  double least = std::numeric_limits<double>::infinity();
  double progress = 0.0;
  for (const Stretch& stretch : stretches_) {
    if (stretch.bounds.squaredExteriorDistance(point) >= least) continue;
    for (std::size_t i = stretch.first; i < stretch.last; ++i) {
      const Vector2 from = nodes_[i].position();
      const Vector2 to = nodes_[i + 1].position();
      const double share = nearestShare(from, to, point);
      const double squared = (from + share * (to - from) - point).squaredNorm();
      if (squared >= least) continue;
      least = squared;
      progress = progress_[i] + share * (progress_[i + 1] - progress_[i]);
    }
  }
  return progress;
}

PdmPath PdmPath::shifted(double lateral) const {
  std::vector<Pose2> nodes;
  nodes.reserve(nodes_.size());
  for (const Pose2& node : nodes_) nodes.push_back(compose(node, {0.0, lateral, 0.0}));
  return PdmPath(std::move(nodes));
}

PdmPath PdmPath::ahead(double progress) const {
  auto first = static_cast<std::size_t>(
      std::upper_bound(progress_.begin(), progress_.end(), progress) - progress_.begin());
  first = std::min(first, nodes_.size() - 1);
  while (first > 0 && !(progress_.back() - progress_[first] > 0.0)) --first;
  return PdmPath({nodes_.begin() + static_cast<std::ptrdiff_t>(first), nodes_.end()});
}

bool PdmPath::corridorTouches(const OrientedBox& box, double half_width) const {
  const Vector2 middle = box.center.position();
  const Vector2 half(0.5 * box.size.length, 0.5 * box.size.width);
  const Vector2 heading = box.center.heading();
  const auto seen = [&](const Vector2& point) -> Vector2 {
    const Vector2 offset = point - middle;
    return {heading.dot(offset), heading.x() * offset.y() - heading.y() * offset.x()};
  };
  const double reach = half.norm() + half_width;
  for (const Stretch& stretch : stretches_) {
    if (stretch.bounds.squaredExteriorDistance(middle) > reach * reach) continue;
    Vector2 from = seen(nodes_[stretch.first].position());
    for (std::size_t i = stretch.first; i < stretch.last; ++i) {
      const Vector2 to = seen(nodes_[i + 1].position());
      const Vector2 nearest = from + nearestShare(from, to, {0.0, 0.0}) * (to - from);
      const bool may_touch = nearest.squaredNorm() <= reach * reach;
      if (may_touch && squaredGap(from, to, half) <= half_width * half_width) return true;
      from = to;
    }
  }
  const auto outward = [&](std::size_t end, std::size_t inner) -> Vector2 {
    return (nodes_[end].position() - nodes_[inner].position()).normalized();
  };
  const std::size_t last = nodes_.size() - 1;
  return touchesSquareAt(nodes_[0].position(), outward(0, 1), half_width, box) ||
         touchesSquareAt(nodes_[last].position(), outward(last, last - 1), half_width, box);
}

}  // namespace forge
