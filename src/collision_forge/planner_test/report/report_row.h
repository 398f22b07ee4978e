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

/// A row of the page's table: an answer, one of its alternatives, a planner's test, or how a method
/// did. Texts that do not apply are empty.
struct ReportRow {
  std::size_t file = 0;  ///< place in the list of files
  std::size_t line = 0;  ///< from 1 on
  std::string scene;
  std::string type;
  std::string mode;
  std::string planner;  ///< with its policy, as rowName(); of results.csv the method
  /// "declined", "generated" (nothing is known of the recording), "as_asked", "otherwise" (touches
  /// the ego, but not as asked) or "missed"; of planners "hit", "hit_other", "clear", "failed" or
  /// "untested".
  std::string outcome;
  std::string status;
  std::string message;  ///< for people: why there is no attack, or what is wrong with it
  std::string manoeuvre;
  std::string attacker_class;
  std::string origin;      ///< "recorded" or "added"
  std::string believable;  ///< these two "yes", "no" or empty
  std::string avoidable;
  std::optional<double> now;               ///< s, the scene's clock
  std::optional<double> now_in_recording;  ///< s from the recording's first frame, if that is known
  std::optional<double> tta;               ///< s
  // Contact of the planner's ego, else in the recording if `outcome` is about it, else predicted.
  std::optional<double> contact_t;     ///< s from now
  std::optional<double> impact_speed;  ///< m/s
  std::optional<double> heading;       ///< rad, at contact
  std::optional<double> overlap;       ///< [0, 1]
  std::optional<double> confidence;    ///< [0, 1]
  // Places of records in the page.
  std::optional<double> attack;
  std::optional<double> test;
  std::optional<double> place;     ///< of the scene's
  std::optional<double> commands;  ///< of the ShellCommands
};

/// The row of a scenario's answer, or of one of its alternatives. `recorded` is how it does in the
/// recording, where that is known.
ReportRow rowOfAttack(const Scenario& scenario, const Realization& attack,
                      const std::optional<StrictOutcome>& recorded);

/// The row of a case that was not tested, without `row`, or of a planner in it. What is known of
/// the attack itself is that of `attack`, where there is one.
ReportRow rowOfTest(const PlannerTestResult& result, const PlannerRow* row,
                    const ReportRow* attack);

/// The object "columns": of every field of the rows a column, of texts as words and their places,
/// of numbers as whole units.
void writeColumns(JsonLineWriter& writer, const std::vector<ReportRow>& rows);

}  // namespace forge
