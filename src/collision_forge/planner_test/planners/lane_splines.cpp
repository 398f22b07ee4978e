#include "collision_forge/planner_test/planners/lane_splines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collision_forge/planner_test/planners/lane_paths.h"

namespace forge {
namespace {

/// Lengths of a vehicle's candidate paths and the spacing of their samples.
struct Extent {
  double ahead = 0.0;          // m
  double behind = 0.0;         // m
  double ahead_spacing = 0.0;  // m
  int samples_ahead = 0;
  double behind_spacing = 0.0;  // m
  int samples_behind = 0;
};

Extent extentOf(double speed, const RuleBasedOptions& options) {
  const double horizon = options.step * options.steps;
  Extent extent;
  extent.ahead = horizon * options.max_speed + options.length_buffer;
  extent.behind = horizon * std::max(-speed, 0.0) + options.length_buffer;
  extent.samples_ahead = std::max(1, static_cast<int>(extent.ahead / options.sample_spacing));
  extent.ahead_spacing = extent.ahead / extent.samples_ahead;
  // One sample more than ahead: the published grid behind a vehicle omits its last place.
  extent.samples_behind = static_cast<int>(extent.behind / options.sample_spacing) + 1;
  extent.behind_spacing = extent.behind / extent.samples_behind;
  return extent;
}

/// A chain of points with lengths relative to a vehicle beside it; straight beyond both ends.
class MeasuredLine {
 public:
  /// `near` is the first point of the piece where the search for the point nearest to the vehicle
  /// starts; the search continues along the line as long as the distance decreases.
  MeasuredLine(std::vector<Vector2> points, std::size_t near, const Vector2& vehicle)
      : points_(std::move(points)), lengths_(points_.size(), 0.0) {
    for (std::size_t i = 1; i < points_.size(); ++i) {
      lengths_[i] = lengths_[i - 1] + (points_[i] - points_[i - 1]).norm();
    }
    const std::size_t piece = nearestPiece(near, vehicle);
    closest_ = closestBetween(points_[piece], points_[piece + 1], vehicle);
    const double zero = lengths_[piece] + (closest_ - points_[piece]).norm();
    for (double& length : lengths_) length -= zero;
  }

  /// Returns the point nearest to the vehicle, where length is 0.
  const Vector2& closest() const { return closest_; }

  /// `piece`: where the search starts; set to the piece of the result.
  Vector2 at(double length, std::size_t& piece) const {
    while (piece + 2 < points_.size() && lengths_[piece + 1] < length) ++piece;
    while (piece > 0 && lengths_[piece] > length) --piece;
    const double ratio = (length - lengths_[piece]) / (lengths_[piece + 1] - lengths_[piece]);
    return points_[piece] + ratio * (points_[piece + 1] - points_[piece]);
  }

 private:
  double distanceTo(std::size_t piece, const Vector2& vehicle) const {
    return (closestBetween(points_[piece], points_[piece + 1], vehicle) - vehicle).norm();
  }

  std::size_t nearestPiece(std::size_t near, const Vector2& vehicle) const {
    std::size_t nearest = near;
    double least = distanceTo(near, vehicle);
    const auto tryPiece = [&](std::size_t piece) {
      const double distance = distanceTo(piece, vehicle);
      if (distance > least) return false;
      if (distance < least) nearest = piece;
      least = distance;
      return true;
    };
    for (std::size_t i = near + 1; i + 1 < points_.size() && tryPiece(i); ++i) continue;
    for (std::size_t i = near; i > 0 && tryPiece(i - 1); --i) continue;
    return nearest;
  }

  std::vector<Vector2> points_;
  std::vector<double> lengths_;
  Vector2 closest_{0.0, 0.0};
};

/// Joins a path backwards from an edge's start with a path ahead from its end.
std::vector<Vector2> pointsOf(const LaneGraph& graph, const NodePath& behind,
                              const NodePath& ahead) {
  std::vector<Vector2> points;
  for (auto node = behind.rbegin(); node != behind.rend(); ++node) {
    points.push_back(graph.nodes()[*node]);
  }
  for (const std::size_t node : ahead) points.push_back(graph.nodes()[node]);
  return points;
}

/// A line bent to pass through a vehicle: the vehicle's offset from the line decays with the
/// length.
class BentLine {
 public:
  BentLine(const MeasuredLine& line, const Pose2& vehicle, double bend_length)
      : line_(line),
        vehicle_(vehicle),
        offset_(vehicle.position() - line.closest()),
        bend_length_(bend_length) {}

