#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "collision_forge/files/resumable_file.h"
#include "collision_forge/trials/planner_cases.h"
#include "collision_forge/trials/planner_result.h"

namespace forge {

/// The result of the case at an index; one that cannot be read is kUnreadable.
PlannerTestResult testCase(const PlannerCases& cases, std::size_t index,
                           const std::function<PlannerTestResult(const PlannerCase&)>& test);

/// The results of all cases in their order, in a file: those of a run before and the new ones. For
/// the master.
class PlannerResultLines {
 public:
  /// `names`, of the cases, must outlive it. Throws as ResumableFile and readPlannerResultLine(),
  /// std::runtime_error for a line of another case.
  PlannerResultLines(const std::string& path, const ResumableFile::Options& options,
                     const std::vector<std::string>& names);

  /// How many a run before left.
  std::size_t first() const { return first_; }
  const std::vector<PlannerTestResult>& results() const { return results_; }

  void take(const std::string& line);
  void complete();

 private:
  void keep(const std::string& where, const std::string& line);

  ResumableFile file_;
  const std::vector<std::string>& names_;
  std::vector<PlannerTestResult> results_;
  std::size_t first_ = 0;
};

}  // namespace forge
