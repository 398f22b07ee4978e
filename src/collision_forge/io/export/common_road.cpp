#include "collision_forge/io/export/common_road.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/io/export/road_course.h"
#include "collision_forge/io/export/xml.h"
#include "collision_forge/io/maps/common_road_file.h"

namespace forge {
namespace {

using pugi::xml_node;

constexpr int kEgoNumber = 1;
constexpr int kAttackerNumber = 2;
constexpr int kProblemNumber = 3;
constexpr int kDecimals = 6;         // for m, rad, m/s and s
constexpr double kSamePoint = 1e-3;  // m; closer points of a centreline are merged
constexpr double kLargestBendShare =
    0.9;  // largest offset of an inner bound, share of the bend's radius
constexpr double kBesideTolerance = 0.25;     // share of the lane's width
constexpr double kBesideHeading = 0.2;        // rad
constexpr double kStandDistance = 0.1;        // m from the first position
constexpr double kStandTurn = 0.05;           // rad from the first heading
constexpr double kStraightTurn = M_PI / 6.0;  // rad; lanes that turn more are left or right turns
constexpr double kUnknownDegrees = 999.0;     // the format's value for an unknown place
constexpr const char* kUnknownGeoName = "-999";

/// Returns a number as xs:decimal, which has no exponent.
std::string decimal(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("a number for XML is not finite");
  std::array<char, 512> buffer;
  char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                  std::chars_format::fixed, kDecimals)
                        .ptr;
  std::string text(buffer.data(), end);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

void addText(xml_node parent, const char* name, const std::string& text) {
  addElement(parent, name).text().set(text.c_str());
}

void addDecimal(xml_node parent, const char* name, double value) {
  addText(parent, name, decimal(value));
}

void addExact(xml_node parent, const char* name, double value) {
  addDecimal(addElement(parent, name), "exact", value);
}

void addPoint(xml_node parent, const char* name, const Vector2& point) {
  const xml_node element = addElement(parent, name);
  addDecimal(element, "x", point.x());
  addDecimal(element, "y", point.y());
}

/// A lane and the data of its lanelet.
struct Lanelet {
  int number = 0;
  const Lane* lane = nullptr;
  std::vector<Pose2> middle;  ///< two or more distinct poses
  double width = 0.0;         ///< m
  int left = 0;               ///< number of the adjacent lanelet; 0: none
  int right = 0;
};

std::vector<Pose2> distinctPoses(const std::vector<Pose2>& poses) {
  std::vector<Pose2> distinct;
  for (const Pose2& pose : poses) {
    if (distinct.empty() || (pose.position() - distinct.back().position()).norm() > kSamePoint) {
      distinct.push_back(pose);
    }
  }
  return distinct;
}

double lengthOf(const std::vector<Pose2>& poses) {
  double length = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    length += (poses[i].position() - poses[i - 1].position()).norm();
  }
  return length;
}

/// Returns the left (+1) or right (-1) bound. The middle of both bounds is the centreline; in a
/// tight bend the lanelet is narrower, so that the inner bound never runs backwards.
std::vector<Vector2> boundOf(const Lanelet& lanelet, double side) {
  const std::vector<Pose2>& middle = lanelet.middle;
  std::vector<double> offsets(middle.size(), 0.5 * lanelet.width);
  for (std::size_t i = 1; i < middle.size(); ++i) {
    const double turn = std::abs(angleBetween(middle[i - 1].yaw, middle[i].yaw));
    if (turn == 0.0) continue;
    const double length = (middle[i].position() - middle[i - 1].position()).norm();
    const double most = kLargestBendShare * length / turn;
    offsets[i - 1] = std::min(offsets[i - 1], most);
    offsets[i] = std::min(offsets[i], most);
  }
  std::vector<Vector2> bound;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    bound.push_back(compose(middle[i], {0.0, side * offsets[i], 0.0}).position());
  }
  return bound;
}

/// Returns true if the pose `left` is next to `right`, `distance` to its left, with equal heading.
bool isBeside(const Pose2& left, const Pose2& right, double distance) {
  if (std::abs(angleBetween(left.yaw, right.yaw)) > kBesideHeading) return false;
  const Pose2 between = interpolate(left, right, 0.5);
  const Pose2 seen = relativeTo({right.x, right.y, between.yaw}, left);
  const double tolerance = kBesideTolerance * distance;
  return std::abs(seen.x) <= tolerance && std::abs(seen.y - distance) <= tolerance;
}

