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
  std::string name;  ///< title, shown to the user
  std::string path;  ///< absolute path of a PNG or GIF file
};

/// Figures by the pair of PlannerTestResult::name and rowName().
using TestPictures = std::map<std::pair<std::string, std::string>, std::vector<Picture>>;

/// Returns the figures that forge test drew in the folder of the results file at `results_path`:
/// the worst hits (worst/ with the names of pictureName()) and the weaknesses with their evasive
/// manoeuvres (weaknesses/N and weaknesses/N_escape, N: line of witnesses.jsonl from 1 on), in this
/// order per test. `results`: all results of that file in its order, since the figures are numbered
/// by worstCases(). If a figure exists as PNG and GIF, the GIF is taken; a figure without a file is
/// left out. A test without figures may have no element or an empty one. Throws as
/// readWitnessedHits().
TestPictures picturesBeside(const std::string& results_path,
                            const std::vector<PlannerTestResult>& results,
                            const InputLimits& limits);

}  // namespace forge
