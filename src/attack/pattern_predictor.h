#pragma once

#include <vector>

#include "attack/attack.h"
#include "attack/options.h"
#include "map/lane_queries.h"
#include "scene/scene.h"

namespace forge {

/// Where ego and attackers may stand at impact, and the motion that this assumes.
struct PatternPrediction {
  Status status;                           ///< kOk, or why there are no patterns
  std::vector<CollisionPattern> patterns;  ///< most promising first
  Future future;                           ///< from now to past the impact
};

/// Predicts collision patterns. Implementations are immutable and may be used from many threads.
class PatternPredictor {
 public:
  virtual ~PatternPredictor() = default;

  /// `recorded` is the recorded future in replay mode and null in history mode. The request has
  /// been passed checkRequest().
  virtual PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                                    const CollisionRequest& request,
                                    const Future* recorded) const = 0;
};

/// No learning: everybody moves as predictFuture() says (or as recorded), and each candidate
/// attacker is placed at the ego's pose at impact with the type's nominal heading.
class KinematicPatternPredictor : public PatternPredictor {
 public:
  explicit KinematicPatternPredictor(AttackOptions options);

  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request, const Future* recorded) const override;

 private:
  AttackOptions options_;
};

}  // namespace forge
