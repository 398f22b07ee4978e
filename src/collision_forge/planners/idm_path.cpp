#include "collision_forge/planners/idm_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace forge {
namespace {

constexpr double kLongestPiece = 20.0;  // m; maps that matter have nodes at most half as far apart
constexpr double kCoincidence = 1e-6;   // m, as Polyline

/// Nodes more than kLongestPiece apart get others in between.
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

/// The ground of a piece from `from` to `to`, each end moved outwards by these lengths.
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

IdmCorridor::IdmCorridor(const IdmPath& path, const std::vector<OrientedBox>& others, double width)
    : path_(path), others_(others), width_(width), touched_before_(others.size(), 0) {
  const std::vector<Pose2>& nodes = path.nodes();
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Vector2 from = nodes[i].position();
    const Vector2 to = nodes[i + 1].position();
    const bool is_last = i + 2 == nodes.size();
    const OrientedBox piece = pieceOf(from, to, width, 0.0, is_last ? 0.5 * width : 0.0);
    const OrientedBox corner{{from.x(), from.y(), 0.0}, {0.0, 0.0}};
    for (std::size_t other = 0; other < others.size(); ++other) {
      const OrientedBox& box = others[other];
      const double reach = circumradius(piece.size) + circumradius(box.size) + width;
      if ((piece.center.position() - box.center.position()).norm() > reach) continue;
      if (overlaps(piece, box) || distance(corner, box) <= 0.5 * width)
        touched_before_[other] = i + 1;
    }
  }
}

bool IdmCorridor::isTouched(std::size_t index, double arc_length) const {
  const std::size_t node = path_.nodeBefore(arc_length);
  if (touched_before_[index] > node + 1) return true;
  const bool is_at_end = node + 1 >= path_.nodes().size();
  if (is_at_end) return false;
  const bool is_last = node + 2 == path_.nodes().size();
  const OrientedBox first =
      pieceOf(path_.at(arc_length).position(), path_.nodes()[node + 1].position(), width_,
              0.5 * width_, is_last ? 0.5 * width_ : 0.0);
  return overlaps(first, others_[index]);
}

}  // namespace forge
