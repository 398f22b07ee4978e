#pragma once

#include <functional>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/attack/search/realizer.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/ros/nodes/service_caller.h"

/// Search stages in other nodes, of this package or a user's, in any language.
namespace forge {

/// Predicts by the service predict_pattern. Thread-safe if `on_prediction` is.
class PatternPredictorService : public PatternPredictor {
 public:
  /// Called with each prediction that has a future, in the thread of predict(). Not empty.
  using OnPrediction = std::function<void(const PatternPrediction&)>;

  /// `caller`: of predict_pattern; `caller` and `limits` must outlive the object.
  PatternPredictorService(ServiceCaller& caller, const InputLimits& limits,
                          OnPrediction on_prediction)
      : caller_(caller), limits_(limits), on_prediction_(std::move(on_prediction)) {}

  /// Returns patterns, future and status of the service; if the status is not kOk, the service may
  /// return no future, and then patterns and future are empty. `recorded`: the recorded future,
  /// sent to the service; null: none, as in history mode. Status kNodeUnavailable: no response.
  /// `lanes` is not sent: the service's node has its own map. Throws MessageError as fromMessage()
  /// and InputError as checkFuture() and checkPattern() for an invalid response.
  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request, const Future* recorded) const override;

 private:
  ServiceCaller& caller_;
  const InputLimits& limits_;
  OnPrediction on_prediction_;
};

/// Realises patterns by the service realize_trajectory and verifies the attack with AttackJudge.
/// Uses the attacker's id and points, the pattern, the effort and the ego pose at contact of the
/// response; class and size of the attacker are those in the scene. Thread-safe.
class TrajectoryRealizerService : public TrajectoryRealizer {
 public:
  /// `caller`: of realize_trajectory. All arguments must outlive the object.
  TrajectoryRealizerService(ServiceCaller& caller, const InputLimits& limits,
                            const AttackOptions& options)
      : caller_(caller), limits_(limits), options_(options) {}

  /// Returns the verified attack; a rejection with the status of the service (kNodeUnavailable: no
  /// response), or with the reason for which AttackJudge does not accept its attack. Throws
  /// MessageError and InputError for an invalid response, such as an attacker that is not in the
  /// scene or a negative effort.
  Attack realize(const RealizationTask& task) const override;

 private:
  ServiceCaller& caller_;
  const InputLimits& limits_;
  const AttackOptions& options_;
};

}  // namespace forge
