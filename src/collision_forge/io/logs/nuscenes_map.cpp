#include "collision_forge/io/logs/nuscenes_map.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/logs/nuscenes_map_layers.h"

namespace forge {
namespace {

/// Returns the centroid of the enclosed area.
Vector2 centroid(const std::vector<Vector2>& ring) {
  Vector2 sum = Vector2::Zero();
  double twice_area = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i] - ring[0];
    const Vector2 b = ring[(i + 1) % ring.size()] - ring[0];
    const double cross = a.x() * b.y() - b.x() * a.y();
    sum += cross * (a + b);
    twice_area += cross;
  }
  return ring[0] + sum / (3.0 * twice_area);
}

/// Returns the polygons of a list of tokens, without missing or unusable ones.
std::vector<Polygon> polygonsOf(const NuScenesMapLayers& layers,
                                const std::vector<std::string>& tokens, const std::string& what,
                                WarningCounter& warnings) {
  std::vector<Polygon> polygons;
  for (const std::string& token : tokens) {
    const auto polygon = layers.polygons.find(token);
    if (polygon == layers.polygons.end()) {
      warnings.add(what + " without a usable polygon", token);
    } else {
      polygons.push_back(polygon->second);
    }
  }
  return polygons;
}

/// Returns false if the centreline would have too many poses.
bool isShort(const std::vector<ArcPath>& arcline, const NuScenesMapOptions& options) {
  constexpr double kPosesOfAnArc = 2.5;  // besides one per resolution; see discretize()
  double poses = 0.0;
  for (const ArcPath& arc : arcline) poses += arc.length() / options.resolution + kPosesOfAnArc;
  return poses <= options.limits.max_points;
}

Lane makeLane(const NuScenesMapLayers& layers, const NuScenesMapLayers::Lane& from,
              const NuScenesMapOptions& options, WarningCounter& warnings) {
  const std::string what = from.is_connector ? "lane connectors" : "lanes";
  Lane lane;
  lane.id = from.token;
  lane.is_connector = from.is_connector;
  const auto arcline = layers.arclines.find(from.token);
  if (arcline == layers.arclines.end() || !isShort(arcline->second, options)) {
    warnings.add(what + " without a usable arcline", from.token);
  } else {
    lane.centerline = discretize(arcline->second, options.resolution);
  }
  const auto polygon = layers.polygons.find(from.polygon_token);
  if (polygon == layers.polygons.end()) {
    warnings.add(what + " without a usable polygon", from.token);
  } else {
    lane.polygon = polygon->second.exterior;
  }
  return lane;
}

bool isInAny(const std::vector<Polygon>& areas, const Vector2& point) {
  return std::any_of(areas.begin(), areas.end(),
                     [&](const Polygon& area) { return contains(area, point); });
}

bool isInIntersection(const Lane& lane, const std::vector<Polygon>& intersections) {
  if (!lane.polygon.empty() && isInAny(intersections, centroid(lane.polygon))) return true;
  return !lane.centerline.empty() &&
         isInAny(intersections, lane.centerline[lane.centerline.size() / 2].position());
}

void addOnce(std::vector<std::string>& ids, const std::string& id) {
  if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
}

/// Makes links mutual: a link in either lane's record is added to both.
void linkLanes(std::vector<Lane>& lanes, const NuScenesMapLayers& layers,
               WarningCounter& warnings) {
  std::unordered_map<std::string, Lane*> lane_of_id;
  for (Lane& lane : lanes) lane_of_id[lane.id] = &lane;
  const auto find = [&](const std::string& id) {
    const auto entry = lane_of_id.find(id);
    if (entry == lane_of_id.end()) warnings.add("links to or from lanes that do not exist", id);
    return entry == lane_of_id.end() ? nullptr : entry->second;
  };
  const auto link = [](Lane& before, Lane& after) {
    addOnce(before.outgoing, after.id);
    addOnce(after.incoming, before.id);
  };
  for (const NuScenesMapLayers::Links& links : layers.connectivity) {
    Lane* const lane = find(links.lane);
    if (lane == nullptr) continue;
    for (const std::string& id : links.incoming) {
      if (Lane* const before = find(id)) link(*before, *lane);
    }
    for (const std::string& id : links.outgoing) {
      if (Lane* const after = find(id)) link(*lane, *after);
    }
  }
  for (const Lane& lane : lanes) {
    const bool is_alone = lane.incoming.empty() && lane.outgoing.empty();
    if (is_alone) warnings.add("lanes and connectors without any link", lane.id);
  }
}

}  // namespace

LaneMap readNuScenesMap(const std::string& dataroot, const std::string& location,
                        DrivingSide driving_side, const NuScenesMapOptions& options,
                        std::vector<std::string>* warnings) {
  const std::string folder = dataroot + "/maps/expansion";
  const std::string path = pathIn(folder, location + ".json");
  if (!std::filesystem::exists(path)) {
    const std::string misplaced = pathIn(dataroot + "/maps", location + ".json");
    throw NuScenesError(path + ": does not exist; the folder " + folder +
                        " must contain the map expansion, version 1.3 or later" +
                        (std::filesystem::exists(misplaced)
                             ? "; " + misplaced + " is in the folder of version 1.2 and before"
                             : ""));
  }
  return readNuScenesMapFile(path, driving_side, options, warnings);
}

LaneMap readNuScenesMapFile(const std::string& path, DrivingSide driving_side,
                            const NuScenesMapOptions& options, std::vector<std::string>* warnings) {
  if (!(options.resolution > 0.0)) {
    throw std::invalid_argument("readNuScenesMap: resolution must be positive, is " +
                                numberText(options.resolution));
  }
  WarningCounter counter;
  const NuScenesMapLayers layers = readNuScenesMapLayers(path, options.limits, counter);

  LaneMap map;
  map.location = std::filesystem::path(path).stem().string();
  map.driving_side = driving_side;
  map.drivable_area = polygonsOf(layers, layers.drivable_area, "drivable areas", counter);
  map.walkways = polygonsOf(layers, layers.walkways, "walkways", counter);
  const std::vector<Polygon> intersections =
      polygonsOf(layers, layers.intersections, "intersections", counter);
  std::size_t points = 0;
  for (const NuScenesMapLayers::Lane& from : layers.lanes) {
    map.lanes.push_back(makeLane(layers, from, options, counter));
    points += map.lanes.back().centerline.size();
    if (points > static_cast<std::size_t>(options.limits.max_map_points)) break;  // see checkMap()
    map.lanes.back().is_intersection = isInIntersection(map.lanes.back(), intersections);
  }
  checkMap(map, options.limits, path);
  linkLanes(map.lanes, layers, counter);
  if (warnings != nullptr) {
    for (std::string& line : counter.lines(path)) warnings->push_back(std::move(line));
  }
  return map;
}

}  // namespace forge
