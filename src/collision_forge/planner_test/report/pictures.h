#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

struct Picture {
  std::string name;  ///< for people
  std::string path;
};

/// By the name of the case and rowName().
using TestPictures = std::map<std::pair<std::string, std::string>, std::vector<Picture>>;

/// What forge test has drawn beside results.jsonl, of its results: those of worst/ and of
/// weaknesses/ that are there. Throws as readWitnessedHits().
TestPictures picturesBeside(const std::string& results_path,
                            const std::vector<PlannerTestResult>& results,
                            const InputLimits& limits);

}  // namespace forge
