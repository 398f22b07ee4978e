#include "collision_forge/io/maps/lanelet2_map.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "collision_forge/base/map/lane_links.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/io/maps/driving_side.h"
#include "collision_forge/io/maps/junctions.h"
#include "collision_forge/io/maps/lane_shapes.h"
#include "collision_forge/io/maps/osm_file.h"
#include "collision_forge/io/maps/xml_input.h"

namespace forge {
namespace {

template <std::size_t N>
bool isOneOf(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Subtypes of lanelets and areas. Lanelet2, documentation "Lanelet and Area Tagging" and
// GenericTrafficRules.cpp; Autoware, "Modifying Lanelet2 format for Autoware" (road_shoulder,
// pedestrian_lane, intersection_area, hatched_road_markings, parking_lot).
constexpr std::array<std::string_view, 5> kForCars = {"", "road", "highway", "play_street", "exit"};
constexpr std::array<std::string_view, 5> kBesideCars = {
    "bus_lane", "bicycle_lane", "emergency_lane", "road_shoulder", "pedestrian_lane"};
constexpr std::array<std::string_view, 4> kWalkways = {"walkway", "shared_walkway", "stairs",
                                                       "traffic_island"};
constexpr std::array<std::string_view, 2> kRoadAreas = {"parking", "exit"};
constexpr std::array<std::string_view, 3> kRoadPolygons = {"intersection_area",
                                                           "hatched_road_markings", "parking_lot"};

/// Returns true if cars may drive on a lanelet: by its participants, else by its subtype.
bool carriesCars(const OsmTags& tags) {
  constexpr std::string_view kParticipant = "participant:";
  const auto first = tags.lower_bound(std::string(kParticipant));
  if (first == tags.end() || first->first.compare(0, kParticipant.size(), kParticipant) != 0) {
    return isOneOf(tagOf(tags, "subtype"), kForCars);
  }
  const std::string& cars = tagOf(tags, "participant:vehicle:car");
  return (cars.empty() ? tagOf(tags, "participant:vehicle") : cars) == "yes";
}

/// Returns a speed in m/s; the unit in the tag is km/h by default. nullopt for another text.
std::optional<double> speedIn(const std::string& text) {
  static const std::map<std::string, double> kUnits = {
      {"", 1.0 / 3.6},    {"km/h", 1.0 / 3.6},        {"kmh", 1.0 / 3.6},
      {"kph", 1.0 / 3.6}, {"mph", 1609.344 / 3600.0}, {"m/s", 1.0}};
  const std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
  const auto number = finiteNumber(text.substr(0, end));
  const std::size_t unit = text.find_first_not_of(' ', end);
  const auto found = kUnits.find(unit == std::string::npos ? "" : text.substr(unit));
  if (!number || *number <= 0.0 || found == kUnits.end()) return std::nullopt;
  return *number * found->second;
}

double signedArea(const std::vector<Vector2>& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i] - ring[0];
    const Vector2 b = ring[(i + 1) % ring.size()] - ring[0];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * twice;
}

/// A way in a direction, without its nodes that have no position.
struct Bound {
  std::string way;
  bool is_reversed = false;
  std::vector<std::string> nodes;
  std::vector<Vector2> points;

  void reverse() {
    is_reversed = !is_reversed;
    std::reverse(nodes.begin(), nodes.end());
    std::reverse(points.begin(), points.end());
  }
};

/// Turns the bounds of a lanelet into its driving direction. Ways are written in any direction.
void orient(Bound& left, Bound& right) {
  const auto gap = [](const Vector2& a, const Vector2& b) { return (a - b).norm(); };
  const double parallel =
      gap(left.points.front(), right.points.front()) + gap(left.points.back(), right.points.back());
  const double crossed =
      gap(left.points.front(), right.points.back()) + gap(left.points.back(), right.points.front());
  if (crossed < parallel) right.reverse();
  if (signedArea(outlineOf({left.points, right.points})) <= 0.0) return;
  left.reverse();
  right.reverse();
}

class MapBuilder {
 public:
  MapBuilder(const OsmFile& file, std::string location, const DataOptions& options,
             WarningCounter& warnings)
      : file_(file), location_(std::move(location)), options_(options), warnings_(warnings) {}

  LaneMap build() {
    for (const OsmRelation& relation : file_.relations) {
      const std::string& type = tagOf(relation.tags, "type");
      if (type == "lanelet") addLanelet(relation);
      if (type == "multipolygon") addArea(relation);
    }
    for (const auto& [id, way] : file_.ways) {
      if (isOneOf(tagOf(way.tags, "type"), kRoadPolygons)) addRing(id, map_.drivable_area);
    }
    link();
    if (!has_turns_) markJunctions(map_.lanes);
    map_.driving_side = drivingSide(options_, location_, oppositeNeighbours(), warnings_);
    return std::move(map_);
  }

