#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/scenarios/relative_time.h"

namespace forge {

/// A request and its result: one line of a scenario file.
struct Scenario {
  SceneRequest asked;  ///< the request, its scene and t0
  EgoVehicle ego;      ///< box of the ego, and offset of its centre from base_link
  Attack answer;       ///< the result; times on the scene's clock
  /// Adaptive mode: AttackerPolicy::plans(); empty in other modes and without an attack.
  std::vector<AttackerPlan> plans = {};
};

/// Returns one line, without a line end, as docs/scenarios.md and docs/scenario.schema.json define
/// it. Times are in s from t0, rounded to 1 us (the clock's resolution); other fields as in the
/// structs, global map frame. The line holds only `believable` and `limits` of the crash
/// definition, and of past states the speed along the heading. Throws std::invalid_argument for a
/// number that is not finite.
std::string scenarioLine(const Scenario& scenario);

/// Parses a line of scenarioLine(); scenarioLine() of the result gives the same bytes. Older
/// versions lack fields, which are then set: version 6 lacks severity and careful_drivers (empty),
/// version 5 also tolerance (4 m), effort, first_other_t and off_road (0). `where` names file and
/// line in errors. Throws JsonLineError for a line of another format or version, for fields that
/// contradict each other, and for a number beyond the limits; InputError as checkLineLength().
Scenario readScenarioLine(const std::string& where, const std::string& line,
                          const InputLimits& limits);

/// Adds the field "trajectory" with `points` to the open object of `writer`; times in s from `now`.
using WritePoints = std::function<void(JsonLineWriter& writer,
                                       const std::vector<TrajectoryPoint>& points, double now)>;
/// Writes the array "plans" of docs/scenarios.md; times in s from `now` (s, clock of the plans).
/// Calls `write_points` once for each plan, with the plan's object open.
void writePlans(JsonLineWriter& writer, const std::vector<AttackerPlan>& plans, double now,
                const WritePoints& write_points);

}  // namespace forge
