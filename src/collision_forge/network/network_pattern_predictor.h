#pragma once

#include <memory>
#include <string>

#include "collision_forge/attack/options.h"
#include "collision_forge/attack/pattern_predictor.h"
#include "collision_forge/network/pattern_network.h"

namespace forge {

/// The network's ranking of the candidates, and as each one's first pattern the network's offset at
/// the ego's most central pose at impact (in replay mode the recorded one), in place of the pattern
/// that it comes nearest to. Who is a candidate, the other patterns and the motion that they assume
/// are KinematicPatternPredictor's.
class NetworkPatternPredictor : public PatternPredictor {
 public:
  /// Without networks (null) it is a KinematicPatternPredictor. A scene on test is judged by the
  /// network that was trained without `left_out_scene`. The ego's place is told without the type,
  /// unless it is known (Foresight::known_type).
  NetworkPatternPredictor(const AttackOptions& options,
                          std::shared_ptr<const EgoFutureSampler> ego_futures,
                          std::shared_ptr<const PatternNetworks> networks,
                          std::string left_out_scene = "",
                          std::optional<CollisionType> known_type = std::nullopt);

  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request, const Future* recorded) const override;

 private:
  AttackOptions options_;
  KinematicPatternPredictor kinematic_;
  std::shared_ptr<const PatternNetworks> networks_;
  std::string left_out_scene_;
  std::optional<CollisionType> known_type_;
};

}  // namespace forge
