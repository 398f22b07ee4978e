#pragma once

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// The scene and the request against which a trajectory is verified. Holds references: the
/// referenced objects must outlive it.
struct VerificationInput {
  /// Its t0 and the attacker's track up to t0, from which the trajectory must continue, are used.
  /// An attacker without a track there (an added vehicle) continues from its first point.
  const Snapshot& snapshot;
  /// ego and other agents from t0 on, predicted or recorded; the attacker's own track is ignored
  const Future& future;
  const CollisionRequest& request;  ///< with its crash definition
  const LaneIndex& lanes;
};

}  // namespace forge
