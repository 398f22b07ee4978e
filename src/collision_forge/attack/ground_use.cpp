#include "collision_forge/attack/ground_use.h"

#include <algorithm>

namespace forge {
namespace {

constexpr int kPlaces = 9;  // in three rows

/// How many of the places are where `is_there` says.
template <typename IsThere>
int placesOf(const Pose2& pose, const BoxSize& size, const IsThere& is_there) {
  const Vector2 ahead = pose.heading();
  const Vector2 along = 0.4 * size.length * ahead;
  const Vector2 across = 0.4 * size.width * Vector2(-ahead.y(), ahead.x());
  int count = 0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      count += is_there(pose.position() + x * along + y * across);
    }
  }
  return count;
}

}  // namespace

double GroundUse::offRoadShare(const std::vector<TrajectoryPoint>& points, double until,
                               const BoxSize& size) const {
  const AreaRaster& drivable = lanes_.drivable();
  if (drivable.empty()) return 0.0;
  const auto on_road = [&](const Vector2& place) { return drivable.contains(place); };
  int on = 0;
  int asked = 0;
  for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(stride_)) {
    on += placesOf(points[i].pose, size, on_road);
    asked += kPlaces;
    if (points[i].time >= until) break;
  }
  return 1.0 - static_cast<double>(on) / asked;
}

bool GroundUse::crossesKerb(const std::vector<TrajectoryPoint>& points, const BoxSize& size) const {
  if (lanes_.walkways().empty()) return false;
  const auto on_walkway = [&](const Vector2& place) {
    return lanes_.walkways().contains(place) && !lanes_.drivable().contains(place);
  };
  const int now = placesOf(points.front().pose, size, on_walkway);
  return std::any_of(points.begin(), points.end(), [&](const TrajectoryPoint& point) {
    return placesOf(point.pose, size, on_walkway) > now;
  });
}

}  // namespace forge
