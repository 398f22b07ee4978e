#pragma once

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Everything that a trajectory is held against.
struct VerificationInput {
  const Snapshot& snapshot;
  const Future& future;  ///< ego and others from now on; the attacker's own track is left out
  const CollisionRequest& request;
  const LaneIndex& lanes;
};

}  // namespace forge
