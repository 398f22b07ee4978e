#include "collision_forge/attack/attack_method.h"

#include "collision_forge/attack/request_check.h"

namespace forge {
namespace {

Realization refused(StatusCode code, const std::string& message) {
  Realization refusal;
  refusal.status = {code, message};
  return refusal;
}

}  // namespace

Realization attempt(const AttackMethod& method, const Moment& moment,
                    const CollisionRequest& request) {
  if (request.mode == Mode::kReplay || !moment.recorded) return method.answer(moment, request);
  return method.answer({moment.snapshot, std::nullopt, moment.lanes}, request);
}

Realization generateCollision(const AttackMethod& method, const Moment& moment,
                              const CollisionRequest& request, const PredictionOptions& options) {
  const Status status = checkRequest(request, moment.snapshot, options);
  if (status.code != StatusCode::kOk) return refused(status.code, status.message);
  if (request.mode == Mode::kReplay && !moment.recorded) {
    return refused(StatusCode::kNoRecording, "mode = replay needs a recording");
  }
  Realization answer = attempt(method, moment, request);
  if (answer.status.code != StatusCode::kOk || answer.report.verified()) return answer;
  return refused(StatusCode::kNoAttackWithinLimits,
                 "the method's attack " + shortcomingOf(answer.report));
}

}  // namespace forge
