#include "parity/pdm_world.h"

#include <cmath>

namespace forge {

ParityMap::ParityMap(const ParityFixture& maps, const std::string& name)
    : map_(maps.at(name.c_str())) {}

PdmMap ParityMap::pdmMap(const std::string& route) const {
  std::vector<PdmArea> areas;
  for (const auto& entry : memberOf(map_, "lanes").GetObject()) {
    areas.push_back({outlineOf(memberOf(entry.value, "polygon")),
                     isOnRoute(entry.name.GetString(), route),
                     {}});
  }
  for (const auto& park : memberOf(map_, "carparks").GetObject()) {
    areas.push_back({outlineOf(park.value), false, {}});
  }
  std::vector<std::vector<Vector2>> intersections;
  for (const auto& outline : memberOf(map_, "intersections").GetArray()) {
    intersections.push_back(outlineOf(outline));
  }
  return PdmMap(areas, intersections);
}

PdmPath ParityMap::pathAlong(const rapidjson::Value& lanes) const {
  std::vector<std::string> names;
  for (const auto& name : lanes.GetArray()) names.push_back(name.GetString());
  return pathAlong(names);
}

PdmPath ParityMap::pathAlong(const std::vector<std::string>& lanes) const {
  std::vector<Pose2> nodes;
  for (const std::string& name : lanes) {
    for (const auto& node : memberOf(lane(name), "centerline").GetArray()) {
      nodes.push_back(poseOf(node));
    }
  }
  return PdmPath(nodes);
}

std::vector<std::string> ParityMap::lanesFrom(const Pose2& pose, const std::string& route) const {
  std::string nearest;
  double least = HUGE_VAL;
  for (const auto& entry : memberOf(map_, "lanes").GetObject()) {
    const std::string name = entry.name.GetString();
    if (!isOnRoute(name, route)) continue;
    const PdmPath path = pathAlong(std::vector<std::string>{name});
    const Pose2 place = path.at(path.project(pose.position()));
    const double away = (place.position() - pose.position()).norm();
    if (away >= least) continue;
    least = away;
    nearest = name;
  }
  std::vector<std::string> lanes = {nearest};
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const auto& next : memberOf(lane(lanes.back()), "next").GetArray()) {
      if (goes_on || !isOnRoute(next.GetString(), route)) continue;
      lanes.push_back(next.GetString());
      goes_on = true;
    }
  }
  return lanes;
}

std::shared_ptr<const LaneIndex> ParityMap::laneIndex() const {
  auto map = std::make_shared<LaneMap>();
  for (const auto& entry : memberOf(map_, "lanes").GetObject()) {
    Lane lane;
    lane.id = entry.name.GetString();
    for (const auto& node : memberOf(entry.value, "centerline").GetArray()) {
      lane.centerline.push_back(poseOf(node));
    }
    lane.polygon = outlineOf(memberOf(entry.value, "polygon"));
    for (const auto& next : memberOf(entry.value, "next").GetArray()) {
      lane.outgoing.push_back(next.GetString());
    }
    const rapidjson::Value& limit = memberOf(entry.value, "speed_limit");
    if (!limit.IsNull()) lane.speed_limit = numberOf(limit);
    const rapidjson::Value& road =
        memberOf(memberOf(map_, "roadblocks"), textOf(entry.value, "roadblock").c_str());
    lane.is_connector = memberOf(road, "connector").GetBool();
    map->drivable_area.push_back({lane.polygon, {}});
    map->lanes.push_back(std::move(lane));
  }
  for (const auto& park : memberOf(map_, "carparks").GetObject()) {
    map->drivable_area.push_back({outlineOf(park.value), {}});
  }
  return std::make_shared<const LaneIndex>(map);
}

const rapidjson::Value& ParityMap::lane(const std::string& name) const {
  return memberOf(memberOf(map_, "lanes"), name.c_str());
}

bool ParityMap::isOnRoute(const std::string& lane_name, const std::string& route) const {
  const std::string road = textOf(lane(lane_name), "roadblock");
  for (const auto& taken : memberOf(memberOf(map_, "routes"), route.c_str()).GetArray()) {
    if (road == taken.GetString()) return true;
  }
  return false;
}

double ParityMap::speedLimit(const std::string& lane, double fallback) const {
  const rapidjson::Value& limit = memberOf(this->lane(lane), "speed_limit");
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
