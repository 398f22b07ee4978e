#include "collision_forge/io/scenarios/scenario_file.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {

/// Input: a line of a scenario file.
bool fuzzScenarios(const std::string& input) {
  const std::string where = "scenarios.jsonl: line 1";
  const InputLimits& limits = configuration().input_limits;
  return isTaken(where, [&] {
    const std::string line = scenarioLine(readScenarioLine(where, input, limits));
    requireSame(line, scenarioLine(readScenarioLine(where, line, limits)));
  });
}

}  // namespace forge