  /// Returns knots outwards from the vehicle, starting with it, every `spacing` metres of line
  /// (negative: backwards), until one is `reach` metres away or there are `samples` knots.
  std::vector<LaneSpline::Knot> knots(double spacing, int samples, double reach) const {
    std::vector<LaneSpline::Knot> knots = {{0.0, {vehicle_.position(), vehicle_.heading()}}};
    std::size_t piece = 0;
    for (int i = 1; i <= samples && std::abs(knots.back().length) < reach; ++i) {
      add(knots, pointAt(spacing * i, piece), spacing < 0.0);
    }
    // The heading at a knot points to the next knot ahead.
    if (spacing > 0.0 && knots.size() > 1 && static_cast<int>(knots.size()) <= samples) {
      const Vector2 next = pointAt(spacing * static_cast<double>(knots.size()), piece);
      knots.back().point.heading = (next - knots.back().point.position).normalized();
    }
    return knots;
  }

 private:
  Vector2 pointAt(double length, std::size_t& piece) const {
    const double faded = length / bend_length_;
    return line_.at(length, piece) + std::exp(-faded * faded) * offset_;
  }

  static void add(std::vector<LaneSpline::Knot>& knots, const Vector2& position, bool is_behind) {
    const LaneSpline::Knot& last = knots.back();
    const Vector2 span = position - last.point.position;
    const double length = span.norm();
    if (!(length > 0.0)) return;
    const Vector2 along = span / length;
    if (is_behind) {
      knots.push_back({last.length - length, {position, -along}});
      return;
    }
    // The vehicle keeps its own heading.
    if (knots.size() > 1) knots.back().point.heading = along;
    knots.push_back({knots.back().length + length, {position, along}});
  }

  const MeasuredLine& line_;
  Pose2 vehicle_;
  Vector2 offset_;
  double bend_length_;
};

LaneSpline bentSpline(const MeasuredLine& line, const Pose2& vehicle, const Extent& extent,
                      const Reach& reach, double bend_length) {
  const BentLine bent(line, vehicle, bend_length);
  std::vector<LaneSpline::Knot> knots =
      bent.knots(-extent.behind_spacing, extent.samples_behind, reach.behind);
  std::reverse(knots.begin(), knots.end());
  knots.pop_back();
  for (const LaneSpline::Knot& knot :
       bent.knots(extent.ahead_spacing, extent.samples_ahead, reach.ahead)) {
    knots.push_back(knot);
  }
  return LaneSpline(std::move(knots));
}

}  // namespace

LaneSpline::LaneSpline(std::vector<Knot> knots) : knots_(std::move(knots)) {
  if (knots_.empty()) throw std::invalid_argument("a path needs at least one knot");
}

LaneSpline::Point LaneSpline::at(double length) const {
  const auto next =
      std::upper_bound(knots_.begin(), knots_.end(), length,
                       [](double wanted, const Knot& knot) { return wanted < knot.length; });
  if (next == knots_.begin() || next == knots_.end()) {
    const Knot& end = next == knots_.begin() ? knots_.front() : knots_.back();
    return {end.point.position + (length - end.length) * end.point.heading, end.point.heading};
  }
  const Knot& before = *(next - 1);
  const double ratio = (length - before.length) / (next->length - before.length);
  return {before.point.position + ratio * (next->point.position - before.point.position),
          before.point.heading + ratio * (next->point.heading - before.point.heading)};
}

std::vector<LaneSpline> laneSplinesOf(const LaneGraph& graph, const std::vector<EdgeMatch>& matches,
                                      const Pose2& vehicle, double speed, const Reach& reach,
                                      const RuleBasedOptions& options) {
  const Extent extent = extentOf(speed, options);
  const std::size_t max_paths = static_cast<std::size_t>(options.max_paths);
  std::vector<LaneSpline> splines;
  for (const EdgeMatch& match : matches) {
    const LaneGraph::Edge& edge = graph.edges()[match.edge];
    const std::vector<NodePath> ahead =
        nodePaths(graph, edge.second, PathDirection::kAhead, extent.ahead, max_paths);
    const std::vector<NodePath> behind =
        nodePaths(graph, edge.first, PathDirection::kBehind, extent.behind,
                  reach.behind > 0.0 ? max_paths : 1);
    for (const NodePath& back : behind) {
      for (const NodePath& forth : ahead) {
        const MeasuredLine line(pointsOf(graph, back, forth), back.size() - 1, vehicle.position());
        splines.push_back(bentSpline(line, vehicle, extent, reach, options.bend_length));
      }
    }
  }
  if (splines.empty()) {
    splines.emplace_back(
        std::vector<LaneSpline::Knot>{{0.0, {vehicle.position(), vehicle.heading()}}});
  }
  return splines;
}

}  // namespace forge
