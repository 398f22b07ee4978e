#include "collision_forge/io/scenarios/motion_fields.h"

#include <cmath>

#include "collision_forge/io/scenarios/relative_time.h"

namespace forge {
namespace {

constexpr const char* kRecorded = "recorded";
constexpr const char* kAdded = "added";

void writePoseFields(JsonLineWriter& writer, const Pose2& pose) {
  writer.number("x", pose.x);
  writer.number("y", pose.y);
  writer.number("yaw", pose.yaw);
}

/// Writes speeds rounded to 1e-6 m/s, so that reading and writing gives the same bytes.
void writePast(JsonLineWriter& writer, const std::vector<AgentState>& past, double now) {
  if (past.empty()) {
    writer.null("past");
    return;
  }
  constexpr double kMicrometres = 1e6;  // per metre
  writer.beginArray("past");
  for (const AgentState& state : past) {
    const double speed = state.velocity.dot(state.pose.heading());
    writer.beginObject();
    writer.number("t", fromNow(state.time, now));
    writePoseFields(writer, state.pose);
    writer.number("v", std::round(speed * kMicrometres) / kMicrometres);
    writer.endObject();
  }
  writer.endArray();
}

Pose2 readPoseFields(JsonObject& object, const LineContext& line) {
  const double farthest = line.limits.max_coordinate;
  return {object.within("x", -farthest, farthest), object.within("y", -farthest, farthest),
          object.number("yaw")};
}

/// Fails unless the time is after the previous state's.
template <typename State>
void checkTime(const JsonObject& entry, double time, const std::vector<State>& before) {
  if (!before.empty() && time <= before.back().time)
    entry.fail("t", "is not after the previous time");
}

/// Reads "past", which must hold states if `is_added` and be null otherwise.
std::vector<AgentState> readPast(JsonObject& object, bool is_added, const LineContext& line) {
  std::vector<AgentState> past;
  auto entries = object.objectsOrNull("past", line.limits.max_points);
  if (is_added != (entries && !entries->empty())) {
    object.fail("past", is_added ? "must hold the states of an added vehicle"
                                 : "must be null for a recorded vehicle");
  }
  if (!entries) return past;
  for (JsonObject& entry : *entries) {
    AgentState state;
    state.time = readTime(entry, "t", line);
    checkTime(entry, state.time, past);
    state.pose = readPoseFields(entry, line);
    state.velocity = readSpeed(entry, "v", line) * state.pose.heading();
    entry.finish();
    past.push_back(state);
  }
  return past;
}

bool readIsAdded(JsonObject& object) {
  const std::string origin = object.text("origin");
  if (origin != kAdded && origin != kRecorded) {
    object.fail("origin", std::string("is neither ") + kRecorded + " nor " + kAdded);
  }
  return origin == kAdded;
}

}  // namespace

void writePose(JsonLineWriter& writer, const char* key, const Pose2& pose) {
  writer.beginObject(key);
  writePoseFields(writer, pose);
  writer.endObject();
}

void writePoints(JsonLineWriter& writer, const std::vector<TrajectoryPoint>& points, double now) {
  writer.beginArray("trajectory");
  for (const TrajectoryPoint& point : points) {
    writer.beginObject();
    writer.number("t", fromNow(point.time, now));
    writePoseFields(writer, point.pose);
    writer.number("v", point.speed);
    writer.number("a", point.acceleration);
    writer.number("kappa", point.curvature);
    writer.endObject();
  }
  writer.endArray();
}

void writeVehicle(JsonLineWriter& writer, const AttackerTrajectory& trajectory, double now) {
  writer.text("id", trajectory.attacker_id);
  writer.text("class", toString(trajectory.agent_class));
  writer.text("origin", trajectory.isAdded() ? kAdded : kRecorded);
  writer.number("length", trajectory.size.length);
  writer.number("width", trajectory.size.width);
  writePast(writer, trajectory.past, now);
  writePoints(writer, trajectory.points, now);
}

double readTime(JsonObject& object, const char* key, const LineContext& line) {
  return line.now + object.within(key, -line.limits.max_past, line.limits.max_trajectory);
}

double readSpeed(JsonObject& object, const char* key, const LineContext& line) {
  return object.within(key, -line.limits.max_speed, line.limits.max_speed);
}

Pose2 readPose(JsonObject object, const LineContext& line) {
  const Pose2 pose = readPoseFields(object, line);
  object.finish();
  return pose;
}

BoxSize readBox(JsonObject& object, const InputLimits& limits) {
  return {object.within("length", limits.min_box, limits.max_box),
          object.within("width", limits.min_box, limits.max_box)};
}

std::vector<TrajectoryPoint> readPoints(JsonObject& object, const LineContext& line) {
  std::vector<TrajectoryPoint> points;
  for (JsonObject& entry : object.objects("trajectory", line.limits.max_points)) {
    TrajectoryPoint point;
    point.time = readTime(entry, "t", line);
    checkTime(entry, point.time, points);
    point.pose = readPoseFields(entry, line);
    point.speed = readSpeed(entry, "v", line);
    point.acceleration = entry.number("a");
    point.curvature = entry.number("kappa");
    entry.finish();
    points.push_back(point);
  }
  return points;
}

AttackerTrajectory readVehicle(JsonObject& object, const LineContext& line) {
  AttackerTrajectory trajectory;
  trajectory.attacker_id = object.text("id");
  const auto agent_class = agentClassFromString(object.text("class"));
  if (!agent_class) object.fail("class", "is not an agent class");
  trajectory.agent_class = *agent_class;
  trajectory.past = readPast(object, readIsAdded(object), line);
  trajectory.size = readBox(object, line.limits);
  trajectory.points = readPoints(object, line);
  if (trajectory.points.empty()) object.fail("trajectory", "is empty");
  return trajectory;
}

}  // namespace forge
