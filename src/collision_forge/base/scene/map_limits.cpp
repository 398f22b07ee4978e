#include "collision_forge/base/scene/map_limits.h"

#include <algorithm>
#include <cstddef>

#include "collision_forge/base/map/lane_links.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

template <typename Point>
bool isLineWithin(const std::vector<Point>& points, const InputLimits& limits) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Point& point) { return isWithin(point, limits); });
}

bool isWithin(const Lane& lane, const InputLimits& limits) {
  return lane.centerline.size() <= static_cast<std::size_t>(limits.max_points) &&
         isLineWithin(lane.centerline, limits) && isLineWithin(lane.polygon, limits);
}

bool isWithin(const Polygon& area, const InputLimits& limits) {
  return isLineWithin(area.exterior, limits) &&
         std::all_of(area.holes.begin(), area.holes.end(),
                     [&](const auto& hole) { return isLineWithin(hole, limits); });
}

bool isWithin(const MapFeature& feature, const InputLimits& limits) {
  return isLineWithin(feature.points, limits);
}

/// Removes the elements beyond the limits; returns their number.
template <typename Element>
std::size_t removeBeyond(std::vector<Element>& all, const InputLimits& limits) {
  const auto end = std::remove_if(
      all.begin(), all.end(), [&](const Element& element) { return !isWithin(element, limits); });
  const auto count = static_cast<std::size_t>(all.end() - end);
  all.erase(end, all.end());
  return count;
}

/// Returns the number of speed limits removed.
std::size_t removeSpeedsBeyond(std::vector<Lane>& lanes, const InputLimits& limits) {
  std::size_t count = 0;
  for (Lane& lane : lanes) {
    if (!lane.speed_limit) continue;
    if (*lane.speed_limit >= 0.0 && *lane.speed_limit <= limits.max_speed) continue;
    lane.speed_limit.reset();
    ++count;
  }
  return count;
}

}  // namespace

void keepWithin(LaneMap& map, const InputLimits& limits, std::vector<std::string>* warnings) {
  const auto warn = [&](std::size_t count, const char* noun) {
    if (count == 0 || warnings == nullptr) return;
    warnings->push_back(counted(count, noun) + " beyond the limits of input_limits.yaml left out");
  };
  if (std::any_of(map.lanes.begin(), map.lanes.end(),
                  [&](const Lane& lane) { return isWithin(lane, limits); })) {
    const std::size_t removed = removeBeyond(map.lanes, limits);
    if (removed > 0) linkMutually(map.lanes);
    warn(removed, "lane");
  }
  warn(removeBeyond(map.drivable_area, limits), "drivable area");
  warn(removeBeyond(map.walkways, limits), "walkway");
  warn(removeBeyond(map.features, limits), "map feature");
  warn(removeSpeedsBeyond(map.lanes, limits), "speed limit");
}

}  // namespace forge