 private:
  using Ends = std::pair<std::string, std::string>;  // ids of a left and a right node

  void addLanelet(const OsmRelation& relation) {
    const std::string& subtype = tagOf(relation.tags, "subtype");
    const bool is_for_cars = carriesCars(relation.tags);
    const bool is_walkway = isOneOf(subtype, kWalkways);
    if (!is_for_cars && !is_walkway && !isOneOf(subtype, kBesideCars)) return;
    auto left = boundOf(relation, "left");
    auto right = boundOf(relation, "right");
    if (!left || !right) {
      warnings_.add("lanelets without a usable left or right bound", relation.id);
      return;
    }
    orient(*left, *right);
    const std::vector<Vector2> outline = outlineOf({left->points, right->points});
    (is_walkway && !is_for_cars ? map_.walkways : map_.drivable_area).push_back({outline, {}});
    if (!is_for_cars) return;
    addLane(relation, relation.id, *left, *right);
    if (tagOf(relation.tags, "one_way") != "no") return;
    left->reverse();
    right->reverse();
    addLane(relation, relation.id + kReverse, *right, *left);
  }

  void addLane(const OsmRelation& relation, const std::string& id, const Bound& left,
               const Bound& right) {
    const LaneBounds bounds{left.points, right.points};
    Lane lane;
    lane.id = id;
    lane.is_connector = !tagOf(relation.tags, "turn_direction").empty();
    lane.is_intersection = lane.is_connector;
    has_turns_ = has_turns_ || lane.is_connector;
    lane.polygon = outlineOf(bounds);
    lane.centerline =
        posesAlong(centreOf(relation, bounds), options_.conversion.centerline_resolution,
                   options_.input_limits.max_points);
    if (lane.centerline.empty()) warnings_.add("lanelets without a usable centreline", relation.id);
    lane.speed_limit = speedLimitOf(relation);
    starts_[{left.nodes.front(), right.nodes.front()}].push_back(id);
    ends_.emplace_back(left.nodes.back(), right.nodes.back());
    lefts_[left.way].insert(left.is_reversed);
    rights_[right.way].insert(right.is_reversed);
    map_.lanes.push_back(std::move(lane));
  }

  /// Returns the centreline that the relation names, in the direction of the bounds, else the line
  /// midway between the bounds.
  std::vector<Vector2> centreOf(const OsmRelation& relation, const LaneBounds& bounds) const {
    const std::vector<Vector2> middle = middleOf(bounds);
    auto drawn = boundOf(relation, "centerline");
    if (!drawn) return middle;
    const std::vector<Vector2>& points = drawn->points;
    const Vector2& start = middle.front();
    if ((points.back() - start).norm() < (points.front() - start).norm()) drawn->reverse();
    return points;
  }

  std::optional<double> speedLimitOf(const OsmRelation& relation) {
    const std::string& text = tagOf(relation.tags, "speed_limit");
    const auto speed = speedIn(text);
    if (speed && *speed <= options_.input_limits.max_speed) return speed;
    if (!text.empty()) warnings_.add("lanelets without a usable speed_limit", relation.id);
    return std::nullopt;
  }

  /// Returns the relation's way with a role: nullopt if there is not exactly one with two or more
  /// distinct points.
  std::optional<Bound> boundOf(const OsmRelation& relation, const char* role) const {
    if (relation.ways.count(role) != 1) return std::nullopt;
    const std::string& id = relation.ways.find(role)->second;
    const auto way = file_.ways.find(id);
    if (way == file_.ways.end()) return std::nullopt;
    Bound bound{id, false, {}, {}};
    for (const std::string& node : way->second.nodes) {
      const auto place = file_.nodes.find(node);
      if (place == file_.nodes.end()) continue;
      bound.nodes.push_back(node);
      bound.points.push_back(place->second);
    }
    if (bound.points.size() < 2 || bound.points.front() == bound.points.back()) return std::nullopt;
    return bound;
  }

