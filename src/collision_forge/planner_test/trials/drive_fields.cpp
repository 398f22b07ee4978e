#include "collision_forge/planner_test/trials/drive_fields.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/io/scenarios/scenario_file.h"

namespace forge {
namespace {

constexpr double kMillionths = 1e6;  // um, urad, um/s: accelerations stay exact to 1e-3 m/s2
constexpr int kMaxEntries = 10000;   // plans or agents in a drive
constexpr double kLargest = 1e9;     // m, rad, m/s, m/s2, s; far above any driven value

struct MotionField {
  const char* name;
  double& (*value)(TrajectoryPoint& point);
};

constexpr MotionField kMotionFields[] = {
    {"x", [](TrajectoryPoint& point) -> double& { return point.pose.x; }},
    {"y", [](TrajectoryPoint& point) -> double& { return point.pose.y; }},
    {"yaw", [](TrajectoryPoint& point) -> double& { return point.pose.yaw; }},
    {"v", [](TrajectoryPoint& point) -> double& { return point.speed; }},
    {"a", [](TrajectoryPoint& point) -> double& { return point.acceleration; }}};

/// Writes the fields of a motion into the open object.
void writeMotion(JsonLineWriter& writer, std::vector<TrajectoryPoint> points, double now) {
  std::vector<double> values;
  for (const TrajectoryPoint& point : points) values.push_back(fromNow(point.time, now));
  writer.numbers("t", values);
  for (const MotionField& field : kMotionFields) {
    values.clear();
    for (TrajectoryPoint& point : points) {
      values.push_back(std::round(field.value(point) * kMillionths) / kMillionths);
    }
    writer.numbers(field.name, values);
  }
}

void writeMotion(JsonLineWriter& writer, const char* key,
                 const std::vector<TrajectoryPoint>& points, double now) {
  writer.beginObject(key);
  writeMotion(writer, points, now);
  writer.endObject();
}

std::vector<TrajectoryPoint> readMotionFields(JsonObject& object, double now) {
  std::vector<TrajectoryPoint> points;
  const auto numbers = [&](const char* key) {
    std::vector<double> values = object.numbers(key);
    const auto is_beyond = [](double value) { return std::abs(value) > kLargest; };
    if (std::any_of(values.begin(), values.end(), is_beyond))
      object.fail(key, "has a value above 1e9");
    return values;
  };
  for (const double time : numbers("t")) points.emplace_back().time = now + time;
  for (const MotionField& field : kMotionFields) {
    const std::vector<double> values = numbers(field.name);
    if (values.size() != points.size())
      object.fail(field.name, "has another number of values than t");
    for (std::size_t i = 0; i < values.size(); ++i) field.value(points[i]) = values[i];
  }
  object.finish();
  return points;
}

std::vector<TrajectoryPoint> readMotion(JsonObject& parent, const char* key, double now) {
  JsonObject object = parent.object(key);
  return readMotionFields(object, now);
}

void writeAgents(JsonLineWriter& writer, const std::vector<Track>& agents, double now) {
  writer.beginArray("others");
  for (const Track& agent : agents) {
    std::vector<TrajectoryPoint> points;
    for (const AgentState& state : agent.states) {
      points.push_back(
          {state.time, state.pose, state.velocity.dot(state.pose.heading()), 0.0, 0.0});
    }
    writer.beginObject();
    writer.text("id", agent.id);
    writeMotion(writer, points, now);
    writer.endObject();
  }
  writer.endArray();
}

void readPlans(JsonObject& drive, std::vector<AttackerPlan>& plans, double now) {
  for (JsonObject& entry : drive.objects("plans", kMaxEntries)) {
    AttackerPlan& plan = plans.emplace_back();
    plan.seen = now + entry.number("seen_t");
    plan.from = now + entry.number("from_t");
    const auto phase = attackerPhaseFromString(entry.text("phase"));
    if (!phase) entry.fail("phase", "is not a known attacker phase");
    plan.phase = *phase;
    plan.reason = entry.text("reason");
    plan.points = readMotion(entry, "trajectory", now);
    entry.finish();
  }
}

}  // namespace

void writeDrive(JsonLineWriter& writer, const PlannerRow& row, double now) {
  const RolloutOutcome& outcome = row.outcome;
  if (outcome.driven.empty()) return writer.null("drive");
  writer.beginObject("drive");
  writeMotion(writer, "ego", outcome.driven, now);
  writeMotion(writer, "attacker", outcome.attacker.points, now);
  writePlans(writer, outcome.attacker_plans, now,
             [](JsonLineWriter& plan, const std::vector<TrajectoryPoint>& points, double origin) {
               writeMotion(plan, "trajectory", points, origin);
             });
  writeAgents(writer, outcome.contact ? outcome.others : std::vector<Track>(), now);
  if (row.evasion_drive) {
    writer.beginObject("evasion");
    writeMotion(writer, "ego", row.evasion_drive->ego.motion, now);
    writeMotion(writer, "attacker", row.evasion_drive->attacker.points, now);
    writer.endObject();
  } else {
    writer.null("evasion");
  }
  writer.endObject();
}

void readDrive(JsonObject& object, PlannerRow& row, double now) {
  auto drive = object.objectOrNull("drive");
  if (!drive) return;
  RolloutOutcome& outcome = row.outcome;
  outcome.driven = readMotion(*drive, "ego", now);
  if (outcome.driven.empty()) drive->fail("ego", "has no points");
  outcome.attacker.points = readMotion(*drive, "attacker", now);
  readPlans(*drive, outcome.attacker_plans, now);
  for (JsonObject& entry : drive->objects("others", kMaxEntries)) {
    Track& agent = outcome.others.emplace_back();
    agent.id = entry.text("id");
    agent.states = toStates(readMotionFields(entry, now));
  }
  auto evasion = drive->objectOrNull("evasion");
  if (evasion.has_value() != (row.evasion && row.evasion->is_avoidable)) {
    drive->fail("evasion", "contradicts the field evasion of the row");
  }
  if (evasion) {
    Evasion& read = row.evasion_drive.emplace();
    read.ego = {row.evasion->last, now + row.evasion->last_after, readMotion(*evasion, "ego", now),
                row.evasion->off_road_share};
    read.attacker.points = readMotion(*evasion, "attacker", now);
    evasion->finish();
  }
  drive->finish();
}

}  // namespace forge
