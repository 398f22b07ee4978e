#include "collision_forge/base/map/road_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/map/zero_contour.h"

namespace forge {
namespace {

constexpr double kSpacing = 0.5;       // m between nodes; the cells of AreaRaster
constexpr double kMostNodes = 1.6e7;   // nodes of a grid: 2 km x 2 km at kSpacing, 130 MB
constexpr double kReach = 25.0;        // m; road reaches at most this far from an edge (half the
                                       // width of a large junction)
constexpr double kJoint = 0.5;         // m between open ends that are joined, at most
constexpr double kExtension = 3.0;     // m by which an open end is extended straight
constexpr double kTwoSided = 0.2;      // a side with this share of an edge's votes has road
constexpr double kVoteSpacing = 1.0;   // m between the votes of a centreline
constexpr double kSmallestRing = 0.3;  // m2; smaller areas and islands are noise

/// A straight piece of a road edge.
struct EdgePiece {
  Vector2 begin;
  Vector2 end;
  std::size_t edge = 0;  ///< index of the road edge
  // Mean direction of this piece and its neighbour at either end; empty at an open end.
  std::optional<Vector2> begin_tangent;
  std::optional<Vector2> end_tangent;

  Vector2 direction() const { return (end - begin).normalized(); }
};

/// The point of a piece closest to a point.
struct EdgeFoot {
  Vector2 point;
  double ratio = 0.0;  ///< 0 at the begin to 1 at the end
};

EdgeFoot footOn(const EdgePiece& piece, const Vector2& point) {
  const Vector2 along = piece.end - piece.begin;
  const double ratio = (point - piece.begin).dot(along) / along.squaredNorm();
  const double clamped = std::clamp(ratio, 0.0, 1.0);
  return {piece.begin + clamped * along, clamped};
}

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns the pieces of all edges, in order, with tangents at every joint.
class PieceBuilder {
 public:
  std::vector<EdgePiece> build(const std::vector<MapFeature>& features) {
    for (const MapFeature& feature : features) {
      if (isRoadEdge(feature.kind)) addEdge(feature.points);
    }
    joinEnds();
    return std::move(pieces_);
  }

 private:
  /// An end of an edge: the piece there and which of its ends.
  struct EdgeEnd {
    std::size_t piece;
    bool is_begin;
  };

  void addEdge(const std::vector<Vector2>& line) {
    constexpr double kCoincidence = 1e-6;  // m
    const std::size_t first = pieces_.size();
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vector2& begin = pieces_.size() > first ? pieces_.back().end : line[i - 1];
      if ((line[i] - begin).norm() <= kCoincidence) continue;
      EdgePiece piece{begin, line[i], edges_, {}, {}};
      if (pieces_.size() > first) {
        const Vector2 tangent = pieces_.back().direction() + piece.direction();
        pieces_.back().end_tangent = piece.begin_tangent = tangent;
      }
      pieces_.push_back(piece);
    }
    if (pieces_.size() == first) return;
    ends_.push_back({first, true});
    ends_.push_back({pieces_.size() - 1, false});
    ++edges_;
  }

  Vector2 placeOf(const EdgeEnd& end) const {
    return end.is_begin ? pieces_[end.piece].begin : pieces_[end.piece].end;
  }

  /// Gives an end the tangent of the nearest other end, if that is near.
  void joinEnds() {
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      double least = kJoint;
      const EdgeEnd* nearest = nullptr;
      for (std::size_t j = 0; j < ends_.size(); ++j) {
        const double distance = (placeOf(ends_[j]) - placeOf(ends_[i])).norm();
        if (j == i || distance >= least) continue;
        least = distance;
        nearest = &ends_[j];
      }
      if (nearest) join(ends_[i], *nearest);
    }
  }

  void join(const EdgeEnd& end, const EdgeEnd& other) {
    EdgePiece& piece = pieces_[end.piece];
    const Vector2 onward = pieces_[other.piece].direction();
    const bool runs_on = end.is_begin != other.is_begin;
    const Vector2 tangent = piece.direction() + (runs_on ? onward : Vector2(-onward));
    (end.is_begin ? piece.begin_tangent : piece.end_tangent) = tangent;
  }

  std::vector<EdgePiece> pieces_;
  std::vector<EdgeEnd> ends_;
  std::size_t edges_ = 0;
};

/// Finds the nearest piece of a point, from the nearest pieces of the nodes of a grid.
class NearestPieces {
 public:
  explicit NearestPieces(const std::vector<EdgePiece>& pieces) : pieces_(pieces) {
    Eigen::AlignedBox2d box;
    for (const EdgePiece& piece : pieces) box.extend(piece.begin).extend(piece.end);
    const Vector2 sides = box.sizes() + Vector2::Constant(2.0 * (kReach + kSpacing));
    grid_.spacing = std::max(kSpacing, std::sqrt(sides.prod() / kMostNodes));
    // Aligned to the map frame, so that a map gives the same area wherever its origin is.
    grid_.origin = ((box.min().array() - kReach) / grid_.spacing).floor() * grid_.spacing;
    grid_.columns = static_cast<int>(std::ceil(sides.x() / grid_.spacing)) + 1;
    grid_.rows = static_cast<int>(std::ceil(sides.y() / grid_.spacing)) + 1;
    const std::size_t count =
        static_cast<std::size_t>(grid_.columns) * static_cast<std::size_t>(grid_.rows);
    nearest_.assign(count, kNone);
    squared_.assign(count, static_cast<float>(kReach * kReach));
    for (std::size_t i = 0; i < pieces.size(); ++i) seed(static_cast<std::int32_t>(i));
    sweep();
  }

