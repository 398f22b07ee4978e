#include "parity/pdm_world.h"

#include <set>

namespace forge {

ParityMap::ParityMap(const ParityFixture& maps, const std::string& name)
    : map_(maps.at(name.c_str())) {}

PdmMap ParityMap::pdmMap(const std::string& route) const {
  std::set<std::string> roads;
  for (const auto& road : memberOf(memberOf(map_, "routes"), route.c_str()).GetArray()) {
    roads.insert(road.GetString());
  }
  std::vector<PdmArea> areas;
  for (const auto& lane : memberOf(map_, "lanes").GetObject()) {
    areas.push_back({outlineOf(memberOf(lane.value, "polygon")),
                     roads.count(textOf(lane.value, "roadblock")) > 0});
  }
  for (const auto& park : memberOf(map_, "carparks").GetObject()) {
    areas.push_back({outlineOf(park.value), false});
  }
  std::vector<std::vector<Vector2>> intersections;
  for (const auto& outline : memberOf(map_, "intersections").GetArray()) {
    intersections.push_back(outlineOf(outline));
  }
  return PdmMap(areas, intersections);
}

PdmPath ParityMap::pathAlong(const rapidjson::Value& lanes) const {
  std::vector<Pose2> nodes;
  for (const auto& lane : lanes.GetArray()) {
    const rapidjson::Value& value = memberOf(memberOf(map_, "lanes"), lane.GetString());
    for (const auto& node : memberOf(value, "centerline").GetArray()) nodes.push_back(poseOf(node));
  }
  return PdmPath(nodes);
}

double ParityMap::speedLimit(const std::string& lane, double fallback) const {
  const rapidjson::Value& limit =
      memberOf(memberOf(memberOf(map_, "lanes"), lane.c_str()), "speed_limit");
  return limit.IsNull() ? fallback : numberOf(limit);
}

std::vector<Vector2> outlineOf(const rapidjson::Value& points) {
  std::vector<Vector2> outline;
  for (const auto& point : points.GetArray()) {
    outline.emplace_back(numberOf(point[0]), numberOf(point[1]));
  }
  return outline;
}

}  // namespace forge
