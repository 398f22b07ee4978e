#pragma once

#include <Eigen/Core>
#include <optional>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

inline constexpr int kRequestFeatures = 8;     ///< type one-hot (none: zeros), three of the TTA
inline constexpr int kCandidateFeatures = 24;  ///< of a vehicle that may attack

Eigen::VectorXf requestFeatures(std::optional<CollisionType> type, double tta);

/// A vehicle now, in the frame of the ego now.
struct CandidateNow {
  Pose2 pose;
  double speed = 0.0;  ///< m/s along the heading
};
CandidateNow candidateNow(const Track& observed, const Pose2& ego_now);

/// What tells whether a vehicle can be at the ego's pose at impact (in the frame of the ego now).
/// The vehicle's history has no say.
Eigen::VectorXf candidateFeatures(const CandidateNow& candidate, double ego_speed,
                                  const Pose2& ego_at_impact, double tta, CollisionType type);

}  // namespace forge
