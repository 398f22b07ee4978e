#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "collision_forge/planner_test/trials/planner_trial.h"
#include "collision_forge/ros/markers/shown_area.h"

namespace forge {

/// The ways of a planner's test, which stand still: the ego as the planner drove it beside the
/// recorded one and the attacker, up to the end of the test, and the proposals of the planner's
/// last call. Starts with DELETEALL. Colours: ros/markers/marker_colors.h.
visualization_msgs::MarkerArray plannerMarkers(const PlannerTrial& trial,
                                               const CrashScenario& scenario);

/// One instant of the rollout: the boxes of the ego as the planner drove it, of the attacker and of
/// all other agents, and in words the time since the test's now. From the end of the rollout on all
/// stand as they stood then, with the contact, and the words are the outcome. `time` is in seconds
/// on the scenario's clock. Starts with DELETEALL.
visualization_msgs::MarkerArray rolloutMarkers(const PlannerTrial& trial,
                                               const CrashScenario& scenario,
                                               const std::string& planner, double time);

/// Returns the part of the map that holds the ego and the attacker at `time`, and where the ego
/// ends.
ShownArea rolloutArea(const PlannerTrial& trial, const CrashScenario& scenario, double time);

}  // namespace forge
