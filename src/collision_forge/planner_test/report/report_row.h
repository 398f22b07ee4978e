#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/strict_outcome.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A row of the page's table: an attack or rejected request, an alternative, a planner's test, or a
/// result of a method. Texts that do not apply are empty.
struct ReportRow {
  std::size_t file = 0;  ///< index in the list of files
  std::size_t line = 0;  ///< from 1 on
  std::string scene;
  std::string type;
  std::string mode;     ///< "history" or "replay"
  std::string planner;  ///< rowName(); for results.csv the method
  /// For attacks "declined" (request rejected), "generated" (no recording available), "as_asked",
  /// "otherwise" (touches the ego, but not as requested) or "missed"; for planners "hit",
  /// "hit_other", "clear", "failed" or "untested".
  std::string outcome;
  std::string status;     ///< status code as in the files, e.g. "OK"
  std::string message;    ///< for users: why there is no attack, or which check the attack fails
  std::string manoeuvre;  ///< as toString(Manoeuvre)
  std::string attacker_class;              ///< as toString(AgentClass)
  std::string origin;                      ///< "recorded" or "added"
  std::string believable;                  ///< "yes": plausible; "no"; empty: unknown
  std::string avoidable;                   ///< "yes", "no" or empty
  std::string avoided_by;                  ///< careful drivers, separated by commas
  std::optional<double> now;               ///< s, scene clock; t0
  std::optional<double> now_in_recording;  ///< s from the recording's first frame to t0, if known
  std::optional<double> tta;               ///< s
  // The contact of the planner's ego; else the contact in the recording if `outcome` refers to it;
  // else the predicted one.
  std::optional<double> contact_t;     ///< s from t0
  std::optional<double> impact_speed;  ///< m/s
  std::optional<double> delta_v;       ///< m/s, of the ego
  std::optional<double> mais3;         ///< of CrashSeverity::worse(), [0, 1]
  std::optional<double> heading;       ///< rad, at contact
  std::optional<double> overlap;       ///< [0, 1]
  std::optional<double> confidence;    ///< [0, 1]
  // Indices of records in the page (PageFile::add()).
  std::optional<double> attack;    ///< attackRecord()
  std::optional<double> test;      ///< plannerRecord()
  std::optional<double> place;     ///< of the scene
  std::optional<double> commands;  ///< of the ShellCommands
};

/// Returns the row of a scenario's attack or of one of its alternatives. `recorded`: its result
/// against the recording, if available.
ReportRow rowOfAttack(const Scenario& scenario, const Attack& attack,
                      const std::optional<StrictOutcome>& recorded);

/// Returns the row of a planner in a case, or of an untested case if `row` is null. Copies the
/// fields of the attack itself from `attack`, if given.
ReportRow rowOfTest(const PlannerTestResult& result, const PlannerRow* row,
                    const ReportRow* attack);

/// Writes the object "columns", one column per field: texts as a dictionary and indices, numbers as
/// multiples of a unit.
void writeColumns(JsonLineWriter& writer, const std::vector<ReportRow>& rows);

}  // namespace forge
