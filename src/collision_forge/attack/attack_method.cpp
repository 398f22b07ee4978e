#include "collision_forge/attack/attack_method.h"

#include "collision_forge/attack/alternatives.h"
#include "collision_forge/attack/request_check.h"

namespace forge {
namespace {

Realization refused(StatusCode code, const std::string& message) {
  Realization refusal;
  refusal.status = {code, message};
  return refusal;
}

/// Why the vehicle is not the one that was asked for, for people; empty where it is.
std::string wrongAttacker(const AttackerTrajectory& attacker, const CollisionRequest& request) {
  if (request.attacker_class && attacker.agent_class != *request.attacker_class) {
    return std::string("is by a ") + toString(attacker.agent_class);
  }
  if (attacker.isAdded() && request.choice == AttackerChoice::kExisting) return "is by a new one";
  if (!attacker.isAdded() && request.choice == AttackerChoice::kNew) return "is by a recorded one";
  return "";
}

}  // namespace

Realization attempt(const AttackMethod& method, const Moment& moment,
                    const CollisionRequest& request) {
  if (request.mode == Mode::kReplay || !moment.recorded) return method.answer(moment, request);
  return method.answer({moment.snapshot, std::nullopt, moment.lanes, moment.past}, request);
}

Realization generateCollision(const AttackMethod& method, const Moment& moment,
                              const CollisionRequest& asked, const PredictionOptions& options) {
  const CollisionRequest request = withFullId(asked, moment.snapshot);
  const Status status = checkRequest(request, moment.snapshot, options);
  if (status.code != StatusCode::kOk) return refused(status.code, status.message);
  if (request.mode == Mode::kReplay && !moment.recorded) {
    return refused(StatusCode::kNoRecording, "mode = replay needs a recording");
  }
  Realization answer = attempt(method, moment, request);
  if (answer.status.code != StatusCode::kOk) return answer;
  if (answer.report.verified() && request.crash.believable && !answer.report.believable()) {
    return refused(StatusCode::kNotBelievable, "the attacker " + answer.report.unbelievable);
  }
  std::string shortcoming = shortcomingOf(answer.report, request);
  if (shortcoming.empty()) shortcoming = wrongAttacker(answer.trajectory, request);
  if (shortcoming.empty()) {
    if (request.alternatives > 1) {
      answer.alternatives = findAlternatives(answer, method, moment, request, options);
    }
    return answer;
  }
  return refused(StatusCode::kNoAttackWithinLimits, "the method's attack " + shortcoming);
}

}  // namespace forge
