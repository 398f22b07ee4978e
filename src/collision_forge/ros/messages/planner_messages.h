#pragma once

#include <collision_forge/PlannedTrajectory.h>
#include <collision_forge/PlannerOutcome.h>
#include <collision_forge/PlanningState.h>

#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/trials/planner_trial.h"
#include "collision_forge/ros/messages/conversions.h"

/// Message conversions for planner tests.
namespace forge {

/// Returns the input of an external planner (PlanningState.msg); its stamp is the time of the call,
/// that is of the observed ego. `observation` gives ego, agents and red lanes, `task` ego size,
/// wheelbase and the poses along the route. `test`: number of the test, which the planner copies
/// into its response; `interval`: s to the next call of the planner.
collision_forge::PlanningState toMessage(const Observation& observation, const DrivingTask& task,
                                         std::uint32_t test, double interval);

/// Returns the planned points (middle of the ego's box, map frame) in the order of the message,
/// unchecked, NaN included; checkPlan() checks them. Throws MessageError for a frame other than
/// `map` and for an orientation of all zeros.
std::vector<TrajectoryPoint> fromMessage(const collision_forge::PlannedTrajectory& message);

/// Returns the result of a planner test for the topic planner_outcome, in frame `map` with t0 as
/// stamp; fields that PlannerOutcome.msg marks as valid only if collided or avoidable are else 0 or
/// empty. `planner`: name of the planner; `policy`: of the attacker. `trial.outcome.driven` must
/// not be empty.
collision_forge::PlannerOutcome toMessage(const PlannerTrial& trial, const std::string& planner,
                                          PolicyKind policy);

}  // namespace forge
