#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/network/anchor_features.h"
#include "collision_forge/attack/network/request_features.h"
#include "collision_forge/attack/network/scene_features.h"

namespace forge {

/// The recorded ego pose some time after t0, with the features to predict it.
struct TimedSample {
  double tta = 0.0;  ///< s after t0
  AnchorFeatures anchors;
  Pose2 ego;  ///< m, rad, in the frame of the ego at t0
};

/// The attack of a clip.
struct AttackSample {
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;  ///< s
  Pose2 ego;         ///< at impact, in the frame of the ego at t0
  std::vector<CandidateNow> candidates;
  std::size_t attacker = 0;  ///< index of the attacker among the candidates
  Pose2 offset;              ///< pose of the attacker's box in the frame of the ego's box at impact
};

/// A training sample: a moment t0 of a recording. With an attack, the last of `times` is the
/// impact, and training hides the histories of other agents, because the history of a clip's
/// attacker reveals its future.
struct TrainingSample {
  std::string scene;  ///< name
  SceneFeatures features;
  double ego_speed = 0.0;  ///< m/s at t0
  std::vector<TimedSample> times;
  std::optional<AttackSample> attack;
};

}  // namespace forge
