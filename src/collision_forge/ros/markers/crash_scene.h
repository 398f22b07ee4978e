#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/LaneMap.h>

#include "collision_forge/ros/markers/markers.h"
#include "collision_forge/ros/markers/scene_update.h"

/// Scenes for the 3D panel of Foxglove and Lichtblick. Frame and stamp come from the message's
/// header; all boxes stand on the ground. Leaves out shapes that are not finite or have no extent.
namespace forge {

/// Returns the centrelines of lanes and connectors, and the edges of the drivable area.
SceneUpdate mapScene(const collision_forge::LaneMap& map);

/// Returns labelled boxes of the ego and the agents, the attacker marked. With an attack also its
/// path, its contact and a text: the countdown or the outcome in the report.
SceneUpdate crashScene(const CrashView& view, const collision_forge::AgentArray& agents);

}  // namespace forge
