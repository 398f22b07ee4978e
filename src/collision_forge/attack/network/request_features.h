#pragma once

#include <Eigen/Core>
#include <optional>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

inline constexpr int kRequestFeatures = 8;     ///< size of requestFeatures()
inline constexpr int kCandidateFeatures = 24;  ///< size of candidateFeatures()

/// Returns the network input of a request, kRequestFeatures numbers: the type one-hot in the order
/// of kCollisionTypes (zeros without a type), then `tta` (s, positive) scaled to 0 at 0.5 s and 1
/// at 9 s, a third of its square root, and 1 / (1 + tta).
Eigen::VectorXf requestFeatures(std::optional<CollisionType> type, double tta);

/// A candidate attacker at t0, in the frame of the ego's box at t0.
struct CandidateNow {
  Pose2 pose;          ///< box centre
  double speed = 0.0;  ///< m/s along the heading
};
/// Returns the newest state of `observed`, a track of observedSnapshot(), which must have states.
/// `ego_now`: the ego's box centre at t0, map frame.
CandidateNow candidateNow(const Track& observed, const Pose2& ego_now);

/// Returns the network input of a candidate, kCandidateFeatures numbers scaled to order one:
/// pose, its speed and the ego's, pose relative to the ego's pose at impact (`ego_at_impact`, ego
/// frame at t0), the place reached straight on in `tta` s (positive) relative to it and the log of
/// its distance, the mean speed needed to reach it, that speed minus the candidate's, the
/// acceleration and bearing needed, `tta`, and the type one-hot in the order of
/// kCollisionTypes. `ego_speed` in m/s at t0, along the ego's heading. Uses no history.
Eigen::VectorXf candidateFeatures(const CandidateNow& candidate, double ego_speed,
                                  const Pose2& ego_at_impact, double tta, CollisionType type);

}  // namespace forge
