#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/network/anchor_features.h"
#include "collision_forge/attack/network/request_features.h"
#include "collision_forge/attack/network/scene_features.h"

namespace forge {

/// Where the ego stood some time after now, in the frame of the ego now.
struct TimedSample {
  double tta = 0.0;  ///< s
  AnchorFeatures anchors;
  Pose2 ego;
};

/// Who attacked, and from where; only of clips.
struct AttackSample {
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;  ///< s
  Pose2 ego;         ///< at impact, in the frame of the ego now
  std::vector<CandidateNow> candidates;
  std::size_t attacker = 0;  ///< among the candidates
  Pose2 offset;              ///< of the attacker's box in the ego box's frame at impact
};

/// A moment of a recording. With an attack the last of `times` is the impact, and the histories of
/// all others are hidden (that of a clip's attacker would give it away).
struct TrainingSample {
  std::string scene;
  SceneFeatures features;
  double ego_speed = 0.0;  ///< m/s
  std::vector<TimedSample> times;
  std::optional<AttackSample> attack;
};

}  // namespace forge
