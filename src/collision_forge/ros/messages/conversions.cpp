#include "collision_forge/ros/messages/conversions.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

BoxSize fromMessage(const geometry_msgs::Vector3& message) { return {message.x, message.y}; }

/// NaN for a quaternion that is not finite.
template <typename Quaternion>
double yawOf(const Quaternion& q) {
  if (!std::isfinite(q.w + q.x + q.y + q.z)) return std::numeric_limits<double>::quiet_NaN();
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

/// Corners of polygons are float32: relative to an origin within 6 km their error is below 1 mm.
/// A multiple of this power of two makes the subtraction exact, and is zero for most local maps.
constexpr double kOriginGrid = 8192.0;  // m

Vector2 originOf(const LaneMap& map) {
  Vector2 near = Vector2::Zero();
  for (const Lane& lane : map.lanes) {
    if (lane.centerline.empty()) continue;
    near = lane.centerline.front().position();
    break;
  }
  return {kOriginGrid * std::round(near.x() / kOriginGrid),
          kOriginGrid * std::round(near.y() / kOriginGrid)};
}

geometry_msgs::Polygon toPolygonMessage(const std::vector<Vector2>& ring, const Vector2& origin) {
  geometry_msgs::Polygon message;
  for (const Vector2& point : ring) {
    geometry_msgs::Point32 corner;
    corner.x = static_cast<float>(point.x() - origin.x());
    corner.y = static_cast<float>(point.y() - origin.y());
    message.points.push_back(corner);
  }
  return message;
}

std::vector<Vector2> fromMessage(const geometry_msgs::Polygon& message, const Vector2& origin) {
  std::vector<Vector2> ring;
  for (const auto& point : message.points) ring.push_back(origin + Vector2(point.x, point.y));
  return ring;
}

/// Converts the constant of a field, at most `last`. Throws MessageError for a larger one.
template <typename Value>
Value enumOf(std::uint8_t value, Value last, const std::string& field) {
  if (value > static_cast<std::uint8_t>(last)) {
    throw MessageError(field + " = " + std::to_string(value) + " does not exist");
  }
  return static_cast<Value>(value);
}

AgentClass agentClass(std::uint8_t value, const std::string& id) {
  return enumOf(value, kLastAgentClass, "agent " + id + ": agent_class");
}

/// Returns nullopt for a size without a height.
std::optional<double> heightOf(const geometry_msgs::Vector3& size) {
  return std::isfinite(size.z) && size.z > 0.0 ? std::optional(size.z) : std::nullopt;
}

Lane fromMessage(const collision_forge::Lane& message, const Vector2& origin) {
  Lane lane;
  lane.id = message.id;
  lane.is_connector = message.is_connector;
  lane.is_intersection = message.is_intersection;
  for (const auto& pose : message.centerline) lane.centerline.push_back(forge::fromMessage(pose));
  lane.polygon = fromMessage(message.polygon, origin);
  lane.incoming = message.incoming;
  lane.outgoing = message.outgoing;
  if (message.speed_limit > 0.0) lane.speed_limit = message.speed_limit;
  return lane;
}

collision_forge::Lane toMessage(const Lane& lane, const Vector2& origin) {
  collision_forge::Lane message;
  message.id = lane.id;
  message.is_connector = lane.is_connector;
  message.is_intersection = lane.is_intersection;
  for (const Pose2& pose : lane.centerline) message.centerline.push_back(toPose2dMessage(pose));
  message.polygon = toPolygonMessage(lane.polygon, origin);
  message.incoming = lane.incoming;
  message.outgoing = lane.outgoing;
  message.speed_limit = lane.speed_limit.value_or(0.0);
  return message;
}

collision_forge::Tensor toMessage(const DenseTensor& tensor) {
  collision_forge::Tensor message;
  message.shape = tensor.shape;
  message.data = tensor.data;
  return message;
}

/// Converts the word of a field of a report. Throws MessageError for an unknown word.
template <typename FromString>
auto wordIn(const std::string& word, const char* field, FromString from_string) {
  const auto meaning = from_string(word);
  if (!meaning) throw MessageError(std::string(field) + " = \"" + word + "\" is unknown");
  return *meaning;
}

/// "none of A, B, ...", of the words that name these values.
template <typename Values>
std::string noneOf(const Values& values) {
  std::string words;
  for (const auto value : values)
    words += (words.empty() ? "" : ", ") + std::string(toString(value));
  return "none of " + words;
}

/// Returns the allowed words of a field of the request, worded to follow "is".
std::string allowedWords(const std::string& field) {
  if (field == "choice") return "none of any, existing and new";
  if (field == "believable") return "neither true nor false";
  if (field == "limits") return "neither drivable nor strict";
  if (field == "attacker_class") return noneOf(kAttackerClasses);
  if (field == "manoeuvre") return noneOf(kManoeuvres);
  if (field == "ego_side") return "none of front, rear, left and right";
  if (field == "hidden_by") return "neither parked_vehicle nor leader";
  return field == "turning" ? "neither attacker nor ego" : "neither left nor right";
}

/// The fields of a range in the message and in the request.
struct RangeFields {
  double collision_forge::CollisionRequest::*least;
  double collision_forge::CollisionRequest::*most;
  std::optional<Range> CollisionRequest::*asked;
};

constexpr RangeFields kRangeFields[] = {
    {&collision_forge::CollisionRequest::min_attacker_speed,
     &collision_forge::CollisionRequest::max_attacker_speed, &CollisionRequest::attacker_speed},
    {&collision_forge::CollisionRequest::min_deceleration,
     &collision_forge::CollisionRequest::max_deceleration, &CollisionRequest::deceleration},
    {&collision_forge::CollisionRequest::min_gap, &collision_forge::CollisionRequest::max_gap,
     &CollisionRequest::gap},
    {&collision_forge::CollisionRequest::min_headway,
     &collision_forge::CollisionRequest::max_headway, &CollisionRequest::headway},
    {&collision_forge::CollisionRequest::min_lateral_speed,
     &collision_forge::CollisionRequest::max_lateral_speed, &CollisionRequest::lateral_speed},
    {&collision_forge::CollisionRequest::min_impact_location,
     &collision_forge::CollisionRequest::max_impact_location, &CollisionRequest::impact_location},
    {&collision_forge::CollisionRequest::min_departure_time,
     &collision_forge::CollisionRequest::max_departure_time, &CollisionRequest::departure_time},
    {&collision_forge::CollisionRequest::min_visible_for,
     &collision_forge::CollisionRequest::max_visible_for, &CollisionRequest::visible_for},
};

/// Reads the constraints besides type, time and attacker; returns the problem, or "".
std::string readControls(const collision_forge::CollisionRequest& message,
                         CollisionRequest& request) {
  const std::pair<const char*, const std::string&> words[] = {
      {"choice", message.choice},       {"believable", message.believable},
      {"limits", message.limits},       {"attacker_class", message.attacker_class},
      {"manoeuvre", message.manoeuvre}, {"ego_side", message.ego_side},
      {"turning", message.turning},     {"from_side", message.from_side},
      {"hidden_by", message.hidden_by}};
  for (const auto& [field, word] : words) {
    if (!word.empty() && !setRequestWord(field, lowered(word), request)) {
      return field + (" = \"" + word + "\" is ") + allowedWords(field);
    }
  }
  request.queue = message.queue != 0;
  if (message.min_impact_speed != 0.0 || message.max_impact_speed != 0.0) {
    request.impact_speed = Range{message.min_impact_speed, message.max_impact_speed};
  }
  if (message.min_overlap != 0.0 || message.max_overlap != 0.0) {
    request.overlap = Range{message.min_overlap, message.max_overlap};
  }
  for (const RangeFields& fields : kRangeFields) {
    const Range range{message.*fields.least, message.*fields.most};
    if (range.min != 0.0 || range.max != 0.0) request.*fields.asked = range;
  }
  constexpr std::uint32_t kMany = std::numeric_limits<int>::max();
  if (message.alternatives != 0) {
    request.alternatives = static_cast<int>(std::min(message.alternatives, kMany));
  }
  return "";
}

/// Throws as fromMessage() of the trajectory.
std::vector<AgentState> pastIn(const collision_forge::AttackerTrajectory& message) {
  const std::string attacker = "attacker " + message.attacker_id + ": ";
  if (message.added == message.past.empty()) {
    throw MessageError(attacker + (message.added ? "added is true, but past is empty"
                                                 : "past is given, but added is false"));
  }
  std::vector<AgentState> past;
  for (const auto& state : message.past) {
    const std::string name = attacker + "past[" + std::to_string(past.size()) + "]";
    past.push_back(forge::fromMessage(state));
    if (!past.back().pose.isFinite() || !past.back().velocity.allFinite()) {
      throw MessageError(name + " is not finite");
    }
    if (past.size() > 1 && past.back().time <= past[past.size() - 2].time) {
      throw MessageError(name + ".stamp is not later than the previous one");
    }
  }
  return past;
}

}  // namespace

