#include "collision_forge/planner_test/report/report_row.h"

#include <cmath>
#include <map>

#include "collision_forge/attack/drivers/careful_drive.h"

namespace forge {
namespace {

/// Represents a missing number; no column reaches it.
constexpr double kMissing = -1e15;

struct TextColumn {
  const char* name;
  std::string ReportRow::*text;
};

struct NumberColumn {
  const char* name;
  std::optional<double> ReportRow::*number;
  double unit;  ///< numbers are written as multiples of it
};

constexpr TextColumn kTexts[] = {{"scene", &ReportRow::scene},
                                 {"type", &ReportRow::type},
                                 {"mode", &ReportRow::mode},
                                 {"planner", &ReportRow::planner},
                                 {"outcome", &ReportRow::outcome},
                                 {"status", &ReportRow::status},
                                 {"message", &ReportRow::message},
                                 {"manoeuvre", &ReportRow::manoeuvre},
                                 {"class", &ReportRow::attacker_class},
                                 {"origin", &ReportRow::origin},
                                 {"believable", &ReportRow::believable},
                                 {"avoidable", &ReportRow::avoidable},
                                 {"avoided_by", &ReportRow::avoided_by}};

/// A column must not round a number before the page rounds it for display: 9.748 m/s must not
/// become 9.75 and then 9.8.
constexpr double kMeasuredUnit = 1e-6;

constexpr NumberColumn kNumbers[] = {
    {"now", &ReportRow::now, kMeasuredUnit},
    {"now_in_recording", &ReportRow::now_in_recording, kMeasuredUnit},
    {"tta", &ReportRow::tta, 1e-3},
    {"contact_t", &ReportRow::contact_t, kMeasuredUnit},
    {"impact_speed", &ReportRow::impact_speed, kMeasuredUnit},
    {"delta_v", &ReportRow::delta_v, kMeasuredUnit},
    {"mais3", &ReportRow::mais3, kMeasuredUnit},
    {"heading", &ReportRow::heading, kMeasuredUnit},
    {"overlap", &ReportRow::overlap, kMeasuredUnit},
    {"confidence", &ReportRow::confidence, kMeasuredUnit},
    {"attack", &ReportRow::attack, 1.0},
    {"test", &ReportRow::test, 1.0},
    {"place", &ReportRow::place, 1.0},
    {"commands", &ReportRow::commands, 1.0}};

std::string yesOrNo(bool value) { return value ? "yes" : "no"; }

void writeTexts(JsonLineWriter& writer, const TextColumn& column,
                const std::vector<ReportRow>& rows) {
  std::map<std::string, double> places;
  std::vector<std::string> words;
  std::vector<double> values;
  for (const ReportRow& row : rows) {
    const std::string& text = row.*column.text;
    const auto [entry, is_new] = places.emplace(text, static_cast<double>(words.size()));
    if (is_new) words.push_back(text);
    values.push_back(entry->second);
  }
  writer.beginObject(column.name);
  writer.texts("words", words);
  writer.numbers("values", values);
  writer.endObject();
}

void writeNumbers(JsonLineWriter& writer, const NumberColumn& column,
                  const std::vector<ReportRow>& rows) {
  std::vector<double> values;
  for (const ReportRow& row : rows) {
    const std::optional<double>& number = row.*column.number;
    values.push_back(number ? std::round(*number / column.unit) : kMissing);
  }
  writer.beginObject(column.name);
  writer.number("unit", column.unit);
  writer.number("missing", kMissing);
  writer.numbers("values", values);
  writer.endObject();
}

void writePlaces(JsonLineWriter& writer, const char* name, std::size_t ReportRow::*place,
                 const std::vector<ReportRow>& rows) {
  std::vector<double> values;
  for (const ReportRow& row : rows) values.push_back(static_cast<double>(row.*place));
  writer.beginObject(name);
  writer.number("unit", 1.0);
  writer.number("missing", kMissing);
  writer.numbers("values", values);
  writer.endObject();
}

std::string outcomeOf(const StrictOutcome& recorded) {
  if (recorded.meetsFullDefinitions()) return "as_asked";
  return recorded.report.contact ? "otherwise" : "missed";
}

std::string outcomeOf(const RolloutOutcome& outcome) {
  if (outcome.failure != PlannerFailure::kNone) return "failed";
  if (!outcome.contact) return "clear";
  return outcome.contact->is_attacker ? "hit" : "hit_other";
}

/// Leaves out the severity of lines that were written without it.
void addSeverity(const CrashSeverity& severity, ReportRow& row) {
  if (severity.ego.curve.empty()) return;
  row.delta_v = severity.ego.delta_v;
  row.mais3 = severity.worse().mais3;
}

/// Returns why the attack does not match the request in the recording.
std::string shortcomingOf(const StrictOutcome& recorded) {
  const CollisionReport& report = recorded.report;
  if (recorded.meetsFullDefinitions()) return "";
  if (!report.contact) return "does not touch the ego as it was recorded";
  if (!report.first_other_id.empty()) return "touches " + report.first_other_id + " before";
  if (!report.limits_kept) return report.broken_limit;
  if (!report.on_time) return "touches the recorded ego too early or too late";
  if (!recorded.full_type_kept) return "touches the recorded ego, but not as its type requires";
  return report.unbelievable;
}

}  // namespace

ReportRow rowOfAttack(const Scenario& scenario, const Attack& attack,
                      const std::optional<StrictOutcome>& recorded) {
  const CollisionRequest& request = scenario.asked.request;
  ReportRow row;
  row.scene = scenario.asked.scene;
  row.now = scenario.asked.now;
  row.type = toString(request.type);
  row.tta = request.tta;
  row.mode = toString(request.mode);
  row.status = toString(attack.status.code);
  row.message = attack.status.message;
  row.outcome = "declined";
  if (attack.status.code != StatusCode::kOk) return row;
  const CollisionReport& report = attack.report;
  row.outcome = recorded ? outcomeOf(*recorded) : "generated";
  if (recorded) row.message = shortcomingOf(*recorded);
  row.manoeuvre = toString(report.manoeuvre);
  row.attacker_class = toString(attack.trajectory.agent_class);
  row.origin = attack.trajectory.isAdded() ? "added" : "recorded";
  row.believable = yesOrNo(report.believable());
  row.confidence = report.confidence;
  row.avoided_by = avoiders(report.careful_drivers, ", ");
  const CollisionReport& told = recorded ? recorded->report : report;
  if (!told.contact) return row;
  row.contact_t = told.contact_time - scenario.asked.now;
  row.impact_speed = told.impact_speed;
  addSeverity(told.severity, row);
  row.heading = told.relative_heading;
  row.overlap = told.overlap;
  return row;
}

ReportRow rowOfTest(const PlannerTestResult& result, const PlannerRow* row,
                    const ReportRow* attack) {
  ReportRow found = attack != nullptr ? *attack : ReportRow();
  if (result.isRead()) {
    found.scene = result.scene;
    found.now = result.now;
    found.type = toString(result.type);
    found.tta = result.tta;
  }
  found.commands.reset();
  found.status = result.status;
  found.message = result.message;
  found.outcome = "untested";
  if (row == nullptr) return found;
  found.planner = rowName(*row);
  if (!result.isTested()) return found;
  const RolloutOutcome& outcome = row->outcome;
  found.outcome = outcomeOf(outcome);
  found.message = outcome.failure_message;
  found.avoidable = yesOrNo(result.avoidability.is_avoidable);
  found.contact_t.reset();
  found.avoided_by = avoiders(outcome.careful_drivers, ", ");
  found.impact_speed.reset();
  found.delta_v.reset();
  found.mais3.reset();
  found.heading.reset();
  found.overlap.reset();
  if (!outcome.contact) return found;
  found.contact_t = outcome.contact->time - result.now;
  found.impact_speed = outcome.contact->impact_speed;
  addSeverity(outcome.contact->severity, found);
  found.heading = outcome.contact->relative_heading;
  return found;
}

void writeColumns(JsonLineWriter& writer, const std::vector<ReportRow>& rows) {
  writer.beginObject("columns");
  writePlaces(writer, "file", &ReportRow::file, rows);
  writePlaces(writer, "line", &ReportRow::line, rows);
  for (const TextColumn& column : kTexts) writeTexts(writer, column, rows);
  for (const NumberColumn& column : kNumbers) writeNumbers(writer, column, rows);
  writer.endObject();
}

}  // namespace forge
