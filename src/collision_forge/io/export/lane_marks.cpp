#include "collision_forge/io/export/lane_marks.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

// Own choice.
constexpr double kSpacing = 2.0;   // m between the places at which a line is looked for
constexpr double kReach = 0.5;     // m from the border
constexpr double kParallel = 0.2;  // rad

/// Returns the distance of a segment beside a pose, m; infinite if it is not parallel to the pose
/// or does not lie beside it.
double distanceBeside(const Pose2& place, const Vector2& from, const Vector2& to) {
  const Pose2 first = relativeTo(place, {from.x(), from.y(), 0.0});
  const Pose2 last = relativeTo(place, {to.x(), to.y(), 0.0});
  const double along = last.x - first.x, across = last.y - first.y;
  const bool is_beside = std::min(first.x, last.x) <= 0.0 && std::max(first.x, last.x) >= 0.0;
  if (!is_beside || std::abs(across) > std::tan(kParallel) * std::abs(along)) return INFINITY;
  return std::abs(along == 0.0 ? first.y : first.y - across * first.x / along);
}

}  // namespace

PaintedLines::PaintedLines(const LaneMap& map) {
  for (const MapFeature& feature : map.features) {
    if (!isPaintedLine(feature.kind) || feature.points.empty()) continue;
    Line line{feature.kind, &feature.points, feature.points.front(), feature.points.front()};
    for (const Vector2& point : feature.points) {
      line.low = line.low.cwiseMin(point);
      line.high = line.high.cwiseMax(point);
    }
    lines_.push_back(line);
  }
}

std::optional<FeatureKind> PaintedLines::nearestTo(const Pose2& place) const {
  const Vector2 reach(kReach, kReach), here = place.position();
  std::optional<FeatureKind> nearest;
  double least = kReach;
  for (const Line& line : lines_) {
    if (((line.low - reach).array() > here.array()).any() ||
        ((line.high + reach).array() < here.array()).any()) {
      continue;
    }
    for (std::size_t i = 1; i < line.points->size(); ++i) {
      const double distance = distanceBeside(place, (*line.points)[i - 1], (*line.points)[i]);
      if (distance >= least) continue;
      least = distance;
      nearest = line.kind;
    }
  }
  return nearest;
}

std::vector<LaneMark> PaintedLines::marksAlong(const RoadCourse& course,
                                               const std::function<double(double)>& border,
                                               double begin, double end) const {
  std::vector<LaneMark> marks;
  const int count = lines_.empty() ? 1 : std::max(1, static_cast<int>((end - begin) / kSpacing));
  for (int i = 0; i < count; ++i) {
    const double from = begin + (end - begin) * i / count;
    const double middle = begin + (end - begin) * (i + 0.5) / count;
    const Pose2 place = compose(course.poseAt(middle), {0.0, border(middle), 0.0});
    const std::optional<FeatureKind> line = nearestTo(place);
    if (marks.empty() || marks.back().line != line) marks.push_back({from, line});
  }
  return marks;
}

}  // namespace forge
