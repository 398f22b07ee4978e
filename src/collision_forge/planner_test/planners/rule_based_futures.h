#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/box_circles.h"
#include "collision_forge/planner_test/planners/lane_splines.h"
#include "collision_forge/planner_test/planners/rule_based_options.h"
#include "collision_forge/planner_test/planners/speed_plan.h"

namespace forge {

/// A moving box: the ego or another agent.
struct DrivenBox {
  Pose2 pose;          ///< at t0, middle of the box, global map frame
  double speed = 0.0;  ///< m/s along the heading, negative backwards
  BoxSize size;        ///< m
};

/// Another agent's box along one of its predicted futures.
struct ExpectedBox {
  BoxCircles circles;                 ///< of the agent's box
  std::vector<PlacedCircles> places;  ///< one per step, the first at t0, of the circles' centres
};

/// Returns the predicted speed plans of another agent: one for each combination of
/// `options.speed_shares` (outer loop; target speed as a share of `speed`, m/s) and
/// `options.acceleration_shares` (of the maximum acceleration).
std::vector<SpeedPlan> expectedSpeeds(double speed, const RuleBasedOptions& options);

/// Returns the greatest distances ahead and behind that any plan drives at any step, neither
/// negative; 0 without plans.
Reach reachOf(const std::vector<SpeedPlan>& plans);

/// Predicts another agent's boxes at every step: one future for each path (outer loop) and speed
/// plan.
std::vector<ExpectedBox> expectedBoxes(const DrivenBox& other,
                                       const std::vector<LaneSpline>& splines,
                                       const std::vector<SpeedPlan>& plans);

/// As above, with the agent's candidate paths on a lane graph and its expectedSpeeds().
std::vector<ExpectedBox> expectedBoxes(const DrivenBox& other, const LaneGraph& graph,
                                       const RuleBasedOptions& options);

/// Returns the circles of a box that follows a path with a speed plan, one set per element of
/// plan.distances.
std::vector<PlacedCircles> placesAlong(const BoxCircles& circles, const LaneSpline& spline,
                                       const SpeedPlan& plan);

}  // namespace forge