void requireMapFrame(const std_msgs::Header& header, const char* topic) {
  if (header.frame_id.empty() || header.frame_id == names::kMapFrame) return;
  throw MessageError(std::string(topic) + ": header.frame_id = \"" + header.frame_id +
                     "\", not \"" + names::kMapFrame + "\"");
}

ros::Time stampOf(double time) {
  constexpr std::uint64_t kMicrosecond = 1000;  // ns
  const ros::Time nearest(time);
  const ros::Time rounded =
      ros::Time().fromNSec((nearest.toNSec() + kMicrosecond / 2) / kMicrosecond * kMicrosecond);
  return rounded.toSec() == time ? rounded : nearest;
}

Pose2 fromMessage(const geometry_msgs::Pose& message) {
  return {message.position.x, message.position.y, yawOf(message.orientation)};
}

Pose2 fromMessage(const geometry_msgs::Pose2D& message) {
  return {message.x, message.y, message.theta};
}

Pose2 fromMessage(const geometry_msgs::Transform& message) {
  return {message.translation.x, message.translation.y, yawOf(message.rotation)};
}

geometry_msgs::Pose toPoseMessage(const Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation.z = std::sin(0.5 * pose.yaw);
  message.orientation.w = std::cos(0.5 * pose.yaw);
  return message;
}