Pose2 middleOf(const std::vector<Pose2>& poses) {
  std::vector<Vector2> points;
  for (const Pose2& pose : poses) points.push_back(pose.position());
  const Polyline line(points);
  return line.poseAt(0.5 * line.length());
}

/// Returns true if the lanelets are side by side from start to end.
bool areBeside(const Lanelet& left, const Lanelet& right) {
  const double distance = 0.5 * (left.width + right.width);
  return isBeside(left.middle.front(), right.middle.front(), distance) &&
         isBeside(left.middle.back(), right.middle.back(), distance) &&
         isBeside(middleOf(left.middle), middleOf(right.middle), distance);
}

/// Sets adjacent lanelets; none on a side with two candidates, for instance where lanes overlap.
void findNeighbours(std::vector<Lanelet>& lanelets) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  // left, right
  std::map<std::size_t, int> lefts;                        // number of candidates by lanelet
  std::map<std::size_t, int> rights;
  for (std::size_t left = 0; left < lanelets.size(); ++left) {
    for (std::size_t right = 0; right < lanelets.size(); ++right) {
      if (left == right || !areBeside(lanelets[left], lanelets[right])) continue;
      pairs.emplace_back(left, right);
      ++lefts[right];
      ++rights[left];
    }
  }
  for (const auto& [left, right] : pairs) {
    if (lefts[right] > 1 || rights[left] > 1) continue;
    lanelets[left].right = lanelets[right].number;
    lanelets[right].left = lanelets[left].number;
  }
}

/// Returns the lanes that have a centreline as lanelets, numbered from `first`.
std::vector<Lanelet> laneletsOf(const LaneMap& map, double lane_width, int first) {
  std::vector<Lanelet> lanelets;
  for (const Lane& lane : map.lanes) {
    Lanelet lanelet{first, &lane, distinctPoses(lane.centerline)};
    if (lanelet.middle.size() < 2) continue;
    lanelet.width = widthOf(lane, lengthOf(lanelet.middle), lane_width);
    lanelets.push_back(std::move(lanelet));
    ++first;
  }
  findNeighbours(lanelets);
  return lanelets;
}

/// Returns "" for classes that are dynamic obstacles even at rest: no static type describes them.
const char* staticTypeOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
    case AgentClass::kAnimal:
      return "";
    case AgentClass::kStaticObject:
      return "unknown";
    default:
      return "parkedVehicle";
  }
}

const char* dynamicTypeOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kCar:
      return "car";
    case AgentClass::kTruck:
    case AgentClass::kTrailer:
    case AgentClass::kConstructionVehicle:
      return "truck";
    case AgentClass::kBus:
      return "bus";
    case AgentClass::kEmergencyVehicle:
      return "priorityVehicle";
    case AgentClass::kMotorcycle:
      return "motorcycle";
    case AgentClass::kBicycle:
    case AgentClass::kScooter:
      return "bicycle";
    case AgentClass::kPedestrian:
    case AgentClass::kChild:
    case AgentClass::kRunner:
      return "pedestrian";
    case AgentClass::kAnimal:
    case AgentClass::kStaticObject:
      break;
  }
  return "unknown";
}

const char* nameOf(LightColor color) {
  switch (color) {
    case LightColor::kRed:
      return "red";
    case LightColor::kYellow:
      return "yellow";
    case LightColor::kGreen:
      return "green";
    case LightColor::kUnknown:
      break;
  }
  return "inactive";
}

/// Returns the direction in which a lane turns, as a traffic light names it.
const char* directionOf(const Lane& lane) {
  if (lane.centerline.size() < 2) return "all";
  const double turn = angleBetween(lane.centerline.front().yaw, lane.centerline.back().yaw);
  if (std::abs(turn) < kStraightTurn) return "straight";
  return turn > 0.0 ? "left" : "right";
}

bool standsStill(const Track& track) {
  const Pose2& first = track.states.front().pose;
  return std::all_of(track.states.begin(), track.states.end(), [&](const AgentState& state) {
    return (state.pose.position() - first.position()).norm() <= kStandDistance &&
           std::abs(angleBetween(first.yaw, state.pose.yaw)) <= kStandTurn;
  });
}

double speedAlongHeading(const AgentState& state) {
  return state.velocity.dot(state.pose.heading());
}

/// Returns the country of a location by its prefix; else Zamunda, CommonRoad's fictitious country.
const char* countryOf(const std::string& location) {
  if (location.rfind("boston", 0) == 0) return "USA";
  if (location.rfind("singapore", 0) == 0) return "SGP";
  return "ZAM";
}

