#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// A line of witnesses.jsonl of forge test --until-hit: a weakness, by its hardest hit.
struct WitnessedHit {
  std::string name;  ///< of the case
  std::string row;   ///< rowName() of the planner
};

/// Those of the file in a folder, in its order; none where there is no such file. Throws
/// JsonLineError naming file and line, InputError as readInputLine().
std::vector<WitnessedHit> readWitnessedHits(const std::string& folder, const InputLimits& limits);

/// The cases that the lines of weaknesses.jsonl in that folder are, first to last.
std::vector<std::string> weaknessCases(const std::string& folder, const InputLimits& limits);

}  // namespace forge
