#include "collision_forge/io/export/common_road.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <utility>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/io/export/common_road_lanelets.h"
#include "collision_forge/io/export/common_road_terms.h"
#include "collision_forge/io/export/linked_lanes.h"
#include "collision_forge/io/export/xml.h"

namespace forge {
namespace {

using pugi::xml_node;

constexpr int kEgoNumber = 1;
constexpr int kAttackerNumber = 2;
constexpr int kProblemNumber = 3;
constexpr double kStandDistance = 0.1;     // m from the first position
constexpr double kStandTurn = 0.05;        // rad from the first heading
constexpr double kUnknownDegrees = 999.0;  // the format's value for an unknown place
constexpr const char* kUnknownGeoName = "-999";

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
    const std::vector<Lane> bike_lanes = bikeLanesOf(record_.lanes);
    const std::vector<Lanelet> lanelets =
        laneletsOf(record_.lanes, bike_lanes, plan_.options.lane_width, next_number_);
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
    addText(element, "laneletType", lanelet.is_for_bikes ? "bicycleLane" : "urban");
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
