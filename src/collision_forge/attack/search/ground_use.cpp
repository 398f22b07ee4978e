#include "collision_forge/attack/search/ground_use.h"

#include <algorithm>

namespace forge {
namespace {

/// Returns the number of samplePointsOf() the box for which `is_there` is true.
template <typename IsThere>
int countPlaces(const Pose2& pose, const BoxSize& size, const IsThere& is_there) {
  const auto places = samplePointsOf({pose, size});
  return static_cast<int>(std::count_if(places.begin(), places.end(), is_there));
}

}  // namespace

double GroundUse::offRoadShare(const std::vector<TrajectoryPoint>& points, double until,
                               const BoxSize& size) const {
  const AreaRaster& drivable = lanes_.drivable();
  if (drivable.empty()) return 0.0;
  const auto on_road = [&](const Vector2& place) { return drivable.contains(place); };
  int on = 0;
  std::size_t asked = 0;
  for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(stride_)) {
    on += countPlaces(points[i].pose, size, on_road);
    asked += kBoxSamples;
    if (points[i].time >= until) break;
  }
  return 1.0 - static_cast<double>(on) / static_cast<double>(asked);
}

bool GroundUse::crossesKerb(const std::vector<TrajectoryPoint>& points, const BoxSize& size) const {
  if (lanes_.walkways().empty()) return false;
  const auto on_walkway = [&](const Vector2& place) {
    return lanes_.walkways().contains(place) && !lanes_.drivable().contains(place);
  };
  const int now = countPlaces(points.front().pose, size, on_walkway);
  return std::any_of(points.begin(), points.end(), [&](const TrajectoryPoint& point) {
    return countPlaces(point.pose, size, on_walkway) > now;
  });
}

}  // namespace forge
