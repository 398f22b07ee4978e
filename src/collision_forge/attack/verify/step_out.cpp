#include "collision_forge/attack/verify/step_out.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kRoadEdge = 3.0;  // m beside the road where people walk without a walkway
constexpr double kRing = 1.0;      // m between the circles that are searched for the road
constexpr int kDirections = 8;     // points per circle
constexpr double kLeastShare = 0.98;

bool isOnCrosswalk(const Vector2& place, const LaneMap& map) {
  return std::any_of(map.features.begin(), map.features.end(), [&](const MapFeature& feature) {
    return feature.kind == FeatureKind::kCrosswalk && contains(Polygon{feature.points, {}}, place);
  });
}

bool isBesideRoad(const Vector2& place, const AreaRaster& drivable) {
  for (double radius = kRing; radius <= kRoadEdge; radius += kRing) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * M_PI * i / kDirections;
      const Vector2 direction(std::cos(angle), std::sin(angle));
      if (drivable.contains(place + radius * direction)) return true;
    }
  }
  return false;
}

}  // namespace

bool isWherePeopleWalk(const Vector2& place, const LaneIndex& lanes) {
  const AreaRaster& drivable = lanes.drivable();
  if (drivable.empty() || lanes.walkways().contains(place)) return true;
  if (drivable.contains(place)) return isOnCrosswalk(place, lanes.map());
  return isBesideRoad(place, drivable);
}

StepOut stepOutOf(const std::vector<TrajectoryPoint>& points, double contact,
                  const LaneIndex& lanes) {
  const auto isInRoad = [&](const TrajectoryPoint& point) {
    const Vector2 place = point.pose.position();
    return lanes.drivable().contains(place) && !lanes.walkways().contains(place);
  };
  const auto end = std::find_if(points.begin(), points.end(),
                                [=](const TrajectoryPoint& point) { return point.time > contact; });
  auto step_out = end;
  while (step_out != points.begin() && isInRoad(*std::prev(step_out))) --step_out;
  StepOut result;
  result.time = step_out == points.end() ? contact : step_out->time;
  const auto before = step_out - points.begin();
  if (before == 0) return result;
  const auto among = std::count_if(points.begin(), step_out, [&](const TrajectoryPoint& point) {
    return isWherePeopleWalk(point.pose.position(), lanes);
  });
  result.among_people = static_cast<double>(among) / static_cast<double>(before);
  return result;
}

std::string implausibleWalk(const StepOut& step_out) {
  if (step_out.among_people >= kLeastShare) return "";
  const auto percent = std::lround(100.0 * (1.0 - step_out.among_people));
  return "walks where people do not walk for " + std::to_string(percent) +
         " % of its motion before it steps out";
}

}  // namespace forge
