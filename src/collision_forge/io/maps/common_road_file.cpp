#include "collision_forge/io/maps/common_road_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/io/maps/map_error.h"
#include "collision_forge/io/maps/xml_input.h"

namespace forge {
namespace {

using pugi::xml_node;

constexpr double kLeastInterval = 1e-5;  // s between states; times are stored in microseconds

std::string idOf(const xml_node& element) { return element.attribute("id").value(); }

std::optional<double> numberOf(const xml_node& element) {
  return finiteNumber(element.text().get());
}

/// Returns an exact value, or the middle of an interval.
std::optional<double> valueOf(const xml_node& element) {
  if (const xml_node exact = element.child("exact")) return numberOf(exact);
  const auto start = numberOf(element.child("intervalStart"));
  const auto end = numberOf(element.child("intervalEnd"));
  if (!start || !end) return std::nullopt;
  return 0.5 * (*start + *end);
}

std::optional<Vector2> pointIn(const xml_node& element, const InputLimits& limits) {
  const auto x = numberOf(element.child("x"));
  const auto y = numberOf(element.child("y"));
  if (!x || !y || !isWithin(Vector2(*x, *y), limits)) return std::nullopt;
  return Vector2(*x, *y);
}

/// Returns the points that can be used.
std::vector<Vector2> pointsIn(const xml_node& element, const InputLimits& limits) {
  std::vector<Vector2> points;
  for (const xml_node& child : element.children("point")) {
    if (const auto point = pointIn(child, limits)) points.push_back(*point);
  }
  return points;
}

/// Returns the point of a state, or the centre of its region.
std::optional<Vector2> positionIn(const xml_node& position, const InputLimits& limits) {
  if (const xml_node point = position.child("point")) return pointIn(point, limits);
  for (const char* const shape : {"rectangle", "circle"}) {
    if (const xml_node found = position.child(shape)) {
      return pointIn(found.child("center"), limits);
    }
  }
  return std::nullopt;
}

std::vector<std::string> refsOf(const xml_node& element, const char* name) {
  std::vector<std::string> refs;
  for (const xml_node& child : element.children(name)) {
    refs.emplace_back(child.attribute("ref").value());
  }
  return refs;
}

std::set<std::string> textsOf(const xml_node& element, const char* name) {
  std::set<std::string> texts;
  for (const xml_node& child : element.children(name)) texts.insert(child.text().get());
  return texts;
}

bool isOncoming(const xml_node& adjacent) {
  return std::strcmp(adjacent.attribute("drivingDir").value(), "opposite") == 0;
}

AgentClass classOf(const std::string& type) {
  static const std::map<std::string, AgentClass> kClasses = {
      {"car", AgentClass::kCar},
      {"taxi", AgentClass::kCar},
      {"parkedVehicle", AgentClass::kCar},
      {"truck", AgentClass::kTruck},
      {"bus", AgentClass::kBus},
      {"priorityVehicle", AgentClass::kEmergencyVehicle},
      {"motorcycle", AgentClass::kMotorcycle},
      {"bicycle", AgentClass::kBicycle},
      {"pedestrian", AgentClass::kPedestrian}};
  const auto found = kClasses.find(type);
  return found == kClasses.end() ? AgentClass::kStaticObject : found->second;
}

/// Returns the size of the box around a polygon, whose points are in the obstacle's frame.
std::optional<BoxSize> sizeAround(const std::vector<Vector2>& points) {
  if (points.size() < 3) return std::nullopt;
  Eigen::AlignedBox2d box;
  for (const Vector2& point : points) box.extend(point);
  return BoxSize{box.sizes().x(), box.sizes().y()};
}

std::optional<BoxSize> sizeOf(const xml_node& shape, const InputLimits& limits) {
  if (const xml_node rectangle = shape.child("rectangle")) {
    const auto length = numberOf(rectangle.child("length"));
    const auto width = numberOf(rectangle.child("width"));
    if (length && width) return BoxSize{*length, *width};
  }
  if (const auto radius = numberOf(shape.child("circle").child("radius"))) {
    return BoxSize{2.0 * *radius, 2.0 * *radius};
  }
  return sizeAround(pointsIn(shape.child("polygon"), limits));
}

std::optional<DrivingSide> sideIn(const std::string& source) {
  const std::string key = kDrivingSideKey;
  const std::size_t found = source.find(key);
  if (found == std::string::npos) return std::nullopt;
  const bool is_left = source.compare(found + key.size(), 4, "left") == 0;
  return is_left ? DrivingSide::kLeft : DrivingSide::kRight;
}

class FileReader {
 public:
  FileReader(const std::string& path, const DataOptions& options, WarningCounter& warnings)
      : limits_(options.input_limits), warnings_(warnings) {
    loadXml(path, document_);
    root_ = document_.document_element();
    file_.benchmark = root_.attribute("benchmarkID").value();
    file_.driving_side = sideIn(root_.attribute("source").value());
    file_.step = numberIn(root_, "timeStepSize", path);
    if (file_.step <= 0.0) throw MapError(path + ": timeStepSize is not above 0");
  }

  CommonRoadFile read() {
    findIntersections();
    for (const xml_node& lanelet : root_.children("lanelet")) addLanelet(lanelet);
    for (const xml_node& element : root_.children()) {
      const std::string name = element.name();
      const std::string role = element.child("role").text().get();  // 2018b
      if (name == "staticObstacle" || (name == "obstacle" && role == "static")) {
        addObstacle(element, true);
      } else if (name == "dynamicObstacle" || name == "obstacle") {
        addObstacle(element, false);
      } else if (name == "planningProblem") {
        if (const auto state = stateIn(element.child("initialState"))) {
          file_.problem_starts.push_back(*state);
        }
      }
    }
    return std::move(file_);
  }

