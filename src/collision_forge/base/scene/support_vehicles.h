#pragma once

#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

/// Support vehicles become agents of a scene here and nowhere else. A support whose id an agent has
/// replaces the agent from the support's first point on.
namespace forge {

/// Returns the support as an agent: the states before its first point (its past, or for a support
/// that was not added the states of `recorded`), then its points. If it stands at its last point,
/// states every kFrameInterval follow, the last one at `end` (s, scene clock); none if `end` is not
/// later. Points after `end` are kept. `recorded`: the recorded agent with its id, or null. The
/// support must have points.
Track trackOf(const SupportVehicle& support, const Track* recorded, double end);

/// Adds the supports with states, interpolated (stateAt()), at the times of the ego's states. A
/// support without a state at any of them is not added.
void addSupports(const std::vector<SupportVehicle>& supports, Snapshot& snapshot);
/// Adds the supports from the ego's first state on. A support that stands at its last point stays
/// until the ego's last state. Does nothing if the ego has no states.
void addSupports(const std::vector<SupportVehicle>& supports, Future& future);
/// Adds the supports with their past. A support that stands at its last point stays until the ego's
/// last state. Does nothing if the ego has no states.
void addSupports(const std::vector<SupportVehicle>& supports, Scene& scene);

}  // namespace forge
