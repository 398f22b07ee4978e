#include "collision_forge/io/logs/scenario_net_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/map/lane_links.h"

namespace forge {
namespace {

constexpr double kKilometresAnHour = 3.6;  // km/h in 1 m/s

/// Has every kind; of several names of a kind, the first one is written. Double lines are read as
/// single ones, lines that one side may cross as broken ones.
constexpr std::pair<const char*, FeatureKind> kFeatureKinds[] = {
    {"ROAD_EDGE_BOUNDARY", FeatureKind::kRoadEdge},
    {"ROAD_EDGE_MEDIAN", FeatureKind::kMedian},
    {"CROSSWALK", FeatureKind::kCrosswalk},
    {"DRIVEWAY", FeatureKind::kDriveway},
    {"SPEED_BUMP", FeatureKind::kSpeedBump},
    {"ROAD_LINE_BROKEN_SINGLE_WHITE", FeatureKind::kBrokenWhiteLine},
    {"ROAD_LINE_BROKEN_SINGLE_YELLOW", FeatureKind::kBrokenYellowLine},
    {"ROAD_LINE_BROKEN_DOUBLE_YELLOW", FeatureKind::kBrokenYellowLine},
    {"ROAD_LINE_PASSING_DOUBLE_YELLOW", FeatureKind::kBrokenYellowLine},
    {"ROAD_LINE_SOLID_SINGLE_WHITE", FeatureKind::kSolidWhiteLine},
    {"ROAD_LINE_SOLID_DOUBLE_WHITE", FeatureKind::kSolidWhiteLine},
    {"ROAD_LINE_SOLID_SINGLE_YELLOW", FeatureKind::kSolidYellowLine},
    {"ROAD_LINE_SOLID_DOUBLE_YELLOW", FeatureKind::kSolidYellowLine},
    {"LANE_BIKE_LANE", FeatureKind::kBikeLane}};

/// Returns the outlines in the dict's "interiors".
std::vector<std::vector<Vector2>> holesOf(const PickleField& polygon) {
  std::vector<std::vector<Vector2>> holes;
  const auto interiors = polygon.find("interiors");
  if (!interiors) return holes;
  for (const PickleField& hole : interiors->list()) holes.push_back(hole.points());
  return holes;
}

class MapReader {
 public:
  explicit MapReader(FeatureProblems& problems) : problems_(problems) {}

  LaneMap read(const PickleField& features) {
    for (const auto& [id, feature] : features.entries()) {
      try {
        add(id, feature);
      } catch (const std::runtime_error& error) {
        problems_.left_out.push_back(error.what());
      }
    }
    linkMutually(map_.lanes);
    return std::move(map_);
  }

 private:
  void add(const std::string& id, const PickleField& feature) {
    const std::string type = feature.at("type").text();
    if (type.rfind("LANE_", 0) == 0 && type != "LANE_BIKE_LANE") addLane(id, type, feature);
    if (type == "ROAD_EDGE_SIDEWALK") addWalkway(feature);
    for (const auto& [name, kind] : kFeatureKinds) {
      if (type == name) addFeature(kind, feature);
    }
  }

  void addFeature(FeatureKind kind, const PickleField& feature) {
    const bool is_line = isOpenLine(kind);
    std::vector<Vector2> points = feature.at(is_line ? "polyline" : "polygon").points();
    if (points.size() < (is_line ? 2 : 3)) return;
    map_.features.push_back({kind, std::move(points)});
  }

  void addLane(const std::string& id, const std::string& type, const PickleField& feature) {
    Lane lane;
    lane.id = id;
    lane.is_connector = type == "LANE_SURFACE_UNSTRUCTURE";
    const auto find = [&](const char* key, auto read) {
      return feature.find(key, problems_.unused, read);
    };
    lane.is_intersection = find("is_intersection", std::mem_fn(&PickleField::flag)).value_or(false);
    lane.centerline = centerline(feature.at("polyline").points());
    lane.polygon = find("polygon", std::mem_fn(&PickleField::points)).value_or(lane.polygon);
    if (lane.polygon.size() < 3) lane.polygon = stripAlong(lane.centerline, kLaneWidth);
    const double speed =
        find("speed_limit_kmh", std::mem_fn(&PickleField::rawNumber)).value_or(0.0);
    if (std::isfinite(speed) && speed > 0.0) lane.speed_limit = speed / kKilometresAnHour;
    lane.incoming = find("entry_lanes", std::mem_fn(&PickleField::words)).value_or(lane.incoming);
    lane.outgoing = find("exit_lanes", std::mem_fn(&PickleField::words)).value_or(lane.outgoing);
    map_.lanes.push_back(std::move(lane));
  }

  void addWalkway(const PickleField& feature) {
    const auto outline = feature.find("polygon");
    if (!outline || outline->points().size() < 3) return;
    map_.walkways.push_back({outline->points(), holesOf(feature)});
  }

  /// Returns an empty list for a line of length 0.
  static std::vector<Pose2> centerline(const std::vector<Vector2>& points) {
    constexpr double kCoincidence = 1e-6;  // m, as Polyline
    const auto differs = [&](const Vector2& point) {
      return (point - points.front()).norm() > kCoincidence;
    };
    if (std::none_of(points.begin(), points.end(), differs)) return {};
    const Polyline line(points);
    std::vector<Pose2> poses;
    for (std::size_t i = 0; i < line.points().size(); ++i) {
      const Vector2& point = line.points()[i];
      poses.push_back({point.x(), point.y(), line.poseAt(line.arcLengths()[i]).yaw});
    }
    return poses;
  }

  LaneMap map_;
  FeatureProblems& problems_;
};

}  // namespace

const char* toScenarioNet(FeatureKind kind) {
  return std::find_if(std::begin(kFeatureKinds), std::end(kFeatureKinds),
                      [&](const auto& known) { return known.second == kind; })
      ->first;
}

LaneMap lanesOf(const PickleField& features, FeatureProblems& problems) {
  return MapReader(problems).read(features);
}

std::vector<Polygon> areasOf(const PickleField& areas) {
  std::vector<Polygon> polygons;
  for (const PickleField& area : areas.list()) {
    polygons.push_back({area.at("exterior").points(), holesOf(area)});
  }
  return polygons;
}

}  // namespace forge
