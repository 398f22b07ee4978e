#include "collision_forge/planner_test/planners/planner_protocol.h"

#include <stdexcept>

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/logs/nuscenes_map.h"

namespace forge {
namespace {

constexpr double kMapRadius = 200.0;  // m from the route
constexpr double kRouteStep =
    50.0;  // m of the route between two places around which the map is kept
constexpr int kMaxElements = 100000;  // of an array, against damage
constexpr const char* kResponse = "response";
constexpr const char* kRequest = "request";
constexpr const char* kTimedOut = "timed_out";
constexpr const char* kLate = "late";
constexpr const char* kLeft = "left";
constexpr const char* kRight = "right";

// Columns of the arrays.
constexpr std::size_t kPointColumns = 7;       // time, x, y, yaw, speed, acceleration, curvature
constexpr std::size_t kPointColumnsLeast = 5;  // without acceleration and curvature: 0
constexpr std::size_t kStateColumns = 6;       // time, x, y, yaw, velocity x, y

std::vector<double> rowOf(const TrajectoryPoint& point) {
  return {point.time,  point.pose.x,       point.pose.y,   point.pose.yaw,
          point.speed, point.acceleration, point.curvature};
}

TrajectoryPoint pointOf(const std::vector<double>& row) {
  TrajectoryPoint point{row[0], {row[1], row[2], row[3]}, row[4]};
  if (row.size() > kPointColumnsLeast) point.acceleration = row[5];
  if (row.size() == kPointColumns) point.curvature = row[6];
  return point;
}

void writePositions(JsonLineWriter& writer, const char* key, const std::vector<Vector2>& points) {
  writer.beginArray(key);
  for (const Vector2& point : points) writer.numbers(nullptr, {point.x(), point.y()});
  writer.endArray();
}

std::vector<Vector2> readPositions(JsonObject& object, const char* key) {
  std::vector<Vector2> points;
  for (const auto& row : object.rows(key, 2, 2, kMaxElements)) points.emplace_back(row[0], row[1]);
  return points;
}

/// Returns the part of the map near the route.
LaneMap mapNearRoute(const DrivingTask& task) {
  std::vector<Vector2> points;
  for (const Vector2& point : task.route) {
    if (points.empty() || (point - points.back()).norm() >= kRouteStep) points.push_back(point);
  }
  return cropped(task.lanes->map(), points, kMapRadius);
}

void writePolygons(JsonLineWriter& writer, const char* key, const std::vector<Polygon>& polygons) {
  writer.beginArray(key);
  for (const Polygon& polygon : polygons) {
    writer.beginObject();
    writePositions(writer, "exterior", polygon.exterior);
    writer.beginArray("holes");
    for (const auto& hole : polygon.holes) {
      writer.beginObject();
      writePositions(writer, "exterior", hole);
      writer.endObject();
    }
    writer.endArray();
    writer.endObject();
  }
  writer.endArray();
}

void writeLane(JsonLineWriter& writer, const Lane& lane) {
  writer.beginObject();
  writer.text("id", lane.id);
  writer.flag("connector", lane.is_connector);
  writer.flag("intersection", lane.is_intersection);
  writer.beginArray("centerline");
  for (const Pose2& pose : lane.centerline) writer.numbers(nullptr, {pose.x, pose.y, pose.yaw});
  writer.endArray();
  writePositions(writer, "outline", lane.polygon);
  writer.texts("predecessors", lane.incoming);
  writer.texts("successors", lane.outgoing);
  if (lane.speed_limit) {
    writer.number("speed_limit", *lane.speed_limit);
  } else {
    writer.null("speed_limit");
  }
  writer.endObject();
}

void writeMap(JsonLineWriter& writer, const LaneMap& map) {
  writer.text("driving_side", map.driving_side == DrivingSide::kLeft ? kLeft : kRight);
  writer.beginArray("lanes");
  for (const Lane& lane : map.lanes) writeLane(writer, lane);
  writer.endArray();
  writePolygons(writer, "drivable_area", map.drivable_area);
  writePolygons(writer, "walkways", map.walkways);
}

std::vector<Polygon> readPolygons(JsonObject& object, const char* key) {
  std::vector<Polygon> polygons;
  for (JsonObject& entry : object.objects(key, kMaxElements)) {
    polygons.push_back({readPositions(entry, "exterior"), {}});
    for (JsonObject& hole : entry.objects("holes", kMaxElements)) {
      polygons.back().holes.push_back(readPositions(hole, "exterior"));
      hole.finish();
    }
    entry.finish();
  }
  return polygons;
}

Lane readLane(JsonObject object) {
  Lane lane;
  lane.id = object.text("id");
  lane.is_connector = object.flag("connector");
  lane.is_intersection = object.flag("intersection");
  for (const auto& row : object.rows("centerline", 3, 3, kMaxElements)) {
    lane.centerline.push_back({row[0], row[1], row[2]});
  }
  lane.polygon = readPositions(object, "outline");
  lane.incoming = object.texts("predecessors");
  lane.outgoing = object.texts("successors");
  lane.speed_limit = object.numberOrNull("speed_limit");
  object.finish();
  return lane;
}

Track readAgent(JsonObject object) {
  Track agent;
  agent.id = object.text("id");
  const std::string name = object.text("class");
  const auto agent_class = agentClassFromString(name);
  if (!agent_class) object.fail("class", "is an unknown class");
  agent.agent_class = *agent_class;
  agent.size = {object.number("length"), object.number("width")};
  for (const auto& row : object.rows("states", kStateColumns, kStateColumns, kMaxElements)) {
    agent.states.push_back({row[0], {row[1], row[2], row[3]}, {row[4], row[5]}});
  }
  object.finish();
  return agent;
}

void readBegin(JsonObject object, PlanRequest& request) {
  request.interval = object.number("interval");
  request.task.wheelbase = object.number("wheelbase");
  JsonObject ego = object.object("ego");
  request.task.ego.size = {ego.number("length"), ego.number("width")};
  request.task.ego.center_offset = ego.number("center_offset");
  ego.finish();
  request.task.route = readPositions(object, "route");
  const auto map = std::make_shared<LaneMap>();
  map->driving_side =
      object.text("driving_side") == kLeft ? DrivingSide::kLeft : DrivingSide::kRight;
  for (JsonObject& lane : object.objects("lanes", kMaxElements)) {
    map->lanes.push_back(readLane(std::move(lane)));
  }
  map->drivable_area = readPolygons(object, "drivable_area");
  map->walkways = readPolygons(object, "walkways");
  request.task.lanes = std::make_shared<LaneIndex>(map);
  object.finish();
}

void readPlan(JsonObject object, Observation& observation) {
  const auto ego = object.rows("ego", kPointColumns, kPointColumns, 1);
  if (ego.empty()) object.fail("ego", "is empty");
  observation.ego = pointOf(ego.front());
  for (JsonObject& agent : object.objects("agents", kMaxElements)) {
    observation.agents.push_back(readAgent(std::move(agent)));
  }
  observation.red_lanes = object.texts("red_lanes");
  object.finish();
}

[[noreturn]] void throwError(JsonObject& response) {
  const std::string message = response.text("error");
  const std::string failure = response.has("failure") ? response.text("failure") : "";
  if (failure == kTimedOut) throw PlannerTimeout(message);
  if (failure == kLate) throw LatePlan(message);
  throw std::runtime_error(message);
}

}  // namespace

std::string beginLine(const DrivingTask& task, double interval) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.beginObject("begin");
  writer.number("interval", interval);
  writer.number("wheelbase", task.wheelbase);
  writer.beginObject("ego");
  writer.number("length", task.ego.size.length);
  writer.number("width", task.ego.size.width);
  writer.number("center_offset", task.ego.center_offset);
  writer.endObject();
  writePositions(writer, "route", task.route);
  writeMap(writer, mapNearRoute(task));
  writer.endObject();
  writer.endObject();
  return writer.line();
}