void setPlanar(const Pose2& planar, geometry_msgs::Pose& pose) {
  const double turn = angleBetween(fromMessage(pose).yaw, planar.yaw);
  auto& message = pose.orientation;
  const Eigen::Quaterniond turned = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
                                    Eigen::Quaterniond(message.w, message.x, message.y, message.z);
  message.w = turned.w();
  message.x = turned.x();
  message.y = turned.y();
  message.z = turned.z();
  pose.position.x = planar.x;
  pose.position.y = planar.y;
}

geometry_msgs::Pose2D toPose2dMessage(const Pose2& pose) {
  geometry_msgs::Pose2D message;
  message.x = pose.x;
  message.y = pose.y;
  message.theta = pose.yaw;
  return message;
}

geometry_msgs::Vector3 toMessage(const BoxSize& size) {
  geometry_msgs::Vector3 message;
  message.x = size.length;
  message.y = size.width;
  return message;
}

std::optional<BoxSize> egoSizeOf(const collision_forge::EgoVehicle& message) {
  const auto isSize = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!isSize(message.length) || !isSize(message.width)) return std::nullopt;
  return BoxSize{message.length, message.width};
}

TrajectoryPoint fromMessage(const collision_forge::TrajectoryPoint& message) {
  return {message.stamp.toSec(), fromMessage(message.pose), message.speed, message.acceleration,
          message.curvature};
}

collision_forge::TrajectoryPoint toMessage(const TrajectoryPoint& point) {
  collision_forge::TrajectoryPoint message;
  message.stamp = stampOf(point.time);
  message.pose = toPoseMessage(point.pose);
  message.speed = point.speed;
  message.acceleration = point.acceleration;
  message.curvature = point.curvature;
  return message;
}

Polygon fromMessage(const collision_forge::PolygonWithHoles& message, const Vector2& origin) {
  Polygon polygon{fromMessage(message.exterior, origin), {}};
  for (const auto& hole : message.holes) polygon.holes.push_back(fromMessage(hole, origin));
  return polygon;
}

collision_forge::PolygonWithHoles toMessage(const Polygon& polygon, const Vector2& origin) {
  collision_forge::PolygonWithHoles message;
  message.exterior = toPolygonMessage(polygon.exterior, origin);
  for (const auto& hole : polygon.holes) message.holes.push_back(toPolygonMessage(hole, origin));
  return message;
}

MapFeature fromMessage(const collision_forge::MapFeature& message, const Vector2& origin) {
  return {enumOf(message.kind, FeatureKind::kBikeLane, "map feature: kind"),
          fromMessage(message.points, origin)};
}

collision_forge::MapFeature toMessage(const MapFeature& feature, const Vector2& origin) {
  collision_forge::MapFeature message;
  message.kind = static_cast<std::uint8_t>(feature.kind);
  message.points = toPolygonMessage(feature.points, origin);
  return message;
}

LaneMap fromMessage(const collision_forge::LaneMap& message) {
  LaneMap map;
  map.location = message.location;
  map.driving_side = message.driving_side == collision_forge::LaneMap::DRIVE_LEFT
                         ? DrivingSide::kLeft
                         : DrivingSide::kRight;
  const Vector2 origin(message.origin.x, message.origin.y);
  for (const auto& lane : message.lanes) map.lanes.push_back(fromMessage(lane, origin));
  for (const auto& area : message.drivable_area) {
    map.drivable_area.push_back(fromMessage(area, origin));
  }
  for (const auto& walkway : message.walkways) map.walkways.push_back(fromMessage(walkway, origin));
  for (const auto& feature : message.features) {
    map.features.push_back(fromMessage(feature, origin));
  }
  return map;
}

