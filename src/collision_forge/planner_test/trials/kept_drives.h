#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Reads motions on demand from a results file that testCases() wrote.
class KeptDrives {
 public:
  /// `path`: the completed results file, which must not change. Throws std::runtime_error if the
  /// file cannot be read or is empty.
  explicit KeptDrives(const std::string& path);

  /// Returns the row of `key`, with its motions, in the case `one`, from which the attackers get
  /// class, size and past. `index`: of the case in the run, so its line is `index` + 1. Throws
  /// JsonLineError as readPlannerResultLine(), and std::out_of_range if the file has no such row or
  /// line.
  PlannerRow rowOf(const PlannerCase& one, std::size_t index, const RowKey& key) const;

 private:
  std::string path_;
  std::vector<std::streamoff> lines_;  ///< byte offset of each line
};

}  // namespace forge
