#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "collision_forge/trials/planner_trial.h"

namespace forge {

/// A planner's test as RViz shows it: the ego as the planner drove it beside the recorded one and
/// the attacker, up to the end of the test; the others there; the proposals of the last call; the
/// contact, and the outcome in words. Starts with DELETEALL. Colours: ros/marker_colors.h.
visualization_msgs::MarkerArray plannerMarkers(const PlannerTrial& trial,
                                               const CrashScenario& scenario,
                                               const std::string& planner);

}  // namespace forge
