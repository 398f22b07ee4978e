#pragma once

#include "collision_forge/attack/network/prediction_models.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"

namespace forge {

/// Ranks the candidate attackers by the network, most probable first. The first pattern of each
/// candidate has the network's relative pose, at the median predicted ego pose at impact (in replay
/// mode: the recorded one, if the recording reaches the impact), and replaces the kinematic pattern
/// nearest to it. Candidates, further patterns and the assumed future come from
/// KinematicPatternPredictor, which alone answers requests of types other than kCollisionTypes; its
/// rejections are returned as they are.
class NetworkPatternPredictor : public PatternPredictor {
 public:
  /// Without a network it predicts as KinematicPatternPredictor. The ego pose is predicted without
  /// the requested type unless PredictionModels::known_type is set.
  NetworkPatternPredictor(const AttackOptions& options, PredictionModels models);

  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request, const Future* recorded) const override;

 private:
  AttackOptions options_;
  PredictionModels models_;
  KinematicPatternPredictor kinematic_;
};

}  // namespace forge
