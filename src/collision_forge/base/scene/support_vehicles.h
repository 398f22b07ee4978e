#pragma once

#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

/// Support vehicles become agents of a scene here and nowhere else. A support whose id an agent has
/// replaces the agent from the support's first point on.
namespace forge {

/// Returns the agent that a support is, up to `end` (s, scene clock) if it stands at its last
/// point: its past, then its points. `recorded`: the agent with its id, or null.
Track trackOf(const SupportVehicle& support, const Track* recorded, double end);

/// Adds the supports at the times of the ego's states.
void addSupports(const std::vector<SupportVehicle>& supports, Snapshot& snapshot);
/// Adds the supports from the ego's first state to its last.
void addSupports(const std::vector<SupportVehicle>& supports, Future& future);
/// Adds the supports to the end of the recording.
void addSupports(const std::vector<SupportVehicle>& supports, Scene& scene);

}  // namespace forge
