#include "collision_forge/report/attack_record.h"

#include "collision_forge/data/request_fields.h"
#include "collision_forge/policy/attacker_policy.h"
#include "collision_forge/report/compact_motion.h"
#include "collision_forge/trials/planner_result_file.h"

namespace forge {
namespace {

void writeReport(JsonLineWriter& writer, const char* key, const CollisionReport& report,
                 double now) {
  writer.beginObject(key);
  writer.flag("contact", report.contact);
  if (report.contact) {
    writer.number("contact_t", fromNow(report.contact_time, now));
    writer.number("relative_heading", report.relative_heading);
    writeReportPose(writer, "ego", report.ego_at_contact);
    writeReportPose(writer, "attacker", report.attacker_at_contact);
    writer.text("ego_side", toString(report.ego_side));
    writer.text("attacker_side", toString(report.attacker_side));
    writer.number("impact_speed", report.impact_speed);
    writer.number("overlap", report.overlap);
    writer.text("manoeuvre", toString(report.manoeuvre));
    writer.number("manoeuvre_begin_t", fromNow(report.manoeuvre_begin, now));
  }
  writer.flag("type_kept", report.type_kept);
  writer.flag("on_time", report.on_time);
  writer.flag("limits_kept", report.limits_kept);
  writer.text("broken_limit", report.broken_limit);
  writer.text("first_other", report.first_other_id);
  writer.number("off_road_share", report.off_road_share);
  writer.number("on_lane", report.road.on_lane);
  writer.number("wrong_way", report.road.wrong_way);
  writer.number("on_walkway", report.road.on_walkway);
  writer.number("on_island", report.road.on_island);
  writer.text("unbelievable", report.unbelievable);
  writer.endObject();
}

void writePlans(JsonLineWriter& writer, const std::vector<AttackerPlan>& plans, double now) {
  writer.beginArray("plans");
  for (const AttackerPlan& plan : plans) {
    writer.beginObject();
    writer.number("seen_t", fromNow(plan.seen, now));
    writer.number("from_t", fromNow(plan.from, now));
    writer.text("phase", toString(plan.phase));
    writer.text("reason", plan.reason);
    writeTrajectory(writer, "trajectory", plan.points, now);
    writer.endObject();
  }
  writer.endArray();
}

/// Those of the request's set, as far as both sets have them.
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
    writer.number("max_speed", limits.max_speed);
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

void writeAim(JsonLineWriter& writer, const Realization& attack, double now) {
  const CollisionPattern& aim = attack.aim;
  writer.beginObject("aim");
  writer.number("t", fromNow(aim.time, now));
  writeReportPose(writer, "ego", aim.ego.center);
  writeReportPose(writer, "attacker", compose(aim.ego.center, aim.attacker_offset));
  writer.number("miss_distance", attack.miss.distance);
  writer.endObject();
}

void writeAvoidability(JsonLineWriter& writer, const char* key,
                       const AvoidabilitySummary& summary) {
  std::vector<std::string> manoeuvres;
  for (const EvasiveManoeuvre manoeuvre : summary.from_now) {
    manoeuvres.emplace_back(toString(manoeuvre));
  }
  writer.beginObject(key);
  writer.flag("avoidable", summary.is_avoidable);
  writer.texts("from_now", manoeuvres);
  if (summary.is_avoidable) {
    writer.text("manoeuvre", toString(summary.last));
    writer.number("start_t", summary.last_after);
  }
  writer.endObject();
}

void writeDrive(JsonLineWriter& writer, const RolloutOutcome& driven, double now) {
  writer.beginObject("drive");
  writeTrajectory(writer, "ego", driven.driven, now);
  writeTrajectory(writer, "attacker", driven.attacker.points, now);
  writePlans(writer, driven.attacker_plans, now);
  writer.endObject();
}

}  // namespace

std::string attackRecord(const Scenario& scenario, const Realization& attack,
                         const std::optional<CollisionReport>& recorded,
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
  writeAim(writer, attack, now);
  writeReport(writer, "report", attack.report, now);
  if (recorded) writeReport(writer, "recorded", *recorded, now);
  writeLimits(writer, scenario.asked.request.crash.limits, attack.trajectory, options);
  const bool is_first = &attack == &scenario.answer;
  writePlans(writer, is_first ? scenario.plans : std::vector<AttackerPlan>(), now);
  writer.endObject();
  return writer.line();
}

std::string plannerRecord(const PlannerTestResult& result, const PlannerRow& row,
                          const RolloutOutcome* driven) {
  const RolloutOutcome& outcome = row.outcome;
  JsonLineWriter writer;
  writer.beginObject();
  writer.text("failure", toString(outcome.failure));
  writer.text("failure_message", outcome.failure_message);
  if (outcome.contact) writeContact(writer, *outcome.contact, result.now);
  writeAvoidability(writer, "avoidability", result.avoidability);
  if (row.escape) writeAvoidability(writer, "escape", *row.escape);
  writer.flag("fair", row.is_fair);
  writer.text("phase", toString(row.attacker.phase));
  writer.text("attacker_broken_limit", row.attacker.broken_limit);
  writer.text("attacker_touched", row.attacker.touched);
  writer.flag("as_asked", row.attacker.as_asked);
  writer.number("duration", outcome.duration);
  writer.number("max_braking", outcome.max_braking);
  writer.number("hard_braking", outcome.hard_braking);
  writer.number("off_road_share", outcome.off_road_share);
  writer.number("progress", outcome.progress);
  writer.number("recorded_progress", outcome.recorded_progress);
  writer.beginObject("nuplan");
  for (const NuplanPart& part : nuplanParts()) writer.number(part.name, outcome.nuplan.*part.value);
  writer.endObject();
  if (driven != nullptr) writeDrive(writer, *driven, result.now);
  writer.endObject();
  return writer.line();
}

}  // namespace forge
