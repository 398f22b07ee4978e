#include "map/reference_path.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kSpacing = 1.0;  // metres between places
constexpr int kSmoothing = 2;     // places to either side that a place is the mean of
constexpr int kSmoothingRounds = 2;
constexpr double kJointGap = 0.2;      // metres, closer points of two lanes are one
constexpr std::size_t kMaxDepth = 12;  // lanes one after the other

void smooth(std::vector<Vector2>& points) {
  const std::vector<Vector2> rough = points;
  const int count = static_cast<int>(rough.size());
  for (int i = 1; i + 1 < count; ++i) {
    const int reach = std::min({kSmoothing, i, count - 1 - i});
    Vector2 sum = Vector2::Zero();
    for (int j = i - reach; j <= i + reach; ++j) sum += rough[static_cast<std::size_t>(j)];
    points[static_cast<std::size_t>(i)] = sum / (2.0 * reach + 1.0);
  }
}

/// Depth-first walk over the branches.
class Walk {
 public:
  Walk(const LaneIndex& lanes, double distance, std::size_t max_paths)
      : lanes_(lanes), distance_(distance), max_paths_(max_paths) {}

  void start(std::size_t lane, double arc_length) {
    const Polyline& line = *lanes_.centerline(lane);
    std::vector<Vector2> points = {line.poseAt(arc_length).position()};
    follow(lane, arc_length, 0.0, points, 0);
  }

  std::vector<std::vector<Vector2>> found;

 private:
  void follow(std::size_t lane, double from, double travelled, std::vector<Vector2> points,
              std::size_t depth) {
    if (found.size() >= max_paths_) return;
    const Polyline& line = *lanes_.centerline(lane);
    for (std::size_t i = 0; i < line.points().size(); ++i) {
      if (line.arcLengths()[i] <= from) continue;
      if ((line.points()[i] - points.back()).norm() > kJointGap) points.push_back(line.points()[i]);
    }
    travelled += line.length() - from;
    std::vector<std::size_t> next;
    if (travelled < distance_ && depth < kMaxDepth) {
      for (const std::size_t successor : lanes_.successors(lane)) {
        if (lanes_.centerline(successor)) next.push_back(successor);
      }
      const auto straightest = lanes_.straightestSuccessor(lane);
      std::stable_partition(next.begin(), next.end(),
                            [&](std::size_t i) { return straightest && i == *straightest; });
    }
    if (next.empty()) found.push_back(std::move(points));
    for (const std::size_t successor : next) follow(successor, 0.0, travelled, points, depth + 1);
  }

  const LaneIndex& lanes_;
  double distance_;
  std::size_t max_paths_;
};

}  // namespace

ReferencePath::ReferencePath(const Polyline& line) {
  const int count = std::max(2, static_cast<int>(std::floor(line.length() / kSpacing)) + 1);
  std::vector<Vector2> points;
  for (int i = 0; i < count; ++i) points.push_back(line.poseAt(i * kSpacing).position());
  for (int round = 0; round < kSmoothingRounds; ++round) smooth(points);
  places_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2 step = points[std::min(i + 1, points.size() - 1)] - points[i > 0 ? i - 1 : 0];
    places_[i].pose = {points[i].x(), points[i].y(), std::atan2(step.y(), step.x())};
  }
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    places_[i].curvature =
        angleBetween(places_[i - 1].pose.yaw, places_[i + 1].pose.yaw) / (2.0 * kSpacing);
  }
}

ReferencePath::Place ReferencePath::at(double arc_length) const {
  if (arc_length <= 0.0 || arc_length >= length()) {
    const Place& end = arc_length <= 0.0 ? places_.front() : places_.back();
    const double beyond = arc_length <= 0.0 ? arc_length : arc_length - length();
    return {compose(end.pose, {beyond, 0.0, 0.0}), 0.0};
  }
  const auto i = static_cast<std::size_t>(arc_length / kSpacing);
  const double ratio = arc_length / kSpacing - static_cast<double>(i);
  const Place& a = places_[i];
  const Place& b = places_[i + 1];
  return {interpolate(a.pose, b.pose, ratio), a.curvature + ratio * (b.curvature - a.curvature)};
}

double ReferencePath::project(const Vector2& point) const {
  std::size_t best = 0;
  double best_distance = (places_[0].pose.position() - point).squaredNorm();
  for (std::size_t i = 1; i < places_.size(); ++i) {
    const double distance = (places_[i].pose.position() - point).squaredNorm();
    if (distance < best_distance) {
      best = i;
      best_distance = distance;
    }
  }
  const Pose2& place = places_[best].pose;
  return static_cast<double>(best) * kSpacing + place.heading().dot(point - place.position());
}

std::vector<ReferencePath> pathsAhead(const LaneIndex& lanes, const Pose2& pose, double distance,
                                      double max_lane_distance, double max_lane_heading,
                                      std::size_t max_paths) {
  Walk walk(lanes, distance, max_paths);
  for (const LaneMatch& match : lanes.lanesNear(pose, max_lane_distance, max_lane_heading)) {
    walk.start(match.lane, match.projection.arc_length);
  }
  std::vector<ReferencePath> paths;
  for (const std::vector<Vector2>& points : walk.found) {
    if (points.size() < 2 || (points.back() - points.front()).norm() < kSpacing) continue;
    paths.emplace_back(Polyline(points));
  }
  return paths;
}

}  // namespace forge
