#include "collision_forge/attack/search/attack_method.h"

#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/request_check.h"

namespace forge {

Attack attempt(const AttackMethod& method, const Moment& moment, const CollisionRequest& request) {
  if (request.type == CollisionType::kAny) {
    return rejection({StatusCode::kUnknownType, "type = any: a method attacks with one type"});
  }
  if (request.mode == Mode::kReplay || !moment.recorded) return method.answer(moment, request);
  return method.answer({moment.snapshot, std::nullopt, moment.lanes, moment.past}, request);
}

Attack generateOne(const AttackMethod& method, const Moment& moment, const CollisionRequest& asked,
                   const PredictionOptions& options) {
  const CollisionRequest request = withFullId(asked, moment.snapshot);
  const Status status = checkRequest(request, moment.snapshot, options);
  if (status.code != StatusCode::kOk) return rejection(status);
  if (request.crash.believable && moment.lanes->map().lanes.empty()) {
    return rejection({StatusCode::kRoadDoesNotAllow,
                      "the map has no lanes, and believable = true needs them: set believable = "
                      "false, or convert the log with a map"});
  }
  if (request.mode == Mode::kReplay && !moment.recorded) {
    return rejection({StatusCode::kNoRecording, "mode = replay needs a recording"});
  }
  Attack answer = attempt(method, moment, request);
  const Status verdict = verdictOn(answer, request);
  return verdict.code == StatusCode::kOk ? answer : rejection(verdict);
}

}  // namespace forge
