#pragma once

#include <string>
#include <vector>

#include "collision_forge/drawing/options.h"
#include "collision_forge/drawing/scenario_view.h"
#include "collision_forge/trials/planner_result.h"

/// Pictures of planners under test.
namespace forge {

/// The ego and the attacker as they drove, without a contact.
ScenarioView viewOf(const PlannerCase& one, PolicyKind policy,
                    const std::vector<TrajectoryPoint>& ego, const AttackerTrajectory& attacker);

/// The same with the contact of the outcome, which has one.
ScenarioView viewOf(const PlannerCase& one, PolicyKind policy, const RolloutOutcome& outcome);

/// PATH.png and PATH.gif.
void drawView(const std::string& path, const ScenarioView& view, const DrawingOptions& drawing);

}  // namespace forge
