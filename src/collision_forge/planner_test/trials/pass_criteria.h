#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A condition on the results of a planner under which a test fails, such as "avoidable_hits > 0".
struct Criterion {
  std::string text;
  std::string measure;   ///< one of measureNames()
  std::string relation;  ///< ">", ">=", "<" or "<="
  double bound = 0.0;    ///< unit of the measure
};

/// Names of the measures, each with its description and unit, as "hits: ...".
std::vector<std::string> measureDescriptions();

/// Parses "MEASURE RELATION NUMBER". Throws std::invalid_argument with the known measures.
Criterion parseCriterion(const std::string& text);

/// Parses one criterion, or with "@FILE" each line of a file except empty lines and comments (#).
/// Throws as parseCriterion(), naming file and line, and std::invalid_argument for a file that
/// cannot be read or has no criterion.
std::vector<Criterion> parseCriteria(const std::string& text);

/// A criterion applied to one row name (rowName()) of a test.
struct CriterionVerdict {
  Criterion criterion;
  std::string row;
  double value = 0.0;      ///< of the measure over all tested cases
  bool is_failed = false;  ///< the condition of the criterion holds
};

/// Returns one verdict per row name and criterion. A measure of a row without cases is 0.
std::vector<CriterionVerdict> judge(const std::vector<Criterion>& criteria,
                                    const std::vector<PlannerTestResult>& results,
                                    const std::vector<std::string>& rows);

/// Returns one line per verdict, "passed" or "FAILED" first, with a line end each.
std::string verdictText(const std::vector<CriterionVerdict>& verdicts);

/// Returns the first criterion by which a row alone contributes to a failure: it is counted by a
/// measure that counts, or its own value meets the condition. Empty if there is none.
std::string failedBy(const std::vector<Criterion>& criteria, const PlannerRow& row);

}  // namespace forge
