#include "collision_forge/attack/generator.h"

#include "collision_forge/attack/request_check.h"

namespace forge {

Realization generateCollision(const CollisionRequest& request, const Snapshot& snapshot,
                              const LaneIndex& lanes, const Future* recorded,
                              const PatternPredictor& predictor, const AttackOptions& options) {
  Realization realization;
  realization.status = checkRequest(request, snapshot, options.prediction);
  if (realization.status.code != StatusCode::kOk) return realization;
  if (request.mode == Mode::kReplay && !recorded) {
    realization.status = {StatusCode::kNoRecording, "mode = replay needs a recording"};
    return realization;
  }
  const Future* known = request.mode == Mode::kReplay ? recorded : nullptr;
  const PatternPrediction prediction = predictor.predict(snapshot, lanes, request, known);
  if (prediction.status.code != StatusCode::kOk) {
    realization.status = prediction.status;
    return realization;
  }
  return realize(prediction.patterns, {snapshot, prediction.future, request, lanes}, options);
}

}  // namespace forge
