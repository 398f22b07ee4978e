#include "collision_forge/io/export/linked_lanes.h"

#include <cmath>
#include <set>
#include <string>
#include <unordered_map>

namespace forge {
namespace {

bool meets(const RoadCourse& from, const RoadCourse& to) {
  const Vector2 end = from.poseAt(from.length()).position();
  return (end - to.poseAt(0.0).position()).norm() <= kMaxJointGap;
}

Lane bikeLane(const std::vector<Vector2>& points, std::size_t number) {
  Lane lane;
  lane.id = "bike_" + std::to_string(number);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t from = i + 1 < points.size() ? i : i - 1;
    const Vector2 along = points[from + 1] - points[from];
    lane.centerline.push_back({points[i].x(), points[i].y(), std::atan2(along.y(), along.x())});
  }
  return lane;
}

void addBikeLanes(const LaneMap& map, LinkedLanes& linked) {
  for (Lane& lane : bikeLanesOf(map)) {
    RoadCourse course = courseOf(lane, {});
    if (course.empty()) continue;
    linked.bike_lanes.push_back(std::move(lane));
    linked.lanes.push_back({std::move(course), kBikeLaneWidth});
  }
  for (const Lane& lane : linked.bike_lanes) linked.sources.push_back(&lane);
}

}  // namespace

std::vector<Lane> bikeLanesOf(const LaneMap& map) {
  std::vector<Lane> lanes;
  for (const MapFeature& feature : map.features) {
    if (feature.kind != FeatureKind::kBikeLane || feature.points.size() < 2) continue;
    lanes.push_back(bikeLane(feature.points, lanes.size() + 1));
  }
  return lanes;
}

LinkedLanes linkedLanes(const LaneMap& map, const LaneArcs& arcs, double lane_width) {
  LinkedLanes linked;
  std::unordered_map<std::string, std::size_t> places;
  for (const Lane& lane : map.lanes) {
    RoadCourse course = courseOf(lane, arcs);
    if (course.empty()) continue;
    places[lane.id] = linked.lanes.size();
    linked.sources.push_back(&lane);
    const double width = widthOf(lane, course.length(), lane_width);
    linked.lanes.push_back({std::move(course), width, !lane.is_connector});
  }
  addBikeLanes(map, linked);
  linked.next.resize(linked.lanes.size());
  linked.previous.resize(linked.lanes.size());
  for (const Lane& lane : map.lanes) {
    const auto from = places.find(lane.id);
    if (from == places.end()) continue;
    BundleLane& before = linked.lanes[from->second];
    for (const std::string& id :
         std::set<std::string>(lane.outgoing.begin(), lane.outgoing.end())) {
      const auto to = places.find(id);
      if (to == places.end() || to == from) continue;
      BundleLane& after = linked.lanes[to->second];
      if (!meets(before.course, after.course)) continue;
      linked.next[from->second].push_back(to->second);
      linked.previous[to->second].push_back(from->second);
      before.is_left = after.is_entered = true;
    }
  }
  return linked;
}

}  // namespace forge
