#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// A line of witnesses.jsonl of forge test --until-hit: the hardest hit of a weakness.
struct WitnessedHit {
  std::string name;  ///< of the case
  std::string row;   ///< rowName() of the planner
};

/// Reads witnesses.jsonl of a folder in order; empty if the file does not exist. Throws
/// JsonLineError naming file and line, InputError as readInputLine().
std::vector<WitnessedHit> readWitnessedHits(const std::string& folder, const InputLimits& limits);

/// Returns the case names of the lines of weaknesses.jsonl in that folder, in order.
std::vector<std::string> weaknessCases(const std::string& folder, const InputLimits& limits);

}  // namespace forge
