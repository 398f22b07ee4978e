#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/LaneMap.h>

#include "collision_forge/ros/markers/markers.h"
#include "collision_forge/ros/markers/scene_update.h"

/// What Foxglove and Lichtblick show in 3D. Frame and stamp are those of the message's header;
/// everybody stands on the ground. What is not finite or has no extent is left out.
namespace forge {

/// Lanes and connectors as their centrelines, and the edges of the drivable area.
SceneUpdate mapScene(const collision_forge::LaneMap& map);

/// Boxes with labels: the ego, the agents of the frame, and the one of them that attacks. With an
/// attack also its way, its contact and, in words, the countdown or what the report says.
SceneUpdate crashScene(const CrashView& view, const collision_forge::AgentArray& agents);

}  // namespace forge
