#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Measures of one step of a rollout: the columns of steps/N.csv that docs/planners.md defines. SI
/// units, rad, map frame; the point is of the middle of the ego's box.
struct StepMetrics {
  TrajectoryPoint point;
  std::optional<double> jerk;  ///< this and the next are empty in the first step
  std::optional<double> lateral_acceleration;
  std::optional<double> attacker_gap;
  std::optional<double> attacker_ttc;  ///< empty if there is no contact within kTtcHorizon
  std::string nearest;  ///< id of the agent with the smallest gap; "" if there is none
  std::optional<double> nearest_gap;
  std::string lane;             ///< id; "" if no lane is near
  std::optional<bool> on_road;  ///< empty if the map has no drivable area
};

/// s; longer times to collision are not reported.
inline constexpr double kTtcHorizon = 10.0;

/// Returns the measures at every step of a rollout of `scenario`, which must have its motions.
std::vector<StepMetrics> stepMetrics(const CrashScenario& scenario, const PlannerRow& row);

/// Returns the CSV file of all rollouts of a case, a row per rollout and step; the header alone for
/// an untested case.
std::string stepsCsv(const PlannerCase& one, const PlannerTestResult& result);

}  // namespace forge
