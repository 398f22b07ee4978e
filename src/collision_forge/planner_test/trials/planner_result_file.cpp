#include "collision_forge/planner_test/trials/planner_result_file.h"

#include <cmath>
#include <cstdint>
#include <optional>

#include "collision_forge/attack/drivers/careful_drive.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/io/scenarios/severity_fields.h"
#include "collision_forge/planner_test/statistics/csv_text.h"
#include "collision_forge/planner_test/trials/drive_fields.h"

namespace forge {
namespace {

constexpr const char* kFormat = "collision_forge/planner_test";
constexpr int kVersion = 8;
constexpr int kMaxRows = 10000;              // rows of a case
constexpr std::size_t kContactColumns = 18;  // of a row of the CSV file

void writeNuplan(JsonLineWriter& writer, const NuplanScore& score) {
  writer.beginObject("nuplan");
  for (const NuplanPart& part : nuplanParts()) writer.number(part.name, score.*part.value);
  if (score.speed_limit) {
    writer.number("speed_limit", *score.speed_limit);
  } else {
    writer.null("speed_limit");
  }
  writer.endObject();
}

void writeAttacker(JsonLineWriter& writer, const AttackerSummary& attacker) {
  writer.beginObject("attacker");
  writer.text("policy", toString(attacker.policy));
  writer.text("phase", toString(attacker.phase));
  writer.count("plans", static_cast<std::uint64_t>(attacker.plans));
  writer.text("broken_limit", attacker.broken_limit);
  writer.text("touched", attacker.touched);
  writer.flag("as_asked", attacker.as_asked);
  writer.endObject();
}

void writeContact(JsonLineWriter& writer, const PlannerContact& contact, double now) {
  writer.beginObject("contact");
  writer.text("other", contact.other_id);
  writer.flag("attacker", contact.is_attacker);
  writer.number("t", fromNow(contact.time, now));
  writer.text("place", toString(contact.place));
  if (contact.type) {
    writer.text("type", toString(*contact.type));
  } else {
    writer.null("type");
  }
  writer.number("relative_heading", contact.relative_heading);
  writer.text("ego_side", toString(contact.ego_side));
  writer.text("other_side", toString(contact.other_side));
  writer.number("impact_speed", contact.impact_speed);
  writeSeverity(writer, "severity", contact.severity);
  writer.number("ego_speed", contact.ego_speed);
  writer.text("cause", toString(contact.cause));
  writer.flag("at_fault", contact.at_fault);
  writer.endObject();
}

/// Writes the request of a readable case.
void writeCase(JsonLineWriter& writer, const PlannerTestResult& result) {
  if (!result.isRead()) {
    for (const char* key : {"source", "scene", "type", "tta", "now"}) writer.null(key);
    return;
  }
  writer.text("source", result.source);
  writer.text("scene", result.scene);
  writer.text("type", toString(result.type));
  writer.number("tta", result.tta);
  writer.number("now", result.now);
}

/// Returns the parsed name; fails with the field's name if `parse` does not know it.
template <typename Parse>
auto readName(JsonObject& object, const char* key, const Parse& parse) {
  const auto value = parse(object.text(key));
  if (!value) object.fail(key, "is not a known name");
  return *value;
}

void readCase(JsonObject& object, PlannerTestResult& result) {
  if (!result.isRead()) {
    for (const char* key : {"source", "scene", "type"}) {
      if (object.textOrNull(key)) object.fail(key, "must be absent in an unreadable case");
    }
    for (const char* key : {"tta", "now"}) {
      if (object.numberOrNull(key)) object.fail(key, "must be absent in an unreadable case");
    }
    return;
  }
  result.source = object.text("source");
  result.scene = object.text("scene");
  result.type = readName(object, "type", collisionTypeFromString);
  result.tta = object.number("tta");
  result.now = object.number("now");
}

AvoidabilitySummary readAvoidability(JsonObject object) {
  AvoidabilitySummary summary;
  summary.is_avoidable = object.flag("avoidable");
  for (const std::string& name : object.texts("from_now")) {
    const auto manoeuvre = evasiveManoeuvreFromString(name);
    if (!manoeuvre) object.fail("from_now", "\"" + name + "\" is not a known manoeuvre");
    summary.from_now.push_back(*manoeuvre);
  }
  auto last = object.objectOrNull("last");
  if (last.has_value() != summary.is_avoidable) object.fail("last", "contradicts avoidable");
  if (last) {
    summary.last = readName(*last, "manoeuvre", evasiveManoeuvreFromString);
    summary.last_after = last->number("start_t");
    summary.off_road_share = last->number("off_road_share");
    last->finish();
  }
  object.finish();
  return summary;
}

PlannerContact readContact(JsonObject object, double now) {
  PlannerContact contact;
  contact.other_id = object.text("other");
  contact.is_attacker = object.flag("attacker");
  contact.time = now + object.number("t");
  contact.place = readName(object, "place", contactPlaceFromString);
  if (const auto type = object.textOrNull("type")) {
    contact.type = collisionTypeFromString(*type);
    if (!contact.type) object.fail("type", "is not a collision type");
  }
  contact.relative_heading = object.number("relative_heading");
  contact.ego_side = readName(object, "ego_side", sideFromString);
  contact.other_side = readName(object, "other_side", sideFromString);
  contact.impact_speed = object.number("impact_speed");
  contact.severity = readSeverity(object.object("severity"));
  contact.ego_speed = object.number("ego_speed");
  contact.cause = readName(object, "cause", contactCauseFromString);
  contact.at_fault = object.flag("at_fault");
  object.finish();
  return contact;
}

NuplanScore readNuplan(JsonObject object) {
  NuplanScore score;
  for (const NuplanPart& part : nuplanParts()) score.*part.value = object.number(part.name);
  score.speed_limit = object.numberOrNull("speed_limit");
  object.finish();
  return score;
}

AttackerSummary readAttacker(JsonObject object) {
  AttackerSummary attacker;
  attacker.policy = readName(object, "policy", policyKindFromString);
  attacker.phase = readName(object, "phase", attackerPhaseFromString);
  attacker.plans = static_cast<int>(object.count("plans"));
  attacker.broken_limit = object.text("broken_limit");
  attacker.touched = object.text("touched");
  attacker.as_asked = object.flag("as_asked");
  object.finish();
  return attacker;
}

PlannerRow readRow(JsonObject& object, double now) {
  PlannerRow row;
  row.planner = object.text("planner");
  row.background = readName(object, "background", backgroundFromString);
  row.attacker = readAttacker(object.object("attacker"));
  row.outcome.failure = readName(object, "failure", plannerFailureFromString);
  row.outcome.failure_message = object.text("message");
  if (auto contact = object.objectOrNull("contact")) {
    row.outcome.contact = readContact(*contact, now);
  }
  row.outcome.careful_drivers = readCarefulDrivers(object, now);
  if (auto evasion = object.objectOrNull("evasion")) row.evasion = readAvoidability(*evasion);
  row.is_fair = object.flag("fair");
  row.outcome.duration = object.number("duration");
  row.outcome.max_braking = object.number("max_braking");
  row.outcome.hard_braking = object.number("hard_braking");
  row.outcome.off_road_share = object.number("off_road_share");
  row.outcome.progress = object.number("progress");
  row.outcome.recorded_progress = object.number("recorded_progress");
  row.outcome.nuplan = readNuplan(object.object("nuplan"));
  row.outcome.plans = static_cast<int>(object.count("plans"));
  if (const auto hit = object.numberOrNull("published_hit")) row.published_hit = *hit != 0.0;
  readDrive(object, row, now);
  object.finish();
  return row;
}

/// Returns the case's columns in a row of the CSV file.
std::string csvStart(const PlannerTestResult& result) {
  if (!result.isRead()) return csvText(result.name) + ",,,,," + result.status;
  return csvText(result.name) + ',' + csvText(result.source) + ',' + csvText(result.scene) + ',' +
         toString(result.type) + ',' + formatted("%.3f", result.tta) + ',' + result.status;
}

std::string csvContact(const std::optional<PlannerContact>& contact, double now) {
  if (!contact) return std::string(kContactColumns - 1, ',');
  constexpr double kDegrees = 180.0 / M_PI;
  const std::string numbers =
      formatted("%.3f,%s,%.2f,%s,%s,%.2f,%.2f", contact->time - now,
                contact->type ? toString(*contact->type) : "", contact->relative_heading * kDegrees,
                toString(contact->ego_side), toString(contact->other_side), contact->impact_speed,
                contact->ego_speed);
  const CrashSeverity& severity = contact->severity;
  const CrashEffect& worse = severity.worse();
  const std::string harm =
      formatted(",%.2f,%.2f,%.4f,%.4f,%s,", severity.ego.delta_v, severity.other.delta_v,
                worse.mais2, worse.mais3, severityClass(worse).c_str()) +
      csvText(worse.curve) + ',';
  return csvText(contact->other_id) + ',' + (contact->is_attacker ? "1," : "0,") + numbers + harm +
         toString(contact->cause) + ',' + (contact->at_fault ? "1," : "0,") +
         toString(contact->place);
}

/// Returns the column names, each after a comma.
std::string nuplanColumns() {
  std::string names;
  for (const NuplanPart& part : nuplanParts()) names += std::string(",nuplan_") + part.name;
  return names;
}

std::string csvNuplan(const NuplanScore& score) {
  std::string values;
  for (const NuplanPart& part : nuplanParts()) {
    values += formatted(",%.4f", score.*part.value);
  }
  return values;
}

std::string csvAttacker(const AttackerSummary& attacker) {
  return std::string(toString(attacker.policy)) + ',' + toString(attacker.phase) + ',' +
         std::to_string(attacker.plans) + ',' + csvText(attacker.broken_limit) + ',' +
         csvText(attacker.touched) + ',' + (attacker.as_asked ? "1" : "0");
}

/// Returns manoeuvre and start (s after t0) of the last witness; empty columns if there is none.
std::string csvLast(const AvoidabilitySummary& summary) {
  if (!summary.is_avoidable) return ",";
  return formatted("%s,%.3f", toString(summary.last), summary.last_after);
}

std::string csvHit(const std::optional<bool>& hit) { return hit ? (*hit ? "1" : "0") : ""; }

/// Returns one row per planner, or one without a planner if there is none.
std::vector<std::string> untestedCsvRows(const std::string& start,
                                         const std::vector<PlannerRow>& rows) {
  constexpr std::size_t kBefore = 5;  // columns up to the planner's
  const std::size_t after = 19 + kContactColumns + nuplanParts().size();
  if (rows.empty()) return {start + std::string(kBefore + after, ',')};
  std::vector<std::string> lines;
  for (const PlannerRow& row : rows) {
    lines.push_back(start + std::string(kBefore, ',') + row.planner + std::string(after, ',') +
                    csvHit(row.published_hit));
  }
  return lines;
}

}  // namespace

void writeAvoidability(JsonLineWriter& writer, const char* key,
                       const AvoidabilitySummary& summary) {
  writer.beginObject(key);
  writer.flag("avoidable", summary.is_avoidable);
  std::vector<std::string> names;
  for (const EvasiveManoeuvre manoeuvre : summary.from_now) names.emplace_back(toString(manoeuvre));
  writer.texts("from_now", names);
  if (summary.is_avoidable) {
    writer.beginObject("last");
    writer.text("manoeuvre", toString(summary.last));
    writer.number("start_t", summary.last_after);
    writer.number("off_road_share", summary.off_road_share);
    writer.endObject();
  } else {
    writer.null("last");
  }
  writer.endObject();
}

void writePlannerRow(JsonLineWriter& writer, const PlannerRow& row, double now) {
  const RolloutOutcome& outcome = row.outcome;
  writer.text("planner", row.planner);
  writer.text("background", toString(row.background));
  writeAttacker(writer, row.attacker);
  writer.text("failure", toString(outcome.failure));
  writer.text("message", outcome.failure_message);
  if (outcome.contact) {
    writeContact(writer, *outcome.contact, now);
  } else {
    writer.null("contact");
  }
  writeCarefulDrivers(writer, outcome.careful_drivers, now);
  if (row.evasion) {
    writeAvoidability(writer, "evasion", *row.evasion);
  } else {
    writer.null("evasion");
  }
  writer.flag("fair", row.is_fair);
  writer.number("duration", outcome.duration);
  writer.number("max_braking", outcome.max_braking);
  writer.number("hard_braking", outcome.hard_braking);
  writer.number("off_road_share", outcome.off_road_share);
  writer.number("progress", outcome.progress);
  writer.number("recorded_progress", outcome.recorded_progress);
  writeNuplan(writer, outcome.nuplan);
  writer.count("plans", static_cast<std::uint64_t>(outcome.plans));
  if (row.published_hit) {
    writer.number("published_hit", *row.published_hit ? 1.0 : 0.0);
  } else {
    writer.null("published_hit");
  }
}

void writePlannerResult(JsonLineWriter& writer, const PlannerTestResult& result) {
  writer.text("name", result.name);
  writeCase(writer, result);
  writer.text("status", result.status);
  writer.text("message", result.message);
  writer.flag("strict", result.is_strict);
  writeAvoidability(writer, "avoidability", result.avoidability);
  writeCarefulDrivers(writer, result.careful_drivers, result.now);
  writer.beginArray("planners");
  for (const PlannerRow& row : result.rows) {
    writer.beginObject();
    writePlannerRow(writer, row, result.now);
    writeDrive(writer, row, result.now);
    writer.endObject();
  }
  writer.endArray();
}

std::string plannerResultLine(const PlannerTestResult& result) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.text("format", kFormat);
  writer.count("version", kVersion);
  writePlannerResult(writer, result);
  writer.endObject();
  return writer.line();
}

