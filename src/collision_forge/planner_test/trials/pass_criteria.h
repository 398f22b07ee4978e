#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A condition on the results of a planner under which a test fails, such as "avoidable_hits > 0".
struct Criterion {
  std::string text;      ///< as the user wrote it
  std::string measure;   ///< name of one of measureDescriptions()
  std::string relation;  ///< ">", ">=", "<" or "<="; the criterion fails a test if MEASURE RELATION
                         ///< BOUND holds
  double bound = 0.0;    ///< in the unit of the measure
};

/// Returns a line per measure: its name, description and unit, as "hits: cases in which the
/// attacker hits the ego".
std::vector<std::string> measureDescriptions();

/// Returns the criterion in "MEASURE RELATION NUMBER"; spaces around the relation are optional.
/// Throws std::invalid_argument, for an unknown measure with the known ones.
Criterion parseCriterion(const std::string& text);

/// Returns the one criterion in `text`, or with "@FILE" the criteria in a file, one per line in
/// order; empty lines are skipped, and "#" begins a comment. Throws as parseCriterion(), naming
/// file and line, and std::invalid_argument for a file that cannot be read or has no criterion.
std::vector<Criterion> parseCriteria(const std::string& text);

/// A criterion applied to all tested cases of one row name.
struct CriterionVerdict {
  Criterion criterion;  ///< as given
  std::string row;      ///< rowName()
  /// Value of the measure over all tested cases: a count, mean, greatest or least value.
  double value = 0.0;
  bool is_failed = false;  ///< the condition of the criterion holds
};

/// Returns one verdict per name in `rows` (rowName(); outer loop) and criterion. A measure of a row
/// without tested cases is 0, and its criterion is applied all the same. Throws
/// std::invalid_argument for an unknown measure.
std::vector<CriterionVerdict> judge(const std::vector<Criterion>& criteria,
                                    const std::vector<PlannerTestResult>& results,
                                    const std::vector<std::string>& rows);

/// Returns one line per verdict, "passed" or "FAILED" first, then row, criterion and value, with a
/// line end each: "FAILED  pdm: fails if hits > 0; hits = 2".
std::string verdictText(const std::vector<CriterionVerdict>& verdicts);

/// Returns Criterion::text of the first criterion by which a row alone contributes to a failure: a
/// measure that counts cases counts the row (whatever the bound), or the row's own value of another
/// measure meets the condition. Empty if there is none.
std::string failedBy(const std::vector<Criterion>& criteria, const PlannerRow& row);

}  // namespace forge