collision_forge::LaneMap toMessage(const LaneMap& map, const ros::Time& stamp) {
  collision_forge::LaneMap message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stamp;
  message.location = map.location;
  message.driving_side = map.driving_side == DrivingSide::kLeft
                             ? collision_forge::LaneMap::DRIVE_LEFT
                             : collision_forge::LaneMap::DRIVE_RIGHT;
  const Vector2 origin = originOf(map);
  message.origin.x = origin.x();
  message.origin.y = origin.y();
  for (const Lane& lane : map.lanes) message.lanes.push_back(toMessage(lane, origin));
  for (const Polygon& area : map.drivable_area) {
    message.drivable_area.push_back(toMessage(area, origin));
  }
  for (const Polygon& walkway : map.walkways)
    message.walkways.push_back(toMessage(walkway, origin));
  for (const MapFeature& feature : map.features) {
    message.features.push_back(toMessage(feature, origin));
  }
  return message;
}

std::vector<TrafficLight> fromMessage(const collision_forge::TrafficLightArray& message) {
  std::vector<TrafficLight> lights;
  for (const auto& light : message.lights) {
    lights.push_back({light.lane,
                      {light.stop_point.x, light.stop_point.y},
                      {{message.header.stamp.toSec(), enumOf(light.color, LightColor::kGreen,
                                                             "light " + light.lane + ": color")}}});
  }
  return lights;
}

collision_forge::TrafficLightArray toMessage(const std::vector<TrafficLight>& lights,
                                             const ros::Time& stamp) {
  collision_forge::TrafficLightArray message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stamp;
  for (const TrafficLight& light : lights) {
    collision_forge::TrafficLight& written = message.lights.emplace_back();
    written.lane = light.lane;
    written.stop_point.x = light.stop_point.x();
    written.stop_point.y = light.stop_point.y();
    written.color = static_cast<std::uint8_t>(colorAt(light, stamp.toSec()));
  }
  return message;
}

std::vector<Track> fromMessage(const collision_forge::AgentArray& message) {
  std::vector<Track> agents;
  const double time = message.header.stamp.toSec();
  for (const auto& agent : message.agents) {
    const Vector2 velocity(agent.velocity.x, agent.velocity.y);
    agents.push_back({agent.id,
                      agentClass(agent.agent_class, agent.id),
                      fromMessage(agent.size),
                      {{time, fromMessage(agent.pose), velocity}},
                      heightOf(agent.size)});
  }
  return agents;
}

AgentState fromMessage(const collision_forge::TrackState& message) {
  return {message.stamp.toSec(), fromMessage(message.pose),
          Vector2(message.velocity_x, message.velocity_y)};
}

collision_forge::TrackState toMessage(const AgentState& state) {
  collision_forge::TrackState message;
  message.stamp = stampOf(state.time);
  message.pose = toPose2dMessage(state.pose);
  message.velocity_x = state.velocity.x();
  message.velocity_y = state.velocity.y();
  return message;
}

Track fromMessage(const collision_forge::AgentTrack& message) {
  Track track{message.id,
              agentClass(message.agent_class, message.id),
              fromMessage(message.size),
              {},
              heightOf(message.size)};
  for (const auto& state : message.states) track.states.push_back(fromMessage(state));
  return track;
}

collision_forge::AgentTrack toMessage(const Track& track) {
  collision_forge::AgentTrack message;
  message.id = track.id;
  message.agent_class = static_cast<std::uint8_t>(track.agent_class);
  message.size = toMessage(track.size);
  message.size.z = track.height.value_or(0.0);
  for (const AgentState& state : track.states) message.states.push_back(toMessage(state));
  return message;
}

Future fromMessage(const collision_forge::Future& message) {
  Future future;
  future.ego = fromMessage(message.ego);
  for (const auto& agent : message.agents) future.agents.push_back(fromMessage(agent));
  for (const auto& ego : message.ego_samples) future.ego_samples.push_back(fromMessage(ego));
  return future;
}

collision_forge::Future toMessage(const Future& future) {
  collision_forge::Future message;
  message.ego = toMessage(future.ego);
  for (const Track& agent : future.agents) message.agents.push_back(toMessage(agent));
  for (const Track& ego : future.ego_samples) message.ego_samples.push_back(toMessage(ego));
  return message;
}

