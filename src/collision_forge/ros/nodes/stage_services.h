#pragma once

#include <functional>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/attack/search/realizer.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/ros/nodes/service_caller.h"

/// Predictor and realizer of the default method as ROS services. A node of another package, in any
/// language, may serve them in place of pattern_predictor and trajectory_realizer.
namespace forge {

/// Calls the service predict_pattern, once per request.
class PatternPredictorService : public PatternPredictor {
 public:
  /// Called with each prediction, in the thread that called predict().
  using OnPrediction = std::function<void(const PatternPrediction&)>;

  /// `caller` and `limits` must outlive the object.
  PatternPredictorService(ServiceCaller& caller, const InputLimits& limits,
                          OnPrediction on_prediction)
      : caller_(caller), limits_(limits), on_prediction_(std::move(on_prediction)) {}

  /// Returns the service's patterns and predicted ego future (may be empty on rejection). Rejects
  /// with kNodeUnavailable if the service does not respond. Throws MessageError and InputError if
  /// the response is malformed or exceeds the input limits.
  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request, const Future* recorded) const override;

 private:
  ServiceCaller& caller_;
  const InputLimits& limits_;
  OnPrediction on_prediction_;
};

/// Calls the service realize_trajectory. Uses trajectory, pattern and effort of the response, and
/// verifies the attack itself (AttackJudge). The report in the response only determines which
/// predicted ego is tried first.
class TrajectoryRealizerService : public TrajectoryRealizer {
 public:
  /// All arguments must outlive the object.
  TrajectoryRealizerService(ServiceCaller& caller, const InputLimits& limits,
                            const AttackOptions& options)
      : caller_(caller), limits_(limits), options_(options) {}

  /// Calls the service once and returns the verified attack, or a rejection; kNodeUnavailable if
  /// the service does not respond. Throws MessageError and InputError if the response is malformed,
  /// exceeds the input limits or names an attacker that is not in the scene.
  Realization realize(const RealizationTask& task) const override;

 private:
  ServiceCaller& caller_;
  const InputLimits& limits_;
  const AttackOptions& options_;
};

}  // namespace forge
