#include "collision_forge/io/maps/common_road_map.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

#include "collision_forge/base/map/lane_links.h"
#include "collision_forge/io/maps/driving_side.h"
#include "collision_forge/io/maps/junctions.h"

namespace forge {
namespace {

using Words = std::set<std::string>;

bool haveCommon(const Words& some, const Words& others) {
  return std::any_of(some.begin(), some.end(),
                     [&](const std::string& word) { return others.count(word) > 0; });
}

const Words kCars = {"vehicle", "car"};
const Words kOffRoad = {"sidewalk", "crosswalk", "busStop"};
/// Types of lanelets on which cars do not drive, if the file does not name the users of the
/// lanelet.
const Words kNotForCars = {"sidewalk", "crosswalk", "busStop",    "busLane",       "bicycleLane",
                           "shoulder", "border",    "restricted", "emergencyLane", "parking"};

bool carriesCars(const CommonRoadLanelet& lanelet) {
  if (lanelet.users_one_way.empty() && lanelet.users_both_ways.empty()) {
    return !haveCommon(lanelet.types, kNotForCars);
  }
  return haveCommon(lanelet.users_one_way, kCars) || haveCommon(lanelet.users_both_ways, kCars);
}

/// Returns the driving side of a benchmark id's country, as "SGP" in "C-SGP_Town-1"; nullopt for no
/// country and for ZAM, CommonRoad's fictitious one.
std::optional<DrivingSide> sideOfCountry(const std::string& benchmark) {
  // Countries with traffic on the left, ISO 3166-1 alpha-3.
  static const Words kLeft = {"AUS", "BGD", "BHS", "BRB", "BRN", "BTN", "BWA", "CYP", "FJI",
                              "GBR", "GUY", "HKG", "IDN", "IND", "IRL", "JAM", "JPN", "KEN",
                              "LKA", "LSO", "MAC", "MDV", "MLT", "MOZ", "MUS", "MWI", "MYS",
                              "NAM", "NPL", "NZL", "PAK", "PNG", "SGP", "SUR", "SWZ", "SYC",
                              "THA", "TTO", "TZA", "UGA", "ZAF", "ZMB", "ZWE"};
  const std::size_t start = benchmark.compare(0, 2, "C-") == 0 ? 2 : 0;
  const std::size_t end = benchmark.find('_', start);
  if (end == std::string::npos || end != start + 3) return std::nullopt;
  const std::string country = benchmark.substr(start, 3);
  if (country == "ZAM") return std::nullopt;
  return kLeft.count(country) > 0 ? DrivingSide::kLeft : DrivingSide::kRight;
}

DrivingSide sideOf(const CommonRoadFile& file, const std::string& location,
                   const DataOptions& options, WarningCounter& warnings) {
  if (const auto side = configuredSide(options, location)) return *side;
  if (file.driving_side) return *file.driving_side;
  if (const auto side = sideOfCountry(file.benchmark)) return *side;
  OppositeNeighbours pairs;
  for (const CommonRoadLanelet& lanelet : file.lanelets) {
    if (!carriesCars(lanelet)) continue;
    if (lanelet.oncoming_left) ++pairs.to_the_left;
    if (lanelet.oncoming_right) ++pairs.to_the_right;
  }
  return drivingSide(options, location, pairs, warnings);
}

/// Returns the means of the points of the bounds, which the format requires in pairs.
std::vector<Vector2> centreOf(const LaneBounds& bounds) {
  if (bounds.left.size() != bounds.right.size()) return middleOf(bounds);
  std::vector<Vector2> centre;
  std::transform(
      bounds.left.begin(), bounds.left.end(), bounds.right.begin(), std::back_inserter(centre),
      [](const Vector2& left, const Vector2& right) { return Vector2(0.5 * (left + right)); });
  return centre;
}

Lane laneOf(const CommonRoadLanelet& lanelet, const LaneBounds& bounds,
            const DataOptions& options) {
  Lane lane;
  lane.id = lanelet.id;
  lane.is_connector = lanelet.is_in_intersection;
  lane.is_intersection = lanelet.is_in_intersection;
  lane.centerline = posesAlong(centreOf(bounds), options.conversion.centerline_resolution,
                               options.input_limits.max_points);
  lane.polygon = outlineOf(bounds);
  lane.speed_limit = lanelet.speed_limit;
  return lane;
}

std::vector<std::string> reversedIds(const std::vector<std::string>& ids) {
  std::vector<std::string> reversed;
  for (const std::string& id : ids) reversed.push_back(id + kReverse);
  return reversed;
}

void addLanes(const CommonRoadLanelet& lanelet, const DataOptions& options, LaneMap& map,
              WarningCounter& warnings) {
  Lane lane = laneOf(lanelet, lanelet.bounds, options);
  if (lane.centerline.empty()) warnings.add("lanelets without a usable centreline", lanelet.id);
  lane.incoming = lanelet.predecessors;
  lane.outgoing = lanelet.successors;
  map.lanes.push_back(std::move(lane));
  if (!haveCommon(lanelet.users_both_ways, kCars)) return;
  Lane back = laneOf(lanelet, reversedBounds(lanelet.bounds), options);
  back.id += kReverse;
  back.incoming = reversedIds(lanelet.successors);
  back.outgoing = reversedIds(lanelet.predecessors);
  map.lanes.push_back(std::move(back));
}

}  // namespace

LaneMap commonRoadLanes(const CommonRoadFile& file, const std::string& location,
                        const DataOptions& options, WarningCounter& warnings) {
  LaneMap map;
  map.location = location;
  map.driving_side = sideOf(file, location, options, warnings);
  for (const CommonRoadLanelet& lanelet : file.lanelets) {
    if (!haveCommon(lanelet.types, kOffRoad)) {
      map.drivable_area.push_back({outlineOf(lanelet.bounds), {}});
    }
    if (lanelet.types.count("sidewalk") > 0) {
      map.walkways.push_back({outlineOf(lanelet.bounds), {}});
    }
    if (carriesCars(lanelet)) addLanes(lanelet, options, map, warnings);
  }
  linkMutually(map.lanes);
  const bool has_intersections =
      std::any_of(file.lanelets.begin(), file.lanelets.end(),
                  [](const CommonRoadLanelet& lanelet) { return lanelet.is_in_intersection; });
  if (!has_intersections) markJunctions(map.lanes);
  return map;
}

LaneMap readCommonRoadMap(const std::string& path, const DataOptions& options,
                          std::vector<std::string>& warnings) {
  WarningCounter counter;
  const CommonRoadFile file = readCommonRoadFile(path, options, counter);
  const std::string location = std::filesystem::path(path).stem().string();
  LaneMap map = commonRoadLanes(file, location, options, counter);
  for (std::string& line : counter.lines(path)) warnings.push_back(std::move(line));
  return map;
}

}  // namespace forge