/// Returns the letters and digits of a name in camel case.
std::string joinedWords(const std::string& name) {
  std::string joined;
  bool is_first = true;
  for (const unsigned char letter : name) {
    const bool is_kept = std::isalnum(letter) != 0;
    if (is_kept) joined += static_cast<char>(is_first ? std::toupper(letter) : letter);
    is_first = !is_kept;
  }
  return joined;
}

/// Returns the benchmark id, as "SGP_SingaporeOnenorthScene0061-1_17_T-1": map, line of the
/// scenario, trajectory prediction.
std::string benchmarkOf(const CrashRecord& record) {
  const std::string& location = record.lanes.location;
  const std::string line = record.name.substr(record.name.rfind('_') + 1);
  return std::string(countryOf(location)) + "_" + joinedWords(location) +
         joinedWords(record.scenario.asked.scene) + "-1_" + line + "_T-1";
}

/// Returns facts for which the format has no field.
std::string sourceOf(const CrashRecord& record) {
  const SceneRequest& asked = record.scenario.asked;
  std::string source = "scene=" + asked.scene + "; type=" + toString(asked.request.type) +
                       "; tta=" + decimal(asked.request.tta) +
                       "; manoeuvre=" + toString(record.scenario.answer.report.manoeuvre) +
                       "; attacker=" + record.attacker.id +
                       "; seed=" + std::to_string(asked.request.seed) +
                       "; now=" + decimal(record.now) + "; " + kDrivingSideKey +
                       (record.lanes.driving_side == DrivingSide::kLeft ? "left" : "right");
  if (record.contact) source += "; contact=" + decimal(*record.contact);
  return source;
}

std::set<std::string> tagsOf(const CrashRecord& record) {
  std::set<std::string> tags = {"critical", "simulated", "urban"};
  switch (record.scenario.asked.request.type) {
    case CollisionType::kLaneChange:
      tags.insert("lane_change");
      break;
    case CollisionType::kOppositeDirection:
      tags.insert("oncoming_traffic");
      break;
    case CollisionType::kRearEnd:
      tags.insert("lane_following");
      break;
    case CollisionType::kJunctionCrossing:
      tags.insert("intersection");
      break;
    case CollisionType::kSideswipeSameDirection:
      tags.insert("lane_change");
      break;
    case CollisionType::kAngleSameDirection:
      tags.insert("intersection");
      break;
    case CollisionType::kAngleOppositeDirection:
      tags.insert("oncoming_traffic");
      break;
    case CollisionType::kAny:
      break;
    case CollisionType::kLtap:
      tags.insert({"intersection", "oncoming_traffic"});
      break;
  }
  const Manoeuvre manoeuvre = record.scenario.answer.report.manoeuvre;
  if (manoeuvre == Manoeuvre::kCutIn) tags.insert("cut_in");
  if (manoeuvre == Manoeuvre::kMerge) tags.insert("merging_lanes");
  return tags;
}

/// Writes one scenario.
class CommonRoadFile {
 public:
  CommonRoadFile(const CrashRecord& record, const ExportPlan& plan)
      : record_(record), plan_(plan) {}

  std::string text() {
    pugi::xml_document document;
    document.append_child(pugi::node_declaration).append_attribute("version") = "1.0";
    const xml_node root = addHeader(document);
    addLocation(root);
    const xml_node tags = addElement(root, "scenarioTags");
    for (const std::string& tag : tagsOf(record_)) addElement(tags, tag.c_str());
    addLanelets(root);
    for (const Track& other : record_.other_agents) {
      if (isStatic(other)) addStatic(root, other);
    }
    addMoving(root);
    addProblem(root);
    return xmlText(document);
  }

 private:
  xml_node addHeader(pugi::xml_document& document) const {
    const std::string day = xmlDate(record_.scenario.asked.now).substr(0, 10);
    return addElement(document, "commonRoad",
                      {{"commonRoadVersion", "2020a"},
                       {"benchmarkID", benchmarkOf(record_)},
                       {"date", day},
                       {"author", "collision_forge"},
                       {"affiliation", "collision_forge"},
                       {"source", sourceOf(record_)},
                       {"timeStepSize", decimal(record_.step)}});
  }

