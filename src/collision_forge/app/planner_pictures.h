#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/scenario_view.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/planner_result.h"

/// Pictures (PNG and GIF) of planner tests. `one`: the case; `row`: the result of a planner in it,
/// with its motions (KeptDrives::rowOf()).
namespace forge {

/// Returns the view of a collision in a planner test: ego, attacker and other agents as driven up
/// to the contact (other agents that did not react: as recorded), then the post-crash motion of ego
/// and attacker. `row.outcome` must have a contact with the attacker. `config`: severity options,
/// and the time that the view lasts after the standstill.
ScenarioView viewOfCollision(const PlannerCase& one, const PlannerRow& row, const Config& config);

/// Returns the view of the evasive manoeuvre that would have avoided the collision, with the
/// attacker's reaction to it; the ego drives as in the test until the manoeuvre begins. The contact
/// of `row.outcome` and `row.evasion_drive` must be set.
ScenarioView viewOfEvasiveManoeuvre(const PlannerCase& one, const PlannerRow& row);

/// Writes PATH.png and PATH.gif; `path`: without an ending, in an existing folder. Throws as
/// drawScenarioPng() and drawScenarioGif().
void drawView(const std::string& path, const ScenarioView& view, const DrawingOptions& drawing);

}  // namespace forge
