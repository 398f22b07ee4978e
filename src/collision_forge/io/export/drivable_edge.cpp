#include "collision_forge/io/export/drivable_edge.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace forge {
namespace {

using Box = Eigen::AlignedBox2d;
using Line = std::vector<Vector2>;

constexpr double kBeside = 0.05;  // m from an edge to the points that test its sides
constexpr double kSame = 0.01;    // m; pieces whose middles are closer count as the same

Box boxAround(const Line& points) {
  Box box;
  for (const Vector2& point : points) box.extend(point);
  return box;
}

/// Finds the boundary lines of one area.
class EdgeFinder {
 public:
  EdgeFinder(const std::vector<Polygon>& area, const Line& points, double radius)
      : area_(area), points_(points), radius_(radius), reach_(boxAround(points)) {
    for (const Polygon& polygon : area) boxes_.push_back(boxAround(polygon.exterior));
  }

  std::vector<Line> find() {
    for (const Polygon& polygon : area_) {
      followRing(polygon.exterior);
      for (const Line& hole : polygon.holes) followRing(hole);
    }
    return std::move(lines_);
  }

 private:
  void followRing(const Line& ring) {
    is_open_ = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      followSide(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
    }
  }

  /// Continues or starts a line, piece by piece along a side of a ring.
  void followSide(const Vector2& from, const Vector2& to) {
    const double length = (to - from).norm();
    if (length == 0.0) return;
    const Vector2 left = Vector2(from.y() - to.y(), to.x() - from.x()) / length;
    const auto count = static_cast<std::size_t>(std::ceil(length / kEdgePiece));
    const Vector2 step = (to - from) / static_cast<double>(count);
    bool was_edge = false;
    for (std::size_t piece = 0; piece < count; ++piece) {
      const Vector2 begin = from + static_cast<double>(piece) * step;
      const Vector2 middle = begin + step / 2.0;
      const bool is_edge = isEdge(middle, left) && isNew(middle);
      const Vector2 end = piece + 1 == count ? to : Vector2(begin + step);
      if (is_edge) extend(begin, end, was_edge);
      is_open_ = was_edge = is_edge;
    }
  }

  /// `is_straight`: the previous piece is of the same side.
  void extend(const Vector2& begin, const Vector2& end, bool is_straight) {
    if (!is_open_) lines_.push_back({begin});
    if (is_straight) lines_.back().pop_back();
    lines_.back().push_back(end);
  }

  bool isEdge(const Vector2& middle, const Vector2& left) const {
    return isNear(middle) &&
           isDrivable(middle + kBeside * left) != isDrivable(middle - kBeside * left);
  }

  /// Returns true if no other polygon contributed this piece of edge before.
  bool isNew(const Vector2& middle) {
    return found_.emplace(std::lround(middle.x() / kSame), std::lround(middle.y() / kSame)).second;
  }

  bool isNear(const Vector2& place) const {
    if (reach_.exteriorDistance(place) > radius_) return false;
    return std::any_of(points_.begin(), points_.end(), [&](const Vector2& point) {
      return (point - place).squaredNorm() <= radius_ * radius_;
    });
  }

  bool isDrivable(const Vector2& place) const {
    for (std::size_t i = 0; i < area_.size(); ++i) {
      if (boxes_[i].contains(place) && contains(area_[i], place)) return true;
    }
    return false;
  }

  const std::vector<Polygon>& area_;
  const Line& points_;
  double radius_;
  Box reach_;
  std::vector<Box> boxes_;  // one per polygon
  std::vector<Line> lines_;
  std::set<std::pair<long, long>> found_;  // middles of the pieces found
  bool is_open_ = false;                   // the last line continues
};

}  // namespace

std::vector<std::vector<Vector2>> drivableEdges(const std::vector<Polygon>& area,
                                                const std::vector<Vector2>& points, double radius) {
  return EdgeFinder(area, points, radius).find();
}

}  // namespace forge
