#pragma once

#include <memory>
#include <vector>

#include "collision_forge/attack/forecast/ego_futures.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

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

/// From the snapshot's now to `horizon` seconds later: `samples` equally likely futures of the ego,
/// the most central of them `central` seconds from now as the likeliest, and all others as
/// predictFuture() says. The same arguments give the same future.
Future foreseenFuture(const Snapshot& snapshot, const LaneIndex& lanes,
                      const EgoFutureSampler& ego_futures, double horizon, double central,
                      int samples, std::uint64_t seed);

/// No learning: the ego moves as the sampler says, all others as predictFuture() says (or everybody
/// as recorded), and each candidate attacker is placed at the ego's pose at impact with the type's
/// nominal heading. Declines with kRoadDoesNotAllow where that is asked for (roadAllows()).
class KinematicPatternPredictor : public PatternPredictor {
 public:
  KinematicPatternPredictor(const AttackOptions& options,
                            std::shared_ptr<const EgoFutureSampler> ego_futures);

  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request, const Future* recorded) const override;

 private:
  PredictionOptions options_;
  BelievabilityOptions believability_;
  std::shared_ptr<const EgoFutureSampler> ego_futures_;
};

}  // namespace forge
