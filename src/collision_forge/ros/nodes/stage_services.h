#pragma once

#include <functional>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/attack/search/realizer.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/ros/nodes/service_caller.h"

/// The stages of the search in other nodes, of this package or of others, in any language.
namespace forge {

/// Asks the service predict_pattern.
class PatternPredictorService : public PatternPredictor {
 public:
  /// Called with each prediction, in the thread that asked for it.
  using OnPrediction = std::function<void(const PatternPrediction&)>;

  /// `caller` and `limits` must outlive it.
  PatternPredictorService(ServiceCaller& caller, const InputLimits& limits,
                          OnPrediction on_prediction)
      : caller_(caller), limits_(limits), on_prediction_(std::move(on_prediction)) {}

  /// The future is empty where the service declines without one. Declines with kNodeUnavailable
  /// where the service does not answer. Throws MessageError and InputError for an unusable answer.
  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request, const Future* recorded) const override;

 private:
  ServiceCaller& caller_;
  const InputLimits& limits_;
  OnPrediction on_prediction_;
};

/// Asks the service realize_trajectory, and judges its attack (AttackJudge) as any other. The class
/// takes the trajectory, the pattern, the effort and the place of the contact from the answer.
class TrajectoryRealizerService : public TrajectoryRealizer {
 public:
  /// All must outlive it.
  TrajectoryRealizerService(ServiceCaller& caller, const InputLimits& limits,
                            const AttackOptions& options)
      : caller_(caller), limits_(limits), options_(options) {}

  /// Declines with kNodeUnavailable where the service does not answer. Throws MessageError and
  /// InputError for an unusable answer.
  Attack realize(const RealizationTask& task) const override;

 private:
  ServiceCaller& caller_;
  const InputLimits& limits_;
  const AttackOptions& options_;
};

}  // namespace forge
