#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/LaneMap.h>

#include "collision_forge/ros/markers/markers.h"
#include "collision_forge/ros/markers/scene_update.h"

/// 3D scenes for Foxglove and Lichtblick, with frame and stamp of the message's header. Positions
/// are in that frame (map). All boxes stand at height 0. Non-finite objects and objects without
/// extent are skipped. Colours: ros/markers/marker_colors.h.
namespace forge {

/// Returns the entities "drivable_area" (the edges of its polygons), "lanes" and "connectors"
/// (centrelines) as lines; an entity whose part of the map is empty has no lines. Throws
/// MessageError for an unknown kind of map feature.
SceneUpdate mapScene(const collision_forge::LaneMap& map);

/// Returns the boxes of the ego (entity kEgoId, none if `view.ego` is empty) and of the agents of
/// the frame `agents` (entities "agent ID"), with labels except on static objects. `view.attacker`
/// must point into `agents` or be null (then no box is the attacker's). If `view.attack` is not
/// null, also the entity "attack": the attacker's path up to the contact of the attack's report
/// (without a contact to the end), both boxes at the contact, and at the end of the path the
/// countdown or, from the contact on, the result of this report as text.
SceneUpdate crashScene(const CrashView& view, const collision_forge::AgentArray& agents);

}  // namespace forge
