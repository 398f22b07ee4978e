#pragma once

#include "collision_forge/attack/network/foresight.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"

namespace forge {

/// The network's ranking of the candidates, and as each one's first pattern the network's offset at
/// the ego's most central pose at impact (in replay mode the recorded one), in place of the pattern
/// that it comes nearest to. Who is a candidate, the other patterns and the motion that they assume
/// are KinematicPatternPredictor's.
class NetworkPatternPredictor : public PatternPredictor {
 public:
  /// Without a network it is a KinematicPatternPredictor. The ego's place is told without the type,
  /// unless it is known (Foresight::known_type).
  NetworkPatternPredictor(const AttackOptions& options, Foresight foresight);

  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request, const Future* recorded) const override;

 private:
  AttackOptions options_;
  Foresight foresight_;
  KinematicPatternPredictor kinematic_;
};

}  // namespace forge