Snapshot fromMessage(const collision_forge::SceneSnapshot& message) {
  Snapshot snapshot;
  snapshot.now = message.header.stamp.toSec();
  snapshot.ego = fromMessage(message.ego);
  for (const auto& agent : message.agents) snapshot.agents.push_back(fromMessage(agent));
  return snapshot;
}

collision_forge::SceneSnapshot toMessage(const Snapshot& snapshot) {
  collision_forge::SceneSnapshot message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stampOf(snapshot.now);
  message.ego = toMessage(snapshot.ego);
  for (const Track& agent : snapshot.agents) message.agents.push_back(toMessage(agent));
  return message;
}

collision_forge::EncodedScene toMessage(const Snapshot& snapshot, const SceneEncoding& encoding) {
  collision_forge::EncodedScene message;
  message.snapshot = toMessage(snapshot);
  message.header = message.snapshot.header;
  message.agent_features = toMessage(encoding.agent_features);
  message.agent_mask = toMessage(encoding.agent_mask);
  message.lane_features = toMessage(encoding.lane_features);
  message.lane_mask = toMessage(encoding.lane_mask);
  message.lane_ids = encoding.lane_ids;
  return message;
}

std::variant<CollisionRequest, Status> fromMessage(const collision_forge::CollisionRequest& message,
                                                   const CrashDefinition& crash) {
  CollisionRequest request;
  request.crash = crash;
  const auto type = collisionTypeFromString(message.collision_type);
  if (!type) {
    return Status{StatusCode::kUnknownType, "collision_type = \"" + message.collision_type +
                                                "\" is none of " + collisionTypeWords()};
  }
  request.type = *type;
  request.tta = message.tta;
  return withFieldsOf(message, request);
}

std::variant<CollisionRequest, Status> withFieldsOf(
    const collision_forge::CollisionRequest& message, CollisionRequest request) {
  const auto mode = modeFromString(message.mode.empty() ? "history" : message.mode);
  if (!mode) {
    return Status{StatusCode::kInvalidInput,
                  "mode = \"" + message.mode + "\" is neither history nor replay nor adaptive"};
  }
  if (message.tta != 0.0) request.tta = message.tta;
  if (!message.attacker_id.empty()) request.attacker = message.attacker_id;
  request.mode = *mode;
  if (request.mode == Mode::kAdaptive) request.crash.min_confidence = 0.0;
  if (message.seed != 0) request.seed = message.seed;
  const std::string problem = readControls(message, request);
  if (!problem.empty()) return Status{StatusCode::kInvalidInput, problem};
  return request;
}

collision_forge::CollisionRequest toMessage(const CollisionRequest& request) {
  collision_forge::CollisionRequest message;
  message.collision_type = toString(request.type);
  message.tta = request.tta;
  message.attacker_id = request.attacker.value_or("");
  message.choice = toString(request.choice);
  message.mode = toString(request.mode);
  message.seed = request.seed;
  message.believable = request.crash.believable ? "true" : "false";
  message.limits = toString(request.crash.limits);
  if (request.attacker_class) message.attacker_class = toString(*request.attacker_class);
  if (request.manoeuvre) message.manoeuvre = toString(*request.manoeuvre);
  if (request.ego_side) message.ego_side = toString(*request.ego_side);
  message.min_impact_speed = request.impact_speed.value_or(Range{}).min;
  message.max_impact_speed = request.impact_speed.value_or(Range{}).max;
  message.min_overlap = request.overlap.value_or(Range{}).min;
  message.max_overlap = request.overlap.value_or(Range{}).max;
  if (request.turning != Turning::kAttacker) message.turning = toString(request.turning);
  if (request.from_side) message.from_side = toString(*request.from_side);
  if (request.hidden_by) message.hidden_by = toString(*request.hidden_by);
  message.queue = static_cast<std::uint8_t>(request.queue);
  for (const RangeFields& fields : kRangeFields) {
    const Range range = (request.*fields.asked).value_or(Range{});
    message.*fields.least = range.min;
    message.*fields.most = range.max;
  }
  message.alternatives = static_cast<std::uint32_t>(request.alternatives);
  return message;
}