  void addArea(const OsmRelation& relation) {
    const std::string& subtype = tagOf(relation.tags, "subtype");
    const bool is_walkway = isOneOf(subtype, kWalkways);
    if (!is_walkway && !isOneOf(subtype, kRoadAreas)) return;
    std::vector<std::vector<Vector2>> outer = ringsOf(relation, "outer");
    if (outer.empty()) {
      warnings_.add("areas without a usable outer ring", relation.id);
      return;
    }
    std::vector<Polygon>& areas = is_walkway ? map_.walkways : map_.drivable_area;
    const std::size_t first = areas.size();
    for (std::vector<Vector2>& ring : outer) areas.push_back({std::move(ring), {}});
    for (std::vector<Vector2>& hole : ringsOf(relation, "inner")) {
      const auto around =
          std::find_if(areas.begin() + static_cast<std::ptrdiff_t>(first), areas.end(),
                       [&](const Polygon& area) { return contains(area, hole.front()); });
      if (around != areas.end()) around->holes.push_back(std::move(hole));
    }
  }

  void addRing(const std::string& way, std::vector<Polygon>& areas) {
    std::vector<Vector2> ring = pointsOf(file_.ways.at(way).nodes);
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < 3) {
      warnings_.add("polygons with fewer than three usable nodes", way);
    } else {
      areas.push_back({std::move(ring), {}});
    }
  }

  std::vector<Vector2> pointsOf(const std::vector<std::string>& nodes) const {
    std::vector<Vector2> points;
    for (const std::string& node : nodes) {
      const auto place = file_.nodes.find(node);
      if (place != file_.nodes.end()) points.push_back(place->second);
    }
    return points;
  }

  /// Returns the rings that the relation's ways with a role form: each way continues at the node at
  /// which another ends, in either direction. Leaves out ways that form no ring.
  std::vector<std::vector<Vector2>> ringsOf(const OsmRelation& relation, const char* role) const {
    std::vector<std::vector<std::string>> rest;
    const auto [begin, end] = relation.ways.equal_range(role);
    for (auto member = begin; member != end; ++member) {
      const auto way = file_.ways.find(member->second);
      if (way != file_.ways.end() && way->second.nodes.size() > 1)
        rest.push_back(way->second.nodes);
    }
    std::vector<std::vector<Vector2>> rings;
    while (!rest.empty()) {
      std::vector<std::string> ring = std::move(rest.back());
      rest.pop_back();
      while (ring.front() != ring.back() && appendNext(rest, ring)) {
      }
      if (ring.front() != ring.back()) continue;
      ring.pop_back();
      std::vector<Vector2> points = pointsOf(ring);
      if (points.size() >= 3) rings.push_back(std::move(points));
    }
    return rings;
  }

  /// Moves the way that continues at the end of `ring` from `rest` to `ring`.
  static bool appendNext(std::vector<std::vector<std::string>>& rest,
                         std::vector<std::string>& ring) {
    for (auto way = rest.begin(); way != rest.end(); ++way) {
      if (way->back() == ring.back()) std::reverse(way->begin(), way->end());
      if (way->front() != ring.back()) continue;
      ring.insert(ring.end(), way->begin() + 1, way->end());
      rest.erase(way);
      return true;
    }
    return false;
  }

  void link() {
    for (std::size_t i = 0; i < map_.lanes.size(); ++i) {
      const auto next = starts_.find(ends_[i]);
      if (next != starts_.end()) map_.lanes[i].outgoing = next->second;
    }
    linkMutually(map_.lanes);
  }

  /// A way that is the left bound of lanes in both directions lies between lanes that have each
  /// other to the left.
  OppositeNeighbours oppositeNeighbours() const {
    const auto pairs = [](const auto& sides) {
      return static_cast<int>(std::count_if(
          sides.begin(), sides.end(), [](const auto& side) { return side.second.size() > 1; }));
    };
    return {pairs(lefts_), pairs(rights_)};
  }

  const OsmFile& file_;
  const std::string location_;
  const DataOptions& options_;
  WarningCounter& warnings_;
  LaneMap map_;
  bool has_turns_ = false;                           // a lanelet has a turn_direction
  std::map<Ends, std::vector<std::string>> starts_;  // lanes by their first nodes
  std::vector<Ends> ends_;                           // last nodes of each lane
  std::map<std::string, std::set<bool>> lefts_;      // directions in which a way is a left bound
  std::map<std::string, std::set<bool>> rights_;
};

}  // namespace

LaneMap readLanelet2Map(const std::string& path, const DataOptions& options,
                        std::vector<std::string>& warnings) {
  WarningCounter counter;
  const OsmFile file = readOsmFile(path, options, counter);
  const std::string location = std::filesystem::path(path).stem().string();
  LaneMap map = MapBuilder(file, location, options, counter).build();
  for (std::string& line : counter.lines(path)) warnings.push_back(std::move(line));
  return map;
}

}  // namespace forge
