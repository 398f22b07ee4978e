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

/// A row of the page's table: an attack or a rejected request, an alternative of an attack, or a
/// planner's test. A text is empty, and a number nullopt, if it does not apply or is not known.
struct ReportRow {
  std::size_t file = 0;  ///< index in ReportInputs::files
  std::size_t line = 0;  ///< line of that file, from 1 on
  std::string scene;     ///< name of the scene
  std::string type;      ///< requested type, as toString(CollisionType)
  std::string mode;      ///< as toString(Mode); of a test, the mode of the attack
  /// rowName() of the planner; empty for attacks and for untested cases without rows.
  std::string planner;
  /// For attacks "declined" (request rejected), "generated" (no recording available), and against
  /// the recorded ego "as_asked" (StrictOutcome::meetsFullDefinitions()), "otherwise" (touches the
  /// ego, but not as requested) or "missed" (does not touch it). For planners "hit" (the first
  /// contact is with the attacker), "hit_other" (with another agent), "clear" (no contact),
  /// "failed" (PlannerFailure) or "untested" (no test or no row).
  std::string outcome;
  std::string status;     ///< of the attack or of the test: status code as in the files, e.g. "OK"
  std::string message;    ///< for users: why there is no attack or no test, which check the attack
                          ///< fails, or why the planner failed
  std::string manoeuvre;  ///< as toString(Manoeuvre)
  std::string attacker_class;  ///< as toString(AgentClass)
  std::string origin;          ///< "recorded" or "added"
  std::string believable;      ///< of the attack: "yes" (plausible) or "no"
  std::string avoidable;   ///< of a tested case: "yes" or "no", as PlannerTestResult::avoidability;
                           ///< else empty
  std::string avoided_by;  ///< careful drivers that avoid the crash, separated by ", " (avoiders())
  std::optional<double> now;               ///< s, scene clock: t0
  std::optional<double> now_in_recording;  ///< s from the recording's first frame to t0, if known
  std::optional<double> tta;               ///< s, requested
  // The contact of the planner's ego; else the contact in the recording if `outcome` refers to it;
  // else the predicted one.
  std::optional<double> contact_t;     ///< s from t0 to contact
  std::optional<double> impact_speed;  ///< m/s, norm of the relative velocity
  std::optional<double> delta_v;       ///< m/s, of the ego
  /// Probability 0..1 of an injury of MAIS 3 or more, CrashSeverity::worse().
  std::optional<double> mais3;
  /// rad (-pi, pi], yaw of the touched vehicle minus the ego's yaw, at contact.
  std::optional<double> heading;
  std::optional<double> overlap;     ///< share 0..1 of the touched side of the ego,
                                     ///< CollisionReport::overlap; empty for tests
  std::optional<double> confidence;  ///< 0..1, of the attack
  // Indices of records in the page (PageFile::add()).
  std::optional<double> attack;    ///< attackRecord()
  std::optional<double> test;      ///< plannerRecord()
  std::optional<double> place;     ///< sceneRecord() of the row's scene
  std::optional<double> commands;  ///< commandsRecord() with the commands that reproduce the row
};

/// Returns the row of `attack`, which is the scenario's attack or one of its alternatives, or of a
/// rejected request. `recorded`: the attack's result against the recording; nullopt if the
/// recording is not available. The caller sets `file`, `line`, `now_in_recording` and the indices
/// of records.
ReportRow rowOfAttack(const Scenario& scenario, const Attack& attack,
                      const std::optional<StrictOutcome>& recorded);

/// Returns the row of a planner in a case. `row`: an element of `result.rows`; null if there is
/// none. Without `row`, and for a case that was not tested, the outcome is "untested". `attack`:
/// row of the tested attack, whose remaining fields are copied; null if the page does not contain
/// it. The caller sets `file`, `line` and the indices of records.
ReportRow rowOfTest(const PlannerTestResult& result, const PlannerRow* row,
                    const ReportRow* attack);

/// Writes the object "columns" into the open object, with one column per field, named as the field
/// (`attacker_class`: "class"). "values" of a column has one number per row: for texts an index
/// into the column's "words", the distinct texts in order of first appearance; for numbers an
/// integer multiple of the column's "unit", or the number "missing" for nullopt.
void writeColumns(JsonLineWriter& writer, const std::vector<ReportRow>& rows);

}  // namespace forge
