#pragma once

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// The scene and the request against which a trajectory is verified. Holds references: the
/// referenced objects must outlive it.
struct VerificationInput {
  const Snapshot& snapshot;
  const Future& future;  ///< ego and other agents from t0 on; the attacker's own track is ignored
  const CollisionRequest& request;
  const LaneIndex& lanes;
};

}  // namespace forge