 private:
  void findIntersections() {
    constexpr const char* kTurns[] = {"successorsRight", "successorsStraight", "successorsLeft"};
    for (const xml_node& intersection : root_.children("intersection")) {
      for (const xml_node& incoming : intersection.children("incoming")) {
        for (const char* const turn : kTurns) {
          for (const std::string& id : refsOf(incoming, turn)) in_intersections_.insert(id);
        }
      }
    }
  }

  void addLanelet(const xml_node& element) {
    CommonRoadLanelet lanelet;
    lanelet.id = idOf(element);
    lanelet.bounds = {pointsIn(element.child("leftBound"), limits_),
                      pointsIn(element.child("rightBound"), limits_)};
    if (lanelet.bounds.left.size() < 2 || lanelet.bounds.right.size() < 2) {
      warnings_.add("lanelets without a usable left or right bound", lanelet.id);
      return;
    }
    lanelet.predecessors = refsOf(element, "predecessor");
    lanelet.successors = refsOf(element, "successor");
    lanelet.oncoming_left = isOncoming(element.child("adjacentLeft"));
    lanelet.oncoming_right = isOncoming(element.child("adjacentRight"));
    lanelet.types = textsOf(element, "laneletType");
    lanelet.users_one_way = textsOf(element, "userOneWay");
    lanelet.users_both_ways = textsOf(element, "userBidirectional");
    lanelet.speed_limit = speedLimitOf(element);
    lanelet.is_in_intersection =
        lanelet.types.count("intersection") > 0 || in_intersections_.count(lanelet.id) > 0;
    file_.lanelets.push_back(std::move(lanelet));
  }

  /// Returns the lanelet's own limit (2018b) or the limit of its traffic sign (2020a), m/s.
  std::optional<double> speedLimitOf(const xml_node& lanelet) const {
    // Numbers of speed limit signs, commonroad-io, scenario/traffic_sign.py.
    static const std::set<std::string> kSigns = {"274", "R2-1", "r301", "3.24",
                                                 "R15", "C43",  "B14",  "B31"};
    auto limit = numberOf(lanelet.child("speedLimit"));
    for (const std::string& id : refsOf(lanelet, "trafficSignRef")) {
      const xml_node sign = root_.find_child_by_attribute("trafficSign", "id", id.c_str());
      for (const xml_node& element : sign.children("trafficSignElement")) {
        if (kSigns.count(element.child("trafficSignID").text().get()) == 0) continue;
        limit = numberOf(element.child("additionalValue"));
      }
    }
    const bool is_usable = limit && *limit > 0.0 && *limit <= limits_.max_speed;
    return is_usable ? limit : std::nullopt;
  }

  /// Returns the state, nullopt without position, heading or time. The speed is NaN if it is not in
  /// the file.
  std::optional<AgentState> stateIn(const xml_node& element) const {
    const auto position = positionIn(element.child("position"), limits_);
    const auto yaw = valueOf(element.child("orientation"));
    const auto step = valueOf(element.child("time"));
    if (!position || !yaw || !step || *step < 0.0) return std::nullopt;
    const double time = *step * file_.step;
    if (time > limits_.max_time) return std::nullopt;
    const Pose2 pose{position->x(), position->y(), wrapAngle(*yaw)};
    const double speed = valueOf(element.child("velocity")).value_or(std::nan(""));
    return AgentState{time, pose, speed * pose.heading()};
  }

  void addObstacle(const xml_node& element, bool is_static) {
    CommonRoadObstacle obstacle;
    obstacle.is_static = is_static;
    Track& track = obstacle.track;
    track.id = idOf(element);
    track.agent_class = classOf(element.child("type").text().get());
    const auto size = sizeOf(element.child("shape"), limits_);
    if (!size || !isWithin(*size, limits_)) {
      warnings_.add("obstacles without a usable shape", track.id);
      return;
    }
    track.size = *size;
    addState(element.child("initialState"), track);
    for (const xml_node& state : element.child("trajectory").children("state")) {
      addState(state, track);
    }
    if (!is_static && track.states.size() < 2) {
      warnings_.add("dynamic obstacles without a trajectory", track.id);
      return;
    }
    if (track.states.empty()) return;
    completeVelocities(track);
    file_.obstacles.push_back(std::move(obstacle));
  }

  void addState(const xml_node& element, Track& track) const {
    const auto state = stateIn(element);
    const bool is_later =
        state && (track.states.empty() || state->time > track.states.back().time + kLeastInterval);
    if (is_later) {
      track.states.push_back(*state);
    } else {
      warnings_.add("states without a usable position, orientation or time", track.id);
    }
  }

  /// Derives the velocities that the file does not have or that are beyond the limits.
  void completeVelocities(Track& track) const {
    Track derived = track;
    deriveVelocities(derived);
    for (std::size_t i = 0; i < track.states.size(); ++i) {
      Vector2& velocity = track.states[i].velocity;
      if (!(velocity.norm() <= limits_.max_speed)) velocity = derived.states[i].velocity;
    }
  }

  const InputLimits& limits_;
  WarningCounter& warnings_;
  pugi::xml_document document_;
  xml_node root_;
  std::set<std::string> in_intersections_;
  CommonRoadFile file_;
};

}  // namespace

CommonRoadFile readCommonRoadFile(const std::string& path, const DataOptions& options,
                                  WarningCounter& warnings) {
  return FileReader(path, options, warnings).read();
}

}  // namespace forge
