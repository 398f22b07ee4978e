#include "collision_forge/attack/search_method.h"

#include <utility>

namespace forge {

SearchMethod::SearchMethod(const AttackOptions& options,
                           std::shared_ptr<const PatternPredictor> predictor)
    : options_(options), predictor_(std::move(predictor)) {}

Realization SearchMethod::answer(const Moment& moment, const CollisionRequest& request) const {
  const PatternPrediction prediction = predictor_->predict(
      moment.snapshot, *moment.lanes, request, moment.recorded ? &*moment.recorded : nullptr);
  if (prediction.status.code != StatusCode::kOk) {
    Realization refusal;
    refusal.status = prediction.status;
    return refusal;
  }
  return realize(prediction.patterns, {moment.snapshot, prediction.future, request, *moment.lanes},
                 options_);
}

}  // namespace forge
