#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/box_circles.h"
#include "collision_forge/planner_test/planners/lane_splines.h"
#include "collision_forge/planner_test/planners/rule_based_options.h"
#include "collision_forge/planner_test/planners/speed_plan.h"

namespace forge {

/// A box that drives: the ego, or somebody as the planner expects it.
struct DrivenBox {
  Pose2 pose;          ///< now, middle of the box
  double speed = 0.0;  ///< m/s along the heading, negative backwards
  BoxSize size;
};

/// Somebody's box on one of its futures.
struct ExpectedBox {
  BoxCircles circles;
  std::vector<PlacedCircles> places;  ///< one a step, the first now
};

/// The speeds that somebody else may take on: each of the shares of its speed by each of the shares
/// of the greatest acceleration.
std::vector<SpeedPlan> expectedSpeeds(double speed, const RuleBasedOptions& options);

/// How far speed plans lead along a way.
Reach reachOf(const std::vector<SpeedPlan>& plans);

/// Where somebody else may be step by step: along each of its ways at each of the speeds.
std::vector<ExpectedBox> expectedBoxes(const DrivenBox& other,
                                       const std::vector<LaneSpline>& splines,
                                       const std::vector<SpeedPlan>& plans);

/// The same on a lane graph.
std::vector<ExpectedBox> expectedBoxes(const DrivenBox& other, const LaneGraph& graph,
                                       const RuleBasedOptions& options);

/// The circles of a box that drives a way at the speeds of a plan, one a step.
std::vector<PlacedCircles> placesAlong(const BoxCircles& circles, const LaneSpline& spline,
                                       const SpeedPlan& plan);

}  // namespace forge
