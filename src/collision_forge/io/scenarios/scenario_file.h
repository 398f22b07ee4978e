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

/// The opposite of scenarioLine(): the same line again gives the same bytes. A line of version 5
/// has no tolerance, which is 4 m then, and neither effort, first_other_t nor off_road, which are
/// 0. Throws JsonLineError, naming `where`, for a line that is not of this format or of a version
/// that is neither 5 nor 6, and for a number beyond the limits; InputError as checkLineLength().
Scenario readScenarioLine(const std::string& where, const std::string& line,
                          const InputLimits& limits);

/// s from `now`, to the microsecond, the clock's resolution.
double fromNow(double time, double now);

// Parts of the line, for files that hold the same; times from now.

/// An object of x and y in m, yaw in rad.
void writePose(JsonLineWriter& writer, const char* key, const Pose2& pose);

void writeCollisionReport(JsonLineWriter& writer, const char* key, const CollisionReport& report,
                          double now);

/// The array "plans". `write_points` adds the field "trajectory" to a plan.
using WritePoints = std::function<void(JsonLineWriter& writer,
                                       const std::vector<TrajectoryPoint>& points, double now)>;
void writePlans(JsonLineWriter& writer, const std::vector<AttackerPlan>& plans, double now,
                const WritePoints& write_points);

}  // namespace forge