collision_forge::CollisionRequest requestIn(
    const collision_forge::GenerateCollision::Request& message) {
  collision_forge::CollisionRequest request;
  request.collision_type = message.collision_type;
  request.tta = message.tta;
  request.attacker_id = message.attacker_id;
  request.choice = message.choice;
  request.mode = message.mode;
  const bool is_history = message.mode.empty() || modeFromString(message.mode) == Mode::kHistory;
  if (message.adaptive && is_history) request.mode = toString(Mode::kAdaptive);
  request.seed = message.seed;
  request.believable = message.believable;
  request.limits = message.limits;
  request.attacker_class = message.attacker_class;
  request.manoeuvre = message.manoeuvre;
  request.ego_side = message.ego_side;
  request.min_impact_speed = message.min_impact_speed;
  request.max_impact_speed = message.max_impact_speed;
  request.min_overlap = message.min_overlap;
  request.max_overlap = message.max_overlap;
  request.turning = message.turning;
  request.from_side = message.from_side;
  request.min_attacker_speed = message.min_attacker_speed;
  request.max_attacker_speed = message.max_attacker_speed;
  request.min_deceleration = message.min_deceleration;
  request.max_deceleration = message.max_deceleration;
  request.min_gap = message.min_gap;
  request.max_gap = message.max_gap;
  request.min_headway = message.min_headway;
  request.max_headway = message.max_headway;
  request.min_lateral_speed = message.min_lateral_speed;
  request.max_lateral_speed = message.max_lateral_speed;
  request.min_impact_location = message.min_impact_location;
  request.max_impact_location = message.max_impact_location;
  request.min_departure_time = message.min_departure_time;
  request.max_departure_time = message.max_departure_time;
  request.hidden_by = message.hidden_by;
  request.queue = message.queue;
  request.min_visible_for = message.min_visible_for;
  request.max_visible_for = message.max_visible_for;
  request.alternatives = message.alternatives;
  return request;
}

CollisionPattern fromMessage(const collision_forge::CollisionPattern& message) {
  const auto type = collisionTypeFromString(message.collision_type);
  if (!type) throw MessageError("collision_type = \"" + message.collision_type + "\" is unknown");
  CollisionPattern pattern;
  pattern.type = *type;
  pattern.attacker_id = message.attacker_id;
  pattern.time = message.header.stamp.toSec() + message.tta;
  pattern.ego = {fromMessage(message.ego), fromMessage(message.ego_size)};
  pattern.attacker_offset = fromMessage(message.attacker_offset);
  pattern.attacker_speed = message.attacker_speed;
  pattern.tolerance = message.tolerance;
  return pattern;
}

collision_forge::CollisionPattern toMessage(const CollisionPattern& pattern, double now) {
  collision_forge::CollisionPattern message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stampOf(now);
  message.collision_type = toString(pattern.type);
  message.attacker_id = pattern.attacker_id;
  message.tta = pattern.time - now;
  message.ego = toPose2dMessage(pattern.ego.center);
  message.ego_size = toMessage(pattern.ego.size);
  message.attacker_offset = toPose2dMessage(pattern.attacker_offset);
  message.attacker_speed = pattern.attacker_speed;
  message.tolerance = pattern.tolerance;
  return message;
}

ReferencePath fromMessage(const collision_forge::AttackerPath& message) {
  std::vector<Vector2> controls;
  for (const auto& point : message.points) controls.emplace_back(point.x, point.y);
  try {
    return {message.spacing, std::move(controls)};
  } catch (const std::invalid_argument& error) {
    throw MessageError("ways of \"" + message.attacker_id + "\": " + error.what());
  }
}

collision_forge::AttackerPath toMessage(const ReferencePath& way, const std::string& attacker_id) {
  collision_forge::AttackerPath message;
  message.attacker_id = attacker_id;
  message.spacing = way.spacing();
  for (const Vector2& control : way.controls()) {
    geometry_msgs::Point& point = message.points.emplace_back();
    point.x = control.x();
    point.y = control.y();
  }
  return message;
}

AttackerTrajectory fromMessage(const collision_forge::AttackerTrajectory& message) {
  AttackerTrajectory trajectory{message.attacker_id,
                                agentClass(message.agent_class, message.attacker_id),
                                fromMessage(message.size),
                                {},
                                pastIn(message)};
  if (!(trajectory.size.length > 0.0 && trajectory.size.width > 0.0 &&
        std::isfinite(trajectory.size.length) && std::isfinite(trajectory.size.width))) {
    throw MessageError("attacker " + message.attacker_id + ": size is not positive");
  }
  std::vector<TrajectoryPoint>& points = trajectory.points;
  const auto fail = [&](const char* problem) {
    throw MessageError("attacker " + message.attacker_id + ": points[" +
                       std::to_string(points.size() - 1) + problem);
  };
  for (const auto& point : message.points) {
    points.push_back(fromMessage(point));
    const TrajectoryPoint& newest = points.back();
    if (!newest.pose.isFinite() || !std::isfinite(newest.speed) ||
        !std::isfinite(newest.acceleration) || !std::isfinite(newest.curvature)) {
      fail("] is not finite");
    }
    if (points.size() > 1 && newest.time <= points[points.size() - 2].time) {
      fail("].stamp is not later than the previous one");
    }
  }
  return trajectory;
}

