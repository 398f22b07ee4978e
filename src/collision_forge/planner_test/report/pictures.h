#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A figure or animation on disk.
struct Picture {
  std::string name;  ///< shown to the user
  std::string path;
};

/// Figures by case name and rowName().
using TestPictures = std::map<std::pair<std::string, std::string>, std::vector<Picture>>;

/// Returns the figures that forge test drew next to results.jsonl for these results, in worst/ and
/// weaknesses/; missing files are skipped. Throws as readWitnessedHits().
TestPictures picturesBeside(const std::string& results_path,
                            const std::vector<PlannerTestResult>& results,
                            const InputLimits& limits);

}  // namespace forge
