#pragma once

#include <string>

#include "collision_forge/attack/realizer.h"
#include "collision_forge/data/json_line.h"
#include "collision_forge/policy/attacker_policy.h"
#include "collision_forge/scene/collision_request.h"
#include "collision_forge/scene/scene.h"

namespace forge {

/// A request with its answer: one line of a scenario file.
struct Scenario {
  SceneRequest asked;
  EgoVehicle ego;
  Realization answer;                    ///< times on the scene's clock
  std::vector<AttackerPlan> plans = {};  ///< of an adaptive attacker, AttackerPolicy::plans()
};

/// One line, without a line end, as docs/scenarios.md and docs/scenario.schema.json have it: times
/// in seconds from now to the microsecond (the clock's resolution), all else as in the structs (of
/// the crash definition `believable` and `limits`, of past states the speed along the heading),
/// global map frame. Throws std::invalid_argument for a number that is not finite.
std::string scenarioLine(const Scenario& scenario);

/// The opposite of scenarioLine(): the same line again gives the same bytes. Not in
/// the file: the report's time of another's touch and its road.off_road. Throws JsonLineError,
/// naming `where`, for a line that is not of this format and version.
Scenario readScenarioLine(const std::string& where, const std::string& line);

}  // namespace forge
