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
  double tta = 0.0;        ///< s after t0
  AnchorFeatures anchors;  ///< anchorFeatures() for `tta`
  Pose2 ego;               ///< box centre, m and rad, in the frame of the ego's box at t0
};

/// The attack of a clip.
struct AttackSample {
  CollisionType type = CollisionType::kRearEnd;  ///< type in the clip's file name
  double tta = 0.0;                              ///< s from t0 to the impact
  Pose2 ego;  ///< box centre at impact, in the frame of the ego's box at t0
  std::vector<CandidateNow> candidates;  ///< vehicles that may be the attacker, isCandidate()
  std::size_t attacker = 0;              ///< index of the true attacker in `candidates`
  Pose2 offset;  ///< pose of the attacker's box in the frame of the ego's box at impact
};

/// A training sample: a moment t0 of a recording. With an attack, the last of `times` is the
/// impact, and training hides the histories of other agents, because the history of a clip's
/// attacker reveals its future.
struct TrainingSample {
  std::string scene;       ///< name of the scene
  SceneFeatures features;  ///< sceneFeatures() at t0
  double ego_speed = 0.0;  ///< m/s at t0
  /// At least one; for logs ascending (equal ones possible), for clips random with the impact last.
  std::vector<TimedSample> times;
  /// Empty for logs, and for clips whose attacker is no candidate.
  std::optional<AttackSample> attack;
};

}  // namespace forge
