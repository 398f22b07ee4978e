#include "collision_forge/planner_test/report/scene_record.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "collision_forge/base/geometry/simplified_line.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/logs/nuscenes_map.h"
#include "collision_forge/planner_test/report/compact_motion.h"
#include "collision_forge/planner_test/report/map_lines.h"

namespace forge {
namespace {

constexpr double kPlaceSpacing = 5.0;  // m between the places around which the map is kept

/// The part of the scene that is kept.
struct Crop {
  const SceneExtent& extent;
  const ReportOptions& options;
  std::vector<Vector2> places;  ///< the map is kept within the margin of these
  Eigen::AlignedBox2d box;
  double origin = 0.0;  ///< s, scene clock; times are relative to it
};

void addPlace(std::vector<Vector2>& places, const Vector2& place) {
  if (places.empty() || (places.back() - place).norm() >= kPlaceSpacing) places.push_back(place);
}

std::vector<AgentState> statesWithin(const Track& track, const SceneExtent& extent) {
  std::vector<AgentState> states;
  for (const AgentState& state : track.states) {
    if (state.time >= extent.begin && state.time <= extent.end) states.push_back(state);
  }
  return states;
}

Crop cropOf(const Scene& scene, const SceneExtent& extent, const ReportOptions& options) {
  Crop crop{extent, options, {}, {}, scene.frame_times.empty() ? 0.0 : scene.frame_times.front()};
  for (const AgentState& state : statesWithin(scene.ego, extent)) {
    addPlace(crop.places, state.pose.position());
  }
  for (const Vector2& place : extent.places) addPlace(crop.places, place);
  for (const Vector2& place : crop.places) crop.box.extend(place);
  const Vector2 margin = Vector2::Constant(options.map_margin);
  if (!crop.places.empty()) crop.box = {crop.box.min() - margin, crop.box.max() + margin};
  return crop;
}

void writeAgents(JsonLineWriter& writer, const Scene& scene, const Crop& crop) {
  const auto isNear = [&](const AgentState& state) {
    return crop.box.contains(state.pose.position());
  };
  writer.beginArray("agents");
  for (const Track& track : scene.agents) {
    const std::vector<AgentState> states = statesWithin(track, crop.extent);
    if (std::none_of(states.begin(), states.end(), isNear)) continue;
    writer.beginObject();
    writer.text("id", track.id);
    writer.text("class", toString(track.agent_class));
    writer.number("length", track.size.length);
    writer.number("width", track.size.width);
    writeStates(writer, "motion", states, crop.origin);
    writer.endObject();
  }
  writer.endArray();
}

void writeRing(JsonLineWriter& writer, const std::vector<Vector2>& ring, const Crop& crop) {
  const std::vector<Vector2> clipped = clippedRing(ring, crop.box);
  if (clipped.size() < 3) return;
  writer.beginObject();
  writePlaces(writer, simplified(clipped, crop.options.map_tolerance));
  writer.endObject();
}

void writeAreas(JsonLineWriter& writer, const char* key, const std::vector<Polygon>& areas,
                const Crop& crop) {
  writer.beginArray(key);
  for (const Polygon& polygon : areas) {
    writer.beginObject();
    writer.beginArray("rings");
    writeRing(writer, polygon.exterior, crop);
    for (const std::vector<Vector2>& hole : polygon.holes) writeRing(writer, hole, crop);
    writer.endArray();
    writer.endObject();
  }
  writer.endArray();
}

void writeLanes(JsonLineWriter& writer, const std::vector<Lane>& lanes, const Crop& crop) {
  writer.beginArray("lanes");
  for (const Lane& lane : lanes) {
    std::vector<Vector2> line;
    for (const Pose2& pose : lane.centerline) {
      if (crop.box.contains(pose.position())) line.push_back(pose.position());
    }
    if (line.size() < 2) continue;
    writer.beginObject();
    writer.flag("connector", lane.is_connector);
    writePlaces(writer, simplified(line, crop.options.map_tolerance));
    writer.endObject();
  }
  writer.endArray();
  writer.beginArray("outlines");
  for (const Lane& lane : lanes) {
    if (!lane.is_connector) writeRing(writer, lane.polygon, crop);
  }
  writer.endArray();
}

void writeMap(JsonLineWriter& writer, const LaneMap& whole, const Crop& crop) {
  const LaneMap map = cropped(whole, crop.places, crop.options.map_margin);
  writer.beginObject("map");
  writer.text("location", map.location);
  writeAreas(writer, "drivable", map.drivable_area, crop);
  writeAreas(writer, "walkways", map.walkways, crop);
  writeLanes(writer, map.lanes, crop);
  writer.endObject();
}

}  // namespace

void SceneExtent::include(double from, double to, const std::vector<TrajectoryPoint>& points) {
  const bool is_first = begin == end;
  begin = is_first ? from : std::min(begin, from);
  end = is_first ? to : std::max(end, to);
  for (const TrajectoryPoint& point : points) addPlace(places, point.pose.position());
}

std::string sceneRecord(const Scene& scene, const SceneExtent& extent,
                        const ReportOptions& options) {
  const Crop crop = cropOf(scene, extent, options);
  JsonLineWriter writer;
  writer.beginObject();
  writer.text("name", scene.name);
  writer.number("origin", crop.origin);
  writer.number("length", scene.ego.size.length);
  writer.number("width", scene.ego.size.width);
  writeStates(writer, "ego", statesWithin(scene.ego, extent), crop.origin);
  writeAgents(writer, scene, crop);
  if (scene.map) writeMap(writer, *scene.map, crop);
  writer.endObject();
  return writer.line();
}

}  // namespace forge
