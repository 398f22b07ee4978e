#include "collision_forge/io/export/scenario_net_map.h"

#include <map>
#include <string>
#include <unordered_set>

#include "collision_forge/io/logs/scenario_net_lanes.h"

namespace forge {
namespace {

constexpr double kMostApart = 100.0;  // m between the centroids of a lane's centreline and outline
constexpr double kKilometresAnHour = 3.6;  // km/h in 1 m/s
constexpr const char* kTrafficLight = "TRAFFIC_LIGHT";

const char* nameOf(LightColor color) {
  switch (color) {
    case LightColor::kRed:
      return "TRAFFIC_LIGHT_RED";
    case LightColor::kYellow:
      return "TRAFFIC_LIGHT_YELLOW";
    case LightColor::kGreen:
      return "TRAFFIC_LIGHT_GREEN";
    case LightColor::kUnknown:
      break;
  }
  return "TRAFFIC_LIGHT_UNKNOWN";
}

std::vector<double> flat(const std::vector<Vector2>& points) {
  std::vector<double> numbers;
  for (const Vector2& point : points) numbers.insert(numbers.end(), {point.x(), point.y()});
  return numbers;
}

Vector2 middleOf(const std::vector<Vector2>& points) {
  Vector2 sum(0.0, 0.0);
  for (const Vector2& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

void writeInteriors(PickleWriter& writer, const Polygon& polygon) {
  writer.beginArray("interiors");
  for (const std::vector<Vector2>& hole : polygon.holes) writer.array(nullptr, flat(hole), 2);
  writer.endArray();
}

/// Writes the features of one map.
class FeatureWriter {
 public:
  FeatureWriter(PickleWriter& writer, const LaneMap& map) : writer_(writer) {
    for (const Lane& lane : map.lanes) {
      if (lane.centerline.size() > 1) lanes_.insert(lane.id);
    }
  }

  void writeLane(const Lane& lane) {
    if (lanes_.count(lane.id) == 0) return;
    std::vector<Vector2> line;
    for (const Pose2& pose : lane.centerline) line.push_back(pose.position());
    writer_.beginObject(lane.id.c_str());
    writer_.text("type", lane.is_connector ? "LANE_SURFACE_UNSTRUCTURE" : "LANE_SURFACE_STREET");
    writer_.flag("is_intersection", lane.is_intersection);
    writer_.array("polyline", flat(line), 2);
    const bool is_outlined = !lane.polygon.empty();
    if (is_outlined && (middleOf(line) - middleOf(lane.polygon)).norm() < kMostApart) {
      writer_.array("polygon", flat(lane.polygon), 2);
    }
    writer_.texts("entry_lanes", known(lane.incoming));
    writer_.texts("exit_lanes", known(lane.outgoing));
    writer_.texts("left_neighbor", {});  // unknown, as in ScenarioNet's own conversion of nuScenes
    writer_.texts("right_neighbor", {});
    if (lane.speed_limit) {
      writer_.number("speed_limit_kmh", kKilometresAnHour * *lane.speed_limit);
    }
    writer_.endObject();
  }

  void writeWalkway(const Polygon& walkway) {
    beginFeature("walkway_", "ROAD_EDGE_SIDEWALK");
    writer_.array("polygon", flat(walkway.exterior), 2);
    if (!walkway.holes.empty()) writeInteriors(writer_, walkway);
    writer_.endObject();
  }

  void writeFeature(const MapFeature& feature) {
    beginFeature(isRoadEdge(feature.kind) ? "edge_" : "feature_", toScenarioNet(feature.kind));
    writer_.array(isOpenLine(feature.kind) ? "polyline" : "polygon", flat(feature.points), 2);
    writer_.endObject();
  }

  std::size_t count() const { return lanes_.size() + others_; }

 private:
  void beginFeature(const char* kind, const char* type) {
    writer_.beginObject((kind + std::to_string(others_++)).c_str());
    writer_.text("type", type);
  }

  std::vector<std::string> known(const std::vector<std::string>& ids) const {
    std::vector<std::string> found;
    for (const std::string& id : ids) {
      if (lanes_.count(id) != 0) found.push_back(id);
    }
    return found;
  }

  PickleWriter& writer_;
  std::unordered_set<std::string> lanes_;  // ids of the lanes with a centreline
  std::size_t others_ = 0;                 // number of features other than lanes
};

}  // namespace

std::size_t writeMapFeatures(PickleWriter& scenario, const LaneMap& map,
                             const std::vector<std::vector<Vector2>>& road_edges) {
  FeatureWriter features(scenario, map);
  scenario.beginObject("map_features");
  for (const Lane& lane : map.lanes) features.writeLane(lane);
  for (const Polygon& walkway : map.walkways) features.writeWalkway(walkway);
  for (const MapFeature& feature : map.features) features.writeFeature(feature);
  for (const std::vector<Vector2>& line : road_edges) {
    features.writeFeature({FeatureKind::kRoadEdge, line});
  }
  scenario.endObject();
  return features.count();
}

void writeLights(PickleWriter& scenario, const std::vector<TrafficLight>& lights,
                 const std::vector<double>& times) {
  scenario.beginObject("dynamic_map_states");
  for (const TrafficLight& light : lights) {
    std::vector<std::string> states;
    for (const double time : times) states.emplace_back(nameOf(colorAt(light, time)));
    scenario.beginObject(light.lane.c_str());
    scenario.text("type", kTrafficLight);
    scenario.beginObject("state");
    scenario.texts("object_state", states);
    scenario.endObject();
    scenario.text("lane", light.lane);
    scenario.array("stop_point", {light.stop_point.x(), light.stop_point.y(), 0.0});
    scenario.beginObject("metadata");
    scenario.text("type", kTrafficLight);
    scenario.text("object_id", light.lane);
    scenario.count("track_length", times.size());
    scenario.endObject();
    scenario.endObject();
  }
  scenario.endObject();
}

void writeLightNumbers(PickleWriter& metadata, const std::vector<TrafficLight>& lights,
                       const std::vector<double>& times) {
  std::map<std::string, std::size_t> rows;
  for (const TrafficLight& light : lights) {
    for (const double time : times) ++rows[nameOf(colorAt(light, time))];
  }
  std::vector<std::string> types;
  for (const auto& [type, count] : rows) types.push_back(type);
  metadata.count("num_traffic_lights", lights.size());
  metadata.texts("num_traffic_light_types", types);
  metadata.beginObject("num_traffic_light_each_step");
  for (const auto& [type, count] : rows) metadata.count(type.c_str(), count);
  metadata.endObject();
}

void writeGround(PickleWriter& writer, const LaneMap& map) {
  writer.text("driving_side", map.driving_side == DrivingSide::kRight ? "right" : "left");
  writer.beginArray("drivable_area");
  for (const Polygon& polygon : map.drivable_area) {
    writer.beginObject();
    writer.array("exterior", flat(polygon.exterior), 2);
    writeInteriors(writer, polygon);
    writer.endObject();
  }
  writer.endArray();
}

}  // namespace forge
