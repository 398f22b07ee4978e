#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Measures of one step of a rollout: the columns of steps/N.csv that docs/planners.md defines.
struct StepMetrics {
  TrajectoryPoint point;  ///< middle of the ego's box, global map frame; time on the scene clock
  std::optional<double> jerk;  ///< m/s3, change of the acceleration along the heading since the
                               ///< previous step; this and the next are empty in the first step
  std::optional<double> lateral_acceleration;  ///< m/s2, speed times yaw rate since the previous
                                               ///< step, positive to the left
  std::optional<double> attacker_gap;  ///< m between the boxes of ego and attacker, 0 if they
                                       ///< touch; empty if the attacker is not in sight
  std::optional<double> attacker_ttc;  ///< s until ego and attacker touch at constant velocities;
                                       ///< empty if there is no contact within kTtcHorizon
  std::string nearest;  ///< id of the agent with the smallest gap, the attacker included; "" if
                        ///< there is none
  /// m between the boxes of the ego and that agent; empty if there is none.
  std::optional<double> nearest_gap;
  /// Lane::id of the nearest lane whose centreline is within half kLaneWidth of the ego's middle
  /// and 45 degrees of its heading; "" if there is none.
  std::string lane;
  /// The whole box is on the drivable area; empty if the map has none.
  std::optional<bool> on_road;
};

/// s; longer times to collision are not reported.
inline constexpr double kTtcHorizon = 10.0;

/// Returns the measures at every point of `row.outcome.driven`, in order. `row`: a rollout of
/// `scenario` with its motions; without them the result is empty.
std::vector<StepMetrics> stepMetrics(const CrashScenario& scenario, const PlannerRow& row);

/// Returns the CSV file of all rollouts of a case, with a header (columns: docs/planners.md) and a
/// row per rollout and step, in the order of `result.rows`; times relative to t0. `result`: of the
/// case `one`, with motions; an untested case gives the header alone.
std::string stepsCsv(const PlannerCase& one, const PlannerTestResult& result);

}  // namespace forge