collision_forge::AttackerTrajectory toMessage(const AttackerTrajectory& trajectory) {
  collision_forge::AttackerTrajectory message;
  message.header.frame_id = names::kMapFrame;
  if (!trajectory.points.empty()) {
    message.header.stamp = stampOf(trajectory.points.front().time);
  }
  message.attacker_id = trajectory.attacker_id;
  message.agent_class = static_cast<std::uint8_t>(trajectory.agent_class);
  message.size = toMessage(trajectory.size);
  for (const TrajectoryPoint& point : trajectory.points) message.points.push_back(toMessage(point));
  message.added = trajectory.isAdded();
  for (const AgentState& state : trajectory.past) message.past.push_back(toMessage(state));
  return message;
}

Attack fromMessage(const collision_forge::Attack& message) {
  Attack answer;
  answer.pattern = fromMessage(message.pattern);
  answer.miss = {message.miss_distance, message.miss_heading};
  answer.trajectory = fromMessage(message.trajectory);
  for (const collision_forge::SupportVehicle& support : message.supports) {
    answer.supports.push_back(
        {wordIn(support.role, "role", supportRoleFromString), fromMessage(support.motion)});
  }
  answer.effort = message.effort;
  answer.report = fromMessage(message.report);
  return answer;
}

collision_forge::Attack toMessage(const Attack& answer, const std::string& method, double now) {
  collision_forge::Attack message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stampOf(now);
  message.method = method;
  message.pattern = toMessage(answer.pattern, now);
  message.miss_distance = answer.miss.distance;
  message.miss_heading = answer.miss.heading;
  message.trajectory = toMessage(answer.trajectory);
  for (const SupportVehicle& support : answer.supports) {
    collision_forge::SupportVehicle& added = message.supports.emplace_back();
    added.role = toString(support.role);
    added.motion = toMessage(support.motion);
  }
  message.effort = answer.effort;
  message.report = toMessage(answer.report, answer.trajectory.attacker_id, now);
  return message;
}

void setPlans(const std::vector<AttackerPlan>& plans, collision_forge::Attack& message) {
  const AttackerPlan& last = plans.back();
  message.adaptive = true;
  message.phase = toString(last.phase);
  message.decision = last.reason;
  message.decided = stampOf(last.from);
  message.plans = static_cast<std::uint32_t>(plans.size());
  message.report.decision = last.reason;
}

static CrashEffect fromMessage(const collision_forge::CrashEffect& message) {
  return {message.delta_v, message.force_from, message.yaw_rate_change, message.mais2,
          message.mais3,   message.curve,      message.least_class,     message.most_class};
}

collision_forge::CrashEffect toMessage(const CrashEffect& effect) {
  collision_forge::CrashEffect message;
  message.delta_v = effect.delta_v;
  message.force_from = effect.force_from;
  message.yaw_rate_change = effect.yaw_rate_change;
  message.mais2 = effect.mais2;
  message.mais3 = effect.mais3;
  message.curve = effect.curve;
  message.least_class = static_cast<std::uint8_t>(effect.least_class);
  message.most_class = static_cast<std::uint8_t>(effect.most_class);
  return message;
}

static CarefulDrive fromMessage(const collision_forge::CarefulDrive& message) {
  CarefulDrive drive{message.driver, static_cast<bool>(message.avoids), {}};
  if (message.brakes) drive.brakes_at = message.brakes_at.toSec();
  return drive;
}

collision_forge::CarefulDrive toMessage(const CarefulDrive& drive) {
  collision_forge::CarefulDrive message;
  message.driver = drive.driver;
  message.avoids = drive.avoids;
  message.brakes = drive.brakes_at.has_value();
  if (drive.brakes_at) message.brakes_at = stampOf(*drive.brakes_at);
  return message;
}

static ContactConditions fromMessage(const collision_forge::ContactConditions& message) {
  ContactConditions measured;
  if (!message.from_side.empty()) {
    measured.from_side = wordIn(message.from_side, "from_side", sideFromString);
  }
  measured.attacker_speed = message.attacker_speed;
  measured.deceleration = message.deceleration;
  measured.gap = message.gap;
  measured.headway = message.headway;
  measured.lateral_speed = message.lateral_speed;
  measured.impact_location = message.impact_location;
  measured.departure_time = message.departure_time;
  measured.visible_for = message.visible_for;
  if (!message.hidden_by.empty()) {
    measured.hidden_by = wordIn(message.hidden_by, "hidden_by", hiderFromString);
  }
  measured.hidden_by_id = message.hidden_by_id;
  return measured;
}

