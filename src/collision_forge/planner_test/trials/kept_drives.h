#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// The motions in a file of results, which testCases() wrote: read when they are asked for.
class KeptDrives {
 public:
  /// Throws std::runtime_error for a file that cannot be read.
  explicit KeptDrives(const std::string& path);

  /// The row of a planner in the case at `index`, with its motions. `one` is that case. Throws
  /// JsonLineError as readPlannerResultLine(), std::out_of_range for a row that is not there.
  PlannerRow rowOf(const PlannerCase& one, std::size_t index, const std::string& planner,
                   PolicyKind policy) const;

 private:
  std::string path_;
  std::vector<std::streamoff> lines_;  ///< where they begin
};

}  // namespace forge