std::string planLine(const Observation& observation) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.beginObject("plan");
  writer.beginArray("ego");
  writer.numbers(nullptr, rowOf(observation.ego));
  writer.endArray();
  writer.beginArray("agents");
  for (const Track& agent : observation.agents) {
    writer.beginObject();
    writer.text("id", agent.id);
    writer.text("class", toString(agent.agent_class));
    writer.number("length", agent.size.length);
    writer.number("width", agent.size.width);
    writer.beginArray("states");
    for (const AgentState& state : agent.states) {
      writer.numbers(nullptr, {state.time, state.pose.x, state.pose.y, state.pose.yaw,
                               state.velocity.x(), state.velocity.y()});
    }
    writer.endArray();
    writer.endObject();
  }
  writer.endArray();
  writer.texts("red_lanes", observation.red_lanes);
  writer.endObject();
  writer.endObject();
  return writer.line();
}

std::vector<TrajectoryPoint> readPlanResponse(const std::string& text) {
  const JsonLine line(kResponse, text);
  JsonObject root = line.root();
  if (root.has("error")) throwError(root);
  std::vector<TrajectoryPoint> points;
  if (!root.has("points")) return points;
  for (const auto& row : root.rows("points", kPointColumnsLeast, kPointColumns, kMaxElements)) {
    points.push_back(pointOf(row));
  }
  return points;
}

void checkReadyLine(const std::string& text) {
  const JsonLine line("first line", text);
  JsonObject root = line.root();
  if (root.has("error")) throw std::runtime_error(root.text("error"));
  root.within("ready", kPlannerProtocol, kPlannerProtocol);
}

PlanRequest readPlanRequest(const std::string& text) {
  const JsonLine line(kRequest, text);
  JsonObject root = line.root();
  PlanRequest request;
  request.is_begin = root.has("begin");
  if (request.is_begin) {
    readBegin(root.object("begin"), request);
  } else {
    readPlan(root.object("plan"), request.observation);
  }
  root.finish();
  return request;
}

std::string pointsLine(const std::vector<TrajectoryPoint>& points) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.beginArray("points");
  for (const TrajectoryPoint& point : points) writer.numbers(nullptr, rowOf(point));
  writer.endArray();
  writer.endObject();
  return writer.line();
}

std::string begunLine() { return "{}"; }

std::string errorLine(const std::exception& error) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.text("error", error.what());
  if (dynamic_cast<const PlannerTimeout*>(&error) != nullptr) writer.text("failure", kTimedOut);
  if (dynamic_cast<const LatePlan*>(&error) != nullptr) writer.text("failure", kLate);
  writer.endObject();
  return writer.line();
}

std::string readyLine() { return "{\"ready\":" + std::to_string(kPlannerProtocol) + "}"; }

}  // namespace forge
