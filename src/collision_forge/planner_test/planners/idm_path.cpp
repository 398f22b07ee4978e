#include "collision_forge/planner_test/planners/idm_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace forge {
namespace {

constexpr double kLongestPiece =
    20.0;  // m; nodes of the supported maps are at most half as far apart
constexpr double kCoincidence = 1e-6;  // m, as Polyline
constexpr double kSlack = 1e-6;        // m; slack of distances used for pruning, above rounding

/// Inserts nodes wherever two nodes are more than kLongestPiece apart.
std::vector<Pose2> filled(const std::vector<Pose2>& nodes) {
  std::vector<Pose2> dense;
  for (const Pose2& node : nodes) {
    if (!node.isFinite()) throw std::invalid_argument("a node of the path is not finite");
    if (!dense.empty()) {
      const Pose2 before = dense.back();
      const double distance = (node.position() - before.position()).norm();
      const int pieces = static_cast<int>(std::ceil(distance / kLongestPiece));
      for (int i = 1; i < pieces; ++i) dense.push_back(interpolate(before, node, 1.0 * i / pieces));
    }
    dense.push_back(node);
  }
  return dense;
}

std::vector<Vector2> positionsOf(const std::vector<Pose2>& nodes) {
  std::vector<Vector2> positions;
  for (const Pose2& node : nodes) positions.push_back(node.position());
  return positions;
}

/// Returns the box from `from` to `to`, extended by `before` and `after` metres at its ends.
OrientedBox pieceOf(const Vector2& from, const Vector2& to, double width, double before,
                    double after) {
  const Vector2 along = to - from;
  const double length = along.norm();
  const double yaw = std::atan2(along.y(), along.x());
  const Pose2 start{from.x(), from.y(), yaw};
  const Pose2 middle = compose(start, {0.5 * (length + after - before), 0.0, 0.0});
  return {middle, {length + before + after, width}};
}

}  // namespace

IdmPath::IdmPath(const std::vector<Pose2>& nodes) : line_(positionsOf(nodes)) {
  double arc_length = 0.0;
  const std::vector<Pose2> dense = filled(nodes);
  for (std::size_t i = 0; i + 1 < dense.size(); ++i) {
    const double step = (dense[i + 1].position() - dense[i].position()).norm();
    if (step > kCoincidence) {
      nodes_.push_back(dense[i]);
      arc_lengths_.push_back(arc_length);
    }
    arc_length += step;
  }
}

std::size_t IdmPath::nodeBefore(double arc_length) const {
  const auto after = std::upper_bound(arc_lengths_.begin() + 1, arc_lengths_.end(), arc_length);
  return static_cast<std::size_t>(after - arc_lengths_.begin()) - 1;
}

Pose2 IdmPath::at(double arc_length) const {
  if (arc_length <= 0.0) return nodes_.front();
  const std::size_t i = nodeBefore(arc_length);
  if (i + 1 == nodes_.size()) return nodes_.back();
  const double length = arc_lengths_[i + 1] - arc_lengths_[i];
  return interpolate(nodes_[i], nodes_[i + 1], (arc_length - arc_lengths_[i]) / length);
}

IdmCorridor::IdmCorridor(const IdmPath& path, const std::vector<OrientedBox>& other_boxes,
                         double width)
    : path_(path), width_(width) {
  for (const OrientedBox& box : other_boxes) {
    obstacles_.push_back({box, circumradius(box.size), 0});
    obstacles_.back().touched_before = touchedBefore(obstacles_.back());
  }
}

std::vector<bool> IdmCorridor::touchedFrom(double arc_length) const {
  const std::size_t next = path_.nodeBefore(arc_length) + 1;
  if (next == path_.nodes().size()) return std::vector<bool>(obstacles_.size());
  const OrientedBox first = pieceTo(next, path_.at(arc_length).position(), 0.5 * width_);
  const double radius = circumradius(first.size);
  std::vector<bool> touched;
  for (const Obstacle& obstacle : obstacles_) {
    touched.push_back(
        obstacle.touched_before > next ||
        (isWithin(obstacle, first.center.position(), radius) && overlaps(first, obstacle.box)));
  }
  return touched;
}

bool IdmCorridor::isWithin(const Obstacle& obstacle, const Vector2& point, double distance) {
  const double reach = obstacle.radius + distance + kSlack;
  return (obstacle.box.center.position() - point).squaredNorm() <= reach * reach;
}

OrientedBox IdmCorridor::pieceTo(std::size_t node, const Vector2& from, double before) const {
  const bool is_last = node + 1 == path_.nodes().size();
  return pieceOf(from, path_.nodes()[node].position(), width_, before,
                 is_last ? 0.5 * width_ : 0.0);
}

bool IdmCorridor::touchesAfter(std::size_t node, const Obstacle& obstacle) const {
  const Vector2 from = path_.nodes()[node].position();
  const double length = path_.arcLengths()[node + 1] - path_.arcLengths()[node];
  if (!isWithin(obstacle, from, length + width_)) return false;
  if (overlaps(pieceTo(node + 1, from, 0.0), obstacle.box)) return true;
  const OrientedBox corner{{from.x(), from.y(), 0.0}, {0.0, 0.0}};
  return isWithin(obstacle, from, 0.5 * width_) && distance(corner, obstacle.box) <= 0.5 * width_;
}

std::size_t IdmCorridor::touchedBefore(const Obstacle& obstacle) const {
  std::size_t after = path_.nodes().size() - 1;
  while (after > 0) {
    const std::size_t node = after - 1;
    if (touchesAfter(node, obstacle)) return after;
    // Within `clear` metres before this node the corridor cannot touch the obstacle.
    const Vector2 away = obstacle.box.center.position() - path_.nodes()[node].position();
    const double clear = away.norm() - obstacle.radius - width_;
    after = std::min(node, path_.nodeBefore(path_.arcLengths()[node] - clear) + 1);
  }
  return 0;
}

}  // namespace forge
