#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/LaneMap.h>

#include "collision_forge/ros/markers/markers.h"
#include "collision_forge/ros/markers/scene_update.h"

/// 3D scenes for Foxglove and Lichtblick, with frame and stamp of the message's header. All boxes
/// stand at height 0. Non-finite objects and objects without extent are skipped.
namespace forge {

/// Returns the centrelines of lanes and connectors, and the edges of the drivable area.
SceneUpdate mapScene(const collision_forge::LaneMap& map);

/// Returns labelled boxes of ego, attacker and other agents of the frame. With an attack also the
/// attacker's path, the contact, and the countdown or the result of the report as text.
SceneUpdate crashScene(const CrashView& view, const collision_forge::AgentArray& agents);

}  // namespace forge