PlannerTestResult readPlannerResultLine(const std::string& where, const std::string& line) {
  const JsonLine parsed(where, line);
  JsonObject object = parsed.root();
  if (object.text("format") != kFormat) object.fail("format", std::string("is not ") + kFormat);
  if (object.number("version") != kVersion) {
    object.fail("version", "is not " + std::to_string(kVersion));
  }
  PlannerTestResult result;
  result.name = object.text("name");
  result.status = object.text("status");
  readCase(object, result);
  result.message = object.text("message");
  result.is_strict = object.flag("strict");
  result.avoidability = readAvoidability(object.object("avoidability"));
  result.careful_drivers = readCarefulDrivers(object, result.now);
  for (JsonObject& row : object.objects("planners", kMaxRows)) {
    result.rows.push_back(readRow(row, result.now));
  }
  object.finish();
  return result;
}

std::string plannerResultCsvHeader() {
  return "name,source,scene,type,tta,status,strict,avoidable,last_manoeuvre,last_start,planner,"
         "background,policy,phase,attacker_plans,broken_limit,touched,as_asked,escape_manoeuvre,"
         "escape_start,"
         "avoided_by,fair,failure,other,attacker,"
         "contact_after,contact_type,relative_heading,ego_side,other_side,impact_speed,ego_speed,"
         "ego_delta_v,other_delta_v,mais2,mais3,severity_class,injury_curve,cause,at_fault,place,"
         "duration,max_braking,hard_braking,off_road_share,"
         "progress,recorded_progress" +
         nuplanColumns() + ",published_hit";
}

