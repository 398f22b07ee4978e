#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// A line of witnesses.jsonl of forge test --until-hit: the hardest hit of a weakness.
struct WitnessedHit {
  std::string name;  ///< PlannerTestResult::name of the case
  std::string row;   ///< rowName() of planner, attacker policy and background
};

/// Returns the lines of FOLDER/witnesses.jsonl (fields: docs/adaptive.md) in order; empty if the
/// file does not exist or cannot be opened. Throws JsonLineError naming file and line, InputError
/// as readInputLine().
std::vector<WitnessedHit> readWitnessedHits(const std::string& folder, const InputLimits& limits);

/// Returns the distinct case names of readWitnessedHits(), in the order of first appearance.
/// Element i is the case of line i + 1 of FOLDER/weaknesses.jsonl. Throws as readWitnessedHits().
std::vector<std::string> weaknessCases(const std::string& folder, const InputLimits& limits);

}  // namespace forge