  /// Returns the grid without values.
  const ValueGrid& grid() const { return grid_; }

  Vector2 nodeAt(int column, int row) const {
    return grid_.origin + grid_.spacing * Vector2(column, row);
  }

  /// Returns the piece near a node, or null if none is within kReach.
  const EdgePiece* atNode(int column, int row) const {
    const std::int32_t found = nearest_[indexOf(column, row)];
    return found == kNone ? nullptr : &pieces_[static_cast<std::size_t>(found)];
  }

  /// As atNode(), for the node nearest to `point`; null outside the grid.
  const EdgePiece* at(const Vector2& point) const {
    const Vector2 place = (point - grid_.origin) / grid_.spacing;
    const int column = static_cast<int>(std::lround(place.x()));
    const int row = static_cast<int>(std::lround(place.y()));
    return isInside(column, row) ? atNode(column, row) : nullptr;
  }

 private:
  static constexpr std::int32_t kNone = -1;

  bool isInside(int column, int row) const {
    return column >= 0 && row >= 0 && column < grid_.columns && row < grid_.rows;
  }

  std::size_t indexOf(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
           static_cast<std::size_t>(column);
  }

  void offer(int column, int row, std::int32_t piece) {
    const Vector2 node = nodeAt(column, row);
    const Vector2 foot = footOn(pieces_[static_cast<std::size_t>(piece)], node).point;
    const std::size_t index = indexOf(column, row);
    const auto squared = static_cast<float>((foot - node).squaredNorm());
    if (squared >= squared_[index]) return;
    squared_[index] = squared;
    nearest_[index] = piece;
  }

  /// Offers a piece to the nodes beside it.
  void seed(std::int32_t index) {
    const EdgePiece& piece = pieces_[static_cast<std::size_t>(index)];
    const Vector2 along = piece.end - piece.begin;
    const int steps = static_cast<int>(std::ceil(along.norm() / grid_.spacing));
    for (int i = 0; i <= steps; ++i) {
      const Vector2 place =
          (piece.begin + along * i / std::max(steps, 1) - grid_.origin) / grid_.spacing;
      const int column = static_cast<int>(place.x());
      const int row = static_cast<int>(place.y());
      for (int y = row - 1; y <= row + 2; ++y) {
        for (int x = column - 1; x <= column + 2; ++x) {
          if (isInside(x, y)) offer(x, y, index);
        }
      }
    }
  }

  void offerFrom(int column, int row, int other_column, int other_row) {
    if (!isInside(other_column, other_row)) return;
    const std::int32_t piece = nearest_[indexOf(other_column, other_row)];
    if (piece != kNone && piece != nearest_[indexOf(column, row)]) offer(column, row, piece);
  }

  /// Hands pieces on between neighbours, up and down the grid and both ways along each row
  /// (sequential Euclidean distance transform, Danielsson 1980): exact near the edges.
  void sweep() {
    for (const int up : {1, -1}) {
      for (int i = 0; i < grid_.rows; ++i) {
        const int row = up > 0 ? i : grid_.rows - 1 - i;
        for (int x = 0; x < grid_.columns; ++x) {
          for (int before = x - 1; before <= x + 1; ++before) offerFrom(x, row, before, row - up);
          offerFrom(x, row, x - 1, row);
        }
        for (int x = grid_.columns - 2; x >= 0; --x) offerFrom(x, row, x + 1, row);
      }
    }
  }

  const std::vector<EdgePiece>& pieces_;
  ValueGrid grid_;
  std::vector<std::int32_t> nearest_;  // piece by node
  std::vector<float> squared_;         // m2, distance to it
};

/// Returns true if `point` is left of the piece's edge at `foot`; nullopt beyond an open end.
std::optional<bool> isLeft(const EdgePiece& piece, const EdgeFoot& foot, const Vector2& point) {
  const Vector2 away = point - foot.point;
  Vector2 tangent = piece.direction();
  if (foot.ratio <= 0.0 || foot.ratio >= 1.0) {
    const bool is_begin = foot.ratio <= 0.0;
    const auto& joint = is_begin ? piece.begin_tangent : piece.end_tangent;
    const double beyond = tangent.dot(away) * (is_begin ? -1.0 : 1.0);
    if (!joint && beyond > kExtension) return std::nullopt;
    tangent = joint.value_or(tangent);
  }
  return cross(tangent, away) > 0.0;
}

