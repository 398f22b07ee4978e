#pragma once

#include <string>
#include <vector>

#include "collision_forge/attack/drivers/driver_models.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Drives each of kDriverModels through an attack in the ego's place, and returns one result per
/// model in this order: whether it avoids the attack and when it begins to brake.
///
/// A driver follows `future.ego` (after its last state straight on at its last speed) in steps of
/// 0.05 s until its model reacts to the attacker. From then on it stays on the same path, brakes as
/// the model says and at least as hard as `future.ego` at that time. Attacker and other agents
/// drive as given, until the end of the attacker's trajectory; an agent counts only while its track
/// has states. Avoided: no contact with the attacker, and none with another agent except one that
/// runs into the ego's rear, as given traffic does not react, or overlaps the ego at the first
/// point. `future.ego` must have states and `attacker` points; the drive starts at the time of the
/// first point.
std::vector<CarefulDrive> driveCarefully(const Future& future, const AttackerTrajectory& attacker,
                                         const DriverOptions& options = {});

/// Returns true if `drives` has a drive of this model that avoids the attack; false, too, if it has
/// no drive of this model.
bool isAvoidedBy(const std::vector<CarefulDrive>& drives, DriverModel model);

/// Returns the names of the drivers that avoid the attack, in the order of `drives`, joined by
/// `separator`; "" if there is none.
std::string avoiders(const std::vector<CarefulDrive>& drives, const char* separator);

}  // namespace forge