static collision_forge::ContactConditions toMessage(const ContactConditions& measured) {
  collision_forge::ContactConditions message;
  message.from_side = toString(measured.from_side);
  message.attacker_speed = measured.attacker_speed;
  message.deceleration = measured.deceleration;
  message.gap = measured.gap;
  message.headway = measured.headway;
  message.lateral_speed = measured.lateral_speed;
  message.impact_location = measured.impact_location;
  message.departure_time = measured.departure_time;
  message.visible_for = measured.visible_for;
  if (measured.hidden_by) message.hidden_by = toString(*measured.hidden_by);
  message.hidden_by_id = measured.hidden_by_id;
  return message;
}

CollisionReport fromMessage(const collision_forge::CollisionReport& message) {
  CollisionReport report;
  report.contact = message.contact;
  if (message.contact) {
    report.contact_time = message.contact_time.toSec();
    report.relative_heading = message.relative_heading;
    report.ego_at_contact = fromMessage(message.ego_at_contact);
    report.attacker_at_contact = fromMessage(message.attacker_at_contact);
    report.ego_side = wordIn(message.ego_side, "ego_side", sideFromString);
    report.attacker_side = wordIn(message.attacker_side, "attacker_side", sideFromString);
    report.impact_speed = message.impact_speed;
    report.overlap = message.overlap;
    report.conditions = fromMessage(message.conditions);
    report.severity = {fromMessage(message.ego_effect), fromMessage(message.attacker_effect),
                       message.energy_lost};
    report.manoeuvre = wordIn(message.manoeuvre, "manoeuvre", manoeuvreFromString);
    report.manoeuvre_begin = message.manoeuvre_begin.toSec();
  }
  for (const collision_forge::CarefulDrive& drive : message.careful_drivers) {
    report.careful_drivers.push_back(fromMessage(drive));
  }
  report.type_kept = message.type_kept;
  report.on_time = message.on_time;
  report.limits_kept = message.limits_kept;
  report.broken_limit = message.broken_limit;
  report.first_other_id = message.first_other_id;
  report.first_other_time = message.first_other_time.toSec();
  report.off_road_share = message.off_road_share;
  report.road = {message.on_lane, message.wrong_way, message.off_road, message.on_walkway,
                 message.on_island};
  report.unbelievable = message.unbelievable;
  report.confidence = message.confidence;
  return report;
}

collision_forge::CollisionReport toMessage(const CollisionReport& report,
                                           const std::string& attacker_id, double now) {
  collision_forge::CollisionReport message;
  message.header.frame_id = names::kMapFrame;
  message.header.stamp = stampOf(now);
  message.attacker_id = attacker_id;
  message.verified = report.verified();
  message.contact = report.contact;
  if (report.contact) {
    message.contact_time = stampOf(report.contact_time);
    message.relative_heading = report.relative_heading;
    message.ego_at_contact = toPose2dMessage(report.ego_at_contact);
    message.attacker_at_contact = toPose2dMessage(report.attacker_at_contact);
    message.ego_side = toString(report.ego_side);
    message.attacker_side = toString(report.attacker_side);
    message.impact_speed = report.impact_speed;
    message.overlap = report.overlap;
    message.conditions = toMessage(report.conditions);
    message.energy_lost = report.severity.energy_lost;
    message.ego_effect = toMessage(report.severity.ego);
    message.attacker_effect = toMessage(report.severity.other);
    message.manoeuvre = toString(report.manoeuvre);
    message.manoeuvre_begin = stampOf(report.manoeuvre_begin);
  }
  for (const CarefulDrive& drive : report.careful_drivers) {
    message.careful_drivers.push_back(toMessage(drive));
  }
  message.type_kept = report.type_kept;
  message.on_time = report.on_time;
  message.limits_kept = report.limits_kept;
  message.broken_limit = report.broken_limit;
  message.first_other_id = report.first_other_id;
  if (!report.first_other_id.empty()) message.first_other_time = stampOf(report.first_other_time);
  message.off_road_share = report.off_road_share;
  message.on_lane = report.road.on_lane;
  message.wrong_way = report.road.wrong_way;
  message.off_road = report.road.off_road;
  message.on_walkway = report.road.on_walkway;
  message.on_island = report.road.on_island;
  message.believable = report.believable();
  message.unbelievable = report.unbelievable;
  message.confidence = report.confidence;
  return message;
}

}  // namespace forge
