#pragma once

#include "collision_forge/attack/pattern_predictor.h"
#include "collision_forge/attack/realizer.h"

namespace forge {

/// The whole road in one process: check the request, predict patterns, realise and verify the
/// attack. `recorded` is the recorded future; it is looked at in replay mode only, and may be null.
Realization generateCollision(const CollisionRequest& request, const Snapshot& snapshot,
                              const LaneIndex& lanes, const Future* recorded,
                              const PatternPredictor& predictor, const AttackOptions& options);

}  // namespace forge