/// Calls `visit` with points at most kVoteSpacing apart along a lane's centreline.
template <typename Visit>
void visitAlong(const Lane& lane, const Visit& visit) {
  for (std::size_t i = 0; i < lane.centerline.size(); ++i) {
    const Vector2 from = lane.centerline[i].position();
    visit(from);
    if (i + 1 == lane.centerline.size()) break;
    const Vector2 step = lane.centerline[i + 1].position() - from;
    const int count = static_cast<int>(std::ceil(step.norm() / kVoteSpacing));
    for (int k = 1; k < count; ++k) visit(from + step * k / count);
  }
}

/// The sides of an edge with road.
struct EdgeSides {
  bool left = true;
  bool right = false;
};

class RoadArea {
 public:
  RoadArea(const std::vector<EdgePiece>& pieces, const std::vector<Lane>& lanes)
      : lanes_(lanes), nearest_(pieces), sides_(sidesOf(pieces)) {}

  /// Returns the area inside the edges.
  std::vector<Polygon> inside() const {
    ValueGrid grid = nearest_.grid();
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const double value = valueAt(nearest_.nodeAt(column, row), nearest_.atNode(column, row));
        grid.values.push_back(static_cast<float>(value));
      }
    }
    return positiveArea(grid, kSmallestRing);
  }

  /// Returns strips along the stretches of centrelines that are not inside the edges.
  std::vector<Polygon> strips() const {
    std::vector<Polygon> strips;
    for (const Lane& lane : lanes_) {
      std::vector<Vector2> stretch;  // with the last point inside before it and the first after it
      bool is_outside = false;
      const auto finish = [&] {
        if (is_outside && stretch.size() > 1) strips.push_back(stripOf(stretch));
        stretch.clear();
        is_outside = false;
      };
      visitAlong(lane, [&](const Vector2& point) {
        const bool is_inside = valueAt(point, nearest_.at(point)) > 0.0;
        stretch.push_back(point);
        if (is_inside) finish();
        if (is_inside) stretch.push_back(point);
        is_outside = is_outside || !is_inside;
      });
      finish();
    }
    return strips;
  }

 private:
  /// Returns the distance to the nearest edge, m, positive on its road side; negative if no edge
  /// decides.
  double valueAt(const Vector2& point, const EdgePiece* piece) const {
    if (piece == nullptr) return -kSpacing;
    const EdgeFoot foot = footOn(*piece, point);
    const auto is_left = isLeft(*piece, foot, point);
    if (!is_left) return -kSpacing;
    const EdgeSides& sides = sides_[piece->edge];
    const double distance = std::max((point - foot.point).norm(), 1e-6);
    return (*is_left ? sides.left : sides.right) ? distance : -distance;
  }

  static Polygon stripOf(const std::vector<Vector2>& points) {
    const Polyline line(points);
    std::vector<Pose2> poses;
    for (const double arc_length : line.arcLengths()) poses.push_back(line.poseAt(arc_length));
    return {stripAlong(poses, kLaneWidth), {}};
  }

  std::vector<EdgeSides> sidesOf(const std::vector<EdgePiece>& pieces) const {
    std::vector<std::pair<double, double>> votes(pieces.back().edge + 1);  // left, right
    std::pair<double, double> all(1.0, 0.0);  // without any vote: left, as in Waymo's files
    for (const Lane& lane : lanes_) {
      visitAlong(lane, [&](const Vector2& point) {
        const EdgePiece* piece = nearest_.at(point);
        if (piece == nullptr) return;
        const auto is_left = isLeft(*piece, footOn(*piece, point), point);
        if (!is_left) return;
        for (auto* sum : {&votes[piece->edge], &all}) {
          (*is_left ? sum->first : sum->second) += 1.0;
        }
      });
    }
    std::vector<EdgeSides> sides;
    for (const auto& [left, right] : votes) {
      const double share = left / (left + right);
      if (left + right == 0.0) {
        sides.push_back({all.first >= all.second, all.first < all.second});
      } else {
        sides.push_back({share >= kTwoSided, 1.0 - share >= kTwoSided});
      }
    }
    return sides;
  }

  const std::vector<Lane>& lanes_;
  NearestPieces nearest_;
  std::vector<EdgeSides> sides_;  // by edge
};

}  // namespace

std::vector<Polygon> roadArea(const std::vector<MapFeature>& features,
                              const std::vector<Lane>& lanes) {
  const std::vector<EdgePiece> pieces = PieceBuilder().build(features);
  if (pieces.empty()) return {};
  const RoadArea road(pieces, lanes);
  std::vector<Polygon> area = road.inside();
  for (Polygon& strip : road.strips()) area.push_back(std::move(strip));
  for (const MapFeature& feature : features) {
    const bool is_ring = feature.kind == FeatureKind::kDriveway && feature.points.size() >= 3;
    if (is_ring) area.push_back({feature.points, {}});
  }
  return area;
}

}  // namespace forge
