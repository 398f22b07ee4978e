#include "collision_forge/planners/pdm_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace forge {
namespace {

constexpr std::size_t kPieces = 16;  // of a stretch

/// The place on a piece nearest to the point, as a share of the piece.
double nearestShare(const Vector2& from, const Vector2& to, const Vector2& point) {
  const Vector2 span = to - from;
  const double squared = span.squaredNorm();
  return squared > 0.0 ? std::clamp((point - from).dot(span) / squared, 0.0, 1.0) : 0.0;
}

bool touchesSquareAt(const Vector2& end, const Vector2& outward, double half_width,
                     const OrientedBox& box) {
  const Vector2 middle = end + 0.5 * half_width * outward;
  const double yaw = std::atan2(outward.y(), outward.x());
  return overlaps({{middle.x(), middle.y(), yaw}, {half_width, 2.0 * half_width}}, box);
}

/// Of a piece of no width.
OrientedBox boxOf(const Vector2& from, const Vector2& to) {
  const Vector2 middle = 0.5 * (from + to);
  const Vector2 span = to - from;
  return {{middle.x(), middle.y(), std::atan2(span.y(), span.x())}, {span.norm(), 0.0}};
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
    throw std::invalid_argument("a path needs two distinct places");
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
  const double reach = circumradius(box.size) + half_width;
  for (const Stretch& stretch : stretches_) {
    if (stretch.bounds.squaredExteriorDistance(middle) > reach * reach) continue;
    for (std::size_t i = stretch.first; i < stretch.last; ++i) {
      const Vector2 from = nodes_[i].position();
      const Vector2 to = nodes_[i + 1].position();
      const double share = nearestShare(from, to, middle);
      if ((from + share * (to - from) - middle).squaredNorm() > reach * reach) continue;
      if (distance(boxOf(from, to), box) <= half_width) return true;
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