std::vector<std::string> plannerResultCsvRows(const PlannerTestResult& result) {
  std::string start = csvStart(result);
  if (!result.isTested()) return untestedCsvRows(start, result.rows);
  const AvoidabilitySummary& avoidability = result.avoidability;
  start += result.is_strict ? ",1" : ",0";
  start += (avoidability.is_avoidable ? ",1," : ",0,") + csvLast(avoidability);
  std::vector<std::string> rows;
  for (const PlannerRow& row : result.rows) {
    const RolloutOutcome& outcome = row.outcome;
    const std::string numbers = formatted(
        "%.3f,%.3f,%.3f,%.4f,%.3f,%.3f", outcome.duration, outcome.max_braking,
        outcome.hard_braking, outcome.off_road_share, outcome.progress, outcome.recorded_progress);
    rows.push_back(start + ',' + row.planner + ',' + toString(row.background) + ',' +
                   csvAttacker(row.attacker) + ',' + (row.evasion ? csvLast(*row.evasion) : ",") +
                   ',' + avoiders(row.outcome.careful_drivers, " ") +
                   (row.is_fair ? ",1," : ",0,") + toString(outcome.failure) + ',' +
                   csvContact(outcome.contact, result.now) + ',' + numbers +
                   csvNuplan(outcome.nuplan) + ',' + csvHit(row.published_hit));
  }
  return rows;
}

}  // namespace forge
