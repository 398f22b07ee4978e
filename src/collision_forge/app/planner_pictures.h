#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/scenario_view.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/planner_result.h"

/// Pictures of planners under test.
namespace forge {

/// The hit of a planner: the ego and the attacker as they drove up to the contact of the row's
/// outcome, which must be one with the attacker and have its motions, and what follows it.
ScenarioView viewOfHit(const PlannerCase& one, const PlannerRow& row, const Config& config);

/// The escape from that hit, which the row must have: what the ego could have done instead, and the
/// attacker as it reacts to that.
ScenarioView viewOfEscape(const PlannerCase& one, const PlannerRow& row);

/// PATH.png and PATH.gif.
void drawView(const std::string& path, const ScenarioView& view, const DrawingOptions& drawing);

}  // namespace forge
