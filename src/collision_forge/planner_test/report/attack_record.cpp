#include "collision_forge/planner_test/report/attack_record.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/base/scene/clock.h"
#include "collision_forge/base/scene/support_vehicles.h"
#include "collision_forge/io/scenarios/motion_fields.h"
#include "collision_forge/io/scenarios/report_fields.h"
#include "collision_forge/io/scenarios/request_fields.h"
#include "collision_forge/planner_test/report/compact_motion.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"

namespace forge {
namespace {

constexpr double kCrashStep = 0.1;  // s between the states after a contact

/// Returns the limits in the request's set, as far as both sets have them.
void writeLimits(JsonLineWriter& writer, LimitSet set, const AttackerTrajectory& attacker,
                 const VerificationOptions& options) {
  writer.beginObject("limits");
  if (set == LimitSet::kStrict) {
    const VehicleLimits& limits = options.limits;
    writer.text("of", "strict");
    writer.number("max_forward_acceleration", limits.max_forward_acceleration);
    writer.number("max_braking", limits.max_braking);
    writer.number("max_lateral_acceleration", limits.max_total_acceleration);
    writer.number("max_speed", limits.max_speed);
  } else {
    const auto& drivable = options.drivable;
    const DriveLimits limits = driveLimitsOf(attacker.agent_class, attacker.size, drivable);
    writer.text("of", toString(vehicleClassOf(attacker.agent_class, attacker.size, drivable)));
    writer.number("max_forward_acceleration", limits.max_forward_acceleration);
    writer.number("max_braking", limits.max_braking);
    writer.number("max_lateral_acceleration", limits.max_lateral_acceleration);
    const bool reverses = std::any_of(attacker.points.begin(), attacker.points.end(),
                                      [](const auto& point) { return point.speed < 0.0; });
    writer.number("max_speed", reverses ? drivable.max_reverse_speed : limits.max_speed);
  }
  writer.endObject();
}

void writeAttacker(JsonLineWriter& writer, const AttackerTrajectory& attacker, double now) {
  writer.beginObject("attacker");
  writer.text("id", attacker.attacker_id);
  writer.number("length", attacker.size.length);
  writer.number("width", attacker.size.width);
  writeStates(writer, "past", attacker.past, now);
  writeTrajectory(writer, "trajectory", attacker.points, now);
  writer.endObject();
}

/// Supports that stand are shown until `kShownFor` after t0.
void writeSupports(JsonLineWriter& writer, const std::vector<SupportVehicle>& supports,
                   double now) {
  constexpr double kShownFor = 30.0;  // s
  writer.beginArray("supports");
  for (const SupportVehicle& support : supports) {
    const Track track = trackOf(support, nullptr, now + kShownFor);
    writer.beginObject();
    writer.text("id", track.id);
    writer.text("class", toString(track.agent_class));
    writer.text("role", toString(support.role));
    writer.number("length", track.size.length);
    writer.number("width", track.size.width);
    writeStates(writer, "motion", track.states, now);
    writer.endObject();
  }
  writer.endArray();
}

void writeAim(JsonLineWriter& writer, const Attack& attack, double now) {
  const CollisionPattern& aim = attack.pattern;
  writer.beginObject("aim");
  writer.number("t", fromNow(aim.time, now));
  writePose(writer, "ego", aim.ego.center);
  writePose(writer, "attacker", compose(aim.ego.center, aim.attacker_offset));
  writer.number("miss_distance", attack.miss.distance);
  writer.endObject();
}

/// Writes the points in compact form.
void writePlansInShort(JsonLineWriter& writer, const std::vector<AttackerPlan>& plans, double now) {
  writePlans(writer, plans, now, [](JsonLineWriter& plan, const auto& points, double origin) {
    writeTrajectory(plan, "trajectory", points, origin);
  });
}

TrajectoryPoint pointOf(const AgentState& state) {
  return {state.time, state.pose, state.velocity.dot(state.pose.heading()), 0.0, 0.0};
}

std::vector<TrajectoryPoint> pointsBefore(double end, const Track& track) {
  std::vector<TrajectoryPoint> points;
  for (const AgentState& state : track.states) {
    if (state.time < end - kTimeEpsilon) points.push_back(pointOf(state));
  }
  return points;
}

/// Speed and acceleration along the heading.
template <typename StateAtTime>
std::vector<TrajectoryPoint> pointsAfterContact(const ShownCrash& crash, const StateAtTime& at) {
  const double begin = crash.motion.contactTime();
  const double duration = crash.motion.standTime() + crash.seconds_after_stand - begin;
  const int steps = static_cast<int>(std::ceil(duration / kCrashStep));
  std::vector<TrajectoryPoint> points;
  for (int i = 0; i <= steps; ++i) {
    points.push_back(pointOf(at(begin + std::min(i * kCrashStep, duration))));
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    points[i].acceleration =
        (points[i + 1].speed - points[i].speed) / (points[i + 1].time - points[i].time);
  }
  return points;
}

void writeCrash(JsonLineWriter& writer, const ShownCrash& crash, double now) {
  const PostCrashMotion& motion = crash.motion;
  writer.beginObject("crash");
  writeTrajectory(writer, "ego",
                  pointsAfterContact(crash, [&](double time) { return motion.egoAt(time); }), now);
  auto other = pointsAfterContact(crash, [&](double time) { return motion.attackerAt(time); });
  if (crash.other) {
    const auto before = pointsBefore(motion.contactTime(), *crash.other);
    other.insert(other.begin(), before.begin(), before.end());
  }
  writeTrajectory(writer, "other", other, now);
  writer.beginArray("secondary_contacts");
  for (const SecondaryContact& contact : crash.secondary_contacts) {
    writer.beginObject();
    writer.number("t", contact.time - now);
    writer.flag("is_ego", contact.is_ego);
    writer.text("agent", contact.agent_id);
    writer.endObject();
  }
  writer.endArray();
  writer.endObject();
}

void writeDriveInShort(JsonLineWriter& writer, const PlannerRow& row,
                       const std::optional<ShownCrash>& crash, double now) {
  const RolloutOutcome& driven = row.outcome;
  writer.beginObject("drive");
  writeTrajectory(writer, "ego", driven.driven, now);
  writeTrajectory(writer, "attacker", driven.attacker.points, now);
  if (crash) writeCrash(writer, *crash, now);
  if (row.evasion_drive) writeTrajectory(writer, "evasion", row.evasion_drive->ego.motion, now);
  writePlansInShort(writer, driven.attacker_plans, now);
  writer.endObject();
}

}  // namespace

std::string attackRecord(const Scenario& scenario, const Attack& attack,
                         const std::optional<RecordedOutcome>& recorded,
                         const VerificationOptions& options) {
  const double now = scenario.asked.now;
  JsonLineWriter writer;
  writer.beginObject();
  writer.number("ego_length", scenario.ego.size.length);
  writer.number("ego_width", scenario.ego.size.width);
  writer.beginObject("request");
  writer.count("seed", scenario.asked.request.seed);
  writeControls(writer, scenario.asked.request);
  writer.endObject();
  writeAttacker(writer, attack.trajectory, now);
  writeSupports(writer, attack.supports, now);
  writeAim(writer, attack, now);
  const bool has_conditions = asksForConditions(scenario.asked.request);
  writeCollisionReport(writer, "report", attack.report, now, has_conditions);
  if (recorded) {
    writeCollisionReport(writer, "recorded", recorded->report, now, true);
  }
  if (recorded && recorded->crash) writeCrash(writer, *recorded->crash, now);
  writeLimits(writer, scenario.asked.request.crash.limits, attack.trajectory, options);
  const bool is_first = &attack == &scenario.answer;
  writePlansInShort(writer, is_first ? scenario.plans : std::vector<AttackerPlan>(), now);
  writer.endObject();
  return writer.line();
}

std::string plannerRecord(const PlannerTestResult& result, const PlannerRow& row,
                          const ShownTest& shown) {
  JsonLineWriter writer;
  writer.beginObject();
  writeAvoidability(writer, "avoidability", result.avoidability);
  writePlannerRow(writer, row, result.now);
  if (shown.has_attack && !row.outcome.driven.empty()) {
    writeDriveInShort(writer, row, shown.crash, result.now);
  }
  writer.beginArray("pictures");
  for (const PictureLink& picture : shown.pictures) {
    writer.beginObject();
    writer.text("name", picture.name);
    writer.text("link", picture.link);
    writer.endObject();
  }
  writer.endArray();
  writer.endObject();
  return writer.line();
}

}  // namespace forge