  void addLocation(xml_node root) const {
    const GeoPoint& origin = record_.origin;
    const bool is_known = origin.latitude != 0.0 || origin.longitude != 0.0;
    const xml_node location = addElement(root, "location");
    addText(location, "geoNameId", kUnknownGeoName);
    addDecimal(location, "gpsLatitude", is_known ? origin.latitude : kUnknownDegrees);
    addDecimal(location, "gpsLongitude", is_known ? origin.longitude : kUnknownDegrees);
  }

  void addLanelets(xml_node root) {
    const std::vector<Lanelet> lanelets =
        laneletsOf(record_.lanes, plan_.options.lane_width, next_number_);
    next_number_ += static_cast<int>(lanelets.size());
    std::unordered_map<std::string, int> numbers;
    for (const Lanelet& lanelet : lanelets) numbers.emplace(lanelet.lane->id, lanelet.number);
    std::unordered_map<std::string, std::vector<int>> lights;  // by lane before the stop line
    for (std::size_t i = 0; i < record_.lights.size(); ++i) {
      for (const std::string& lane : laneOf(record_.lights[i]).incoming) {
        lights[lane].push_back(next_number_ + static_cast<int>(i));
      }
    }
    for (const Lanelet& lanelet : lanelets) {
      addLanelet(root, lanelet, numbers, lights[lanelet.lane->id]);
    }
    for (const TrafficLight& light : record_.lights) addLight(root, light, next_number_++);
  }

  const Lane& laneOf(const TrafficLight& light) const {
    return *std::find_if(record_.lanes.lanes.begin(), record_.lanes.lanes.end(),
                         [&](const Lane& lane) { return lane.id == light.lane; });
  }

  /// Adds a light with its colours from step 0 to the end as one cycle.
  void addLight(xml_node root, const TrafficLight& light, int number) const {
    const xml_node element = addElement(root, "trafficLight", {{"id", std::to_string(number)}});
    const xml_node cycle = addElement(element, "cycle");
    const auto last = static_cast<long>(record_.ego.states.size());
    for (long begin = 0, end = 0; begin < last; begin = end) {
      const LightColor color = colorAt(light, static_cast<double>(begin) * record_.step);
      while (end < last && colorAt(light, static_cast<double>(end) * record_.step) == color) ++end;
      const xml_node part = addElement(cycle, "cycleElement");
      addText(part, "duration", std::to_string(end - begin));
      addText(part, "color", nameOf(color));
    }
    addPoint(addElement(element, "position"), "point", light.stop_point);
    addText(element, "direction", directionOf(laneOf(light)));
    addText(element, "active", "true");
  }

  static void addLanelet(xml_node root, const Lanelet& lanelet,
                         const std::unordered_map<std::string, int>& numbers,
                         const std::vector<int>& lights) {
    const xml_node element = addElement(root, "lanelet", {{"id", std::to_string(lanelet.number)}});
    for (const auto& [name, side] : {std::pair("leftBound", 1.0), std::pair("rightBound", -1.0)}) {
      const xml_node bound = addElement(element, name);
      for (const Vector2& point : boundOf(lanelet, side)) addPoint(bound, "point", point);
    }
    addLinks(element, "predecessor", lanelet.lane->incoming, numbers);
    addLinks(element, "successor", lanelet.lane->outgoing, numbers);
    addNeighbour(element, "adjacentLeft", lanelet.left);
    addNeighbour(element, "adjacentRight", lanelet.right);
    addText(element, "laneletType", "urban");
    if (lanelet.lane->is_intersection || lanelet.lane->is_connector)
      addText(element, "laneletType", "intersection");
    for (const int light : lights) {
      addElement(element, "trafficLightRef", {{"ref", std::to_string(light)}});
    }
  }

  static void addLinks(xml_node lanelet, const char* name, const std::vector<std::string>& lanes,
                       const std::unordered_map<std::string, int>& numbers) {
    std::set<int> linked;
    for (const std::string& lane : lanes) {
      const auto found = numbers.find(lane);
      if (found != numbers.end()) linked.insert(found->second);
    }
    for (const int number : linked) addElement(lanelet, name, {{"ref", std::to_string(number)}});
  }

  static void addNeighbour(xml_node lanelet, const char* name, int number) {
    if (number == 0) return;
    addElement(lanelet, name, {{"ref", std::to_string(number)}, {"drivingDir", "same"}});
  }

  /// A vehicle is static only if it is in sight throughout; an object always is.
  bool isStatic(const Track& track) const {
    if (track.agent_class == AgentClass::kStaticObject) return true;
    if (*staticTypeOf(track.agent_class) == '\0') return false;
    return track.states.size() == record_.ego.states.size() && standsStill(track);
  }

