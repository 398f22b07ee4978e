#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/LaneMap.h>

#include "collision_forge/ros/markers/markers.h"
#include "collision_forge/ros/markers/scene_update.h"

/// 3D scenes for Foxglove and Lichtblick, with frame and stamp of the message's header. Positions
/// are in that frame (map). All boxes stand at height 0. Non-finite objects and objects without
/// extent are skipped.
namespace forge {

/// Returns the entities "drivable_area" (its edges), "lanes" and "connectors" (centrelines) as
/// lines.
SceneUpdate mapScene(const collision_forge::LaneMap& map);

/// Returns labelled boxes of ego, attacker and other agents of the frame `agents`; `view.attacker`
/// must point into it or be null. With `view.attack` also the attacker's path, the contact, and the
/// countdown or, from the contact on, the result of the attack's report as text.
SceneUpdate crashScene(const CrashView& view, const collision_forge::AgentArray& agents);

}  // namespace forge
