#pragma once

#include <memory>
#include <vector>

#include "collision_forge/attack/forecast/ego_futures.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Predicted collision patterns and the future that they assume.
struct PatternPrediction {
  Status status;                           ///< kOk, or why there are no patterns
  std::vector<CollisionPattern> patterns;  ///< most promising first
  /// ego and other agents from t0 to after the impact; without ego states if the predictor failed
  Future future;
};

/// Interface: predicts collision patterns, the first stage of SearchMethod. Extension point (also
/// as ROS service predict_pattern). Implementations must be immutable: one object is used from many
/// threads at once.
class PatternPredictor {
 public:
  virtual ~PatternPredictor() = default;

  /// Returns patterns and future, or a status other than kOk with the reason; SearchMethod stops if
  /// `future.ego` then has no states. Called once per request, on the caller's thread. `request`
  /// has passed checkRequest(); `recorded` is the recorded future in replay mode, else null. Must
  /// be deterministic in its arguments, including request.seed, and must use nothing after t0
  /// except `recorded`. May throw InputError; patterns must name agents of the snapshot and times
  /// after t0 (scene clock).
  virtual PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                                    const CollisionRequest& request,
                                    const Future* recorded) const = 0;
};

/// Predicts from t0 to t0 + `horizon` (s): `samples` equally likely futures of the ego
/// (Future::ego_samples), as Future::ego the sample whose position `central_time` s after t0 is
/// nearest to their mean, and other agents by predictFuture(). Without samples (`samples` is 0),
/// Future::ego is the prediction of predictFuture(). Deterministic in its arguments. Throws as
/// EgoFutureSampler::sample().
Future predictWithEgoSamples(const Snapshot& snapshot, const LaneIndex& lanes,
                             const EgoFutureSampler& ego_futures, double horizon,
                             double central_time, int samples, std::uint64_t seed);

/// Predicts without learning: places each candidate attacker at the ego's predicted (in replay
/// mode: recorded) pose at impact, with the type's nominal heading, on each side of placementsOf().
/// The predicted impact speed is the ego's plus 4 m/s for rear_end, else the attacker's at t0, at
/// least 3 m/s. The ego moves as `ego_futures` samples it, other agents as predictFuture().
/// Patterns are sorted by the difference between the mean speed that the attacker needs to the
/// impact and the mean of its speeds at t0 and at impact, smallest first. Returns kRoadDoesNotAllow
/// if the request requires plausibility and roadAllows() is false, kBeyondRecording if the
/// recording ends before the contact, kNoCandidate if no vehicle qualifies.
class KinematicPatternPredictor : public PatternPredictor {
 public:
  /// `ego_futures` must not be null.
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