  void addStatic(xml_node root, const Track& track) {
    const xml_node obstacle =
        addObstacle(root, "staticObstacle", staticTypeOf(track.agent_class), track, next_number_++);
    AgentState state = track.states.front();
    state.velocity = Vector2::Zero();
    state.time = 0.0;
    addState(obstacle, "initialState", state);
  }

  void addMoving(xml_node root) {
    if (!plan_.ego_free) addStretch(root, record_.ego, record_.ego.states, kEgoNumber);
    addStretch(root, record_.attacker, record_.attacker.states, kAttackerNumber);
    for (const Track& other : record_.other_agents) {
      if (isStatic(other)) continue;
      for (const std::vector<AgentState>& states : splitAtGaps(other, record_.step)) {
        if (states.size() > 1) addStretch(root, other, states, next_number_++);
      }
    }
  }

  void addStretch(xml_node root, const Track& track, const std::vector<AgentState>& states,
                  int number) const {
    const char* const type = dynamicTypeOf(track.agent_class);
    const xml_node obstacle = addObstacle(root, "dynamicObstacle", type, track, number);
    addState(obstacle, "initialState", states.front());
    const xml_node trajectory = addElement(obstacle, "trajectory");
    for (std::size_t i = 1; i < states.size(); ++i) addState(trajectory, "state", states[i]);
  }

  static xml_node addObstacle(xml_node root, const char* name, const char* type, const Track& track,
                              int number) {
    const xml_node obstacle = addElement(root, name, {{"id", std::to_string(number)}});
    addText(obstacle, "type", type);
    const xml_node rectangle = addElement(addElement(obstacle, "shape"), "rectangle");
    addDecimal(rectangle, "length", track.size.length);
    addDecimal(rectangle, "width", track.size.width);
    return obstacle;
  }

  xml_node addState(xml_node parent, const char* name, const AgentState& state) const {
    const xml_node element = addElement(parent, name);
    addPoint(addElement(element, "position"), "point", state.pose.position());
    addExact(element, "orientation", wrapAngle(state.pose.yaw));
    addText(addElement(element, "time"), "exact", stepOf(state.time));
    addExact(element, "velocity", speedAlongHeading(state));
    return element;
  }

  void addProblem(xml_node root) const {
    const xml_node problem =
        addElement(root, "planningProblem", {{"id", std::to_string(kProblemNumber)}});
    const std::vector<AgentState>& states = record_.ego.states;
    const auto now = static_cast<std::size_t>(std::lround(record_.now / record_.step));
    const xml_node initial = addState(problem, "initialState", states.at(now));
    const AgentState& before = states[now == 0 ? 0 : now - 1];
    const AgentState& after = states[std::min(now + 1, states.size() - 1)];
    addExact(initial, "yawRate",
             angleBetween(before.pose.yaw, after.pose.yaw) / (after.time - before.time));
    addExact(initial, "slipAngle", 0.0);
    addGoal(addElement(problem, "goalState"));
  }

  void addGoal(xml_node goal) const {
    const xml_node time = addElement(goal, "time");
    addText(time, "intervalStart", stepOf(record_.end()));
    addText(time, "intervalEnd", stepOf(record_.end()));
    if (plan_.ego_free) return;
    const Pose2& last = record_.ego.states.back().pose;
    const xml_node rectangle = addElement(addElement(goal, "position"), "rectangle");
    addDecimal(rectangle, "length", record_.ego.size.length);
    addDecimal(rectangle, "width", record_.ego.size.width);
    addDecimal(rectangle, "orientation", wrapAngle(last.yaw));
    addPoint(rectangle, "center", last.position());
  }

  std::string stepOf(double time) const { return std::to_string(std::lround(time / record_.step)); }

  const CrashRecord& record_;
  const ExportPlan& plan_;
  int next_number_ = kProblemNumber + 1;
};

class CommonRoadWriter : public CrashWriter {
 public:
  explicit CommonRoadWriter(const ExportPlan& plan) : plan_(plan) {}

  std::vector<std::string> write(const CrashRecord& record) const override {
    const std::string name = record.name + ".xml";
    writeText(pathIn(plan_.folder, name), CommonRoadFile(record, plan_).text());
    return {name};
  }

 private:
  ExportPlan plan_;
};

}  // namespace

std::unique_ptr<CrashWriter> makeCommonRoadWriter(const ExportPlan& plan) {
  return std::make_unique<CommonRoadWriter>(plan);
}

}  // namespace forge
