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

/// conversions.h for tests of planners.
namespace forge {

/// The planner that is a node of its own.
inline constexpr char kExternalPlanner[] = "external";

/// What `planner` of TestPlanner.srv may be: plannerNames() and kExternalPlanner.
std::vector<std::string> testablePlanners();

/// What an external planner is told; `test` and `interval` as in the message.
collision_forge::PlanningState toMessage(const Observation& observation, const DrivingTask& task,
                                         std::uint32_t test, double interval);

/// The planned points as they are, numbers that are none among them. Throws MessageError for a
/// frame that is not `map`, and for an orientation that was not filled in.
std::vector<TrajectoryPoint> fromMessage(const collision_forge::PlannedTrajectory& message);

collision_forge::PlannerOutcome toMessage(const PlannerTrial& trial, const std::string& planner,
                                          PolicyKind policy);

}  // namespace forge
