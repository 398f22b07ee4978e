#include "collision_forge/ros/nodes/stage_services.h"

#include <collision_forge/PredictPattern.h>
#include <collision_forge/RealizeTrajectory.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_forge/attack/search/judge.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

collision_forge::RealizeTrajectory::Request messageOf(const RealizationTask& task) {
  const VerificationInput& input = task.input;
  collision_forge::RealizeTrajectory::Request message;
  message.scene = toMessage(input.snapshot);
  message.request = toMessage(input.request);
  for (const CollisionPattern& pattern : task.patterns) {
    message.patterns.push_back(toMessage(pattern, input.snapshot.now));
  }
  message.future = toMessage(input.future);
  message.exact = static_cast<std::uint8_t>(task.exact);
  for (const auto& [id, way] : task.ways) message.ways.push_back(toMessage(way, id));
  message.any_motion = static_cast<std::uint8_t>(task.motion == SearchedMotion::kAny);
  return message;
}

/// Returns the predicted ego futures; first the one in which the ego is closest to the contact
/// position of the response.
std::vector<const Track*> nearestFirst(std::vector<const Track*> egos,
                                       const collision_forge::CollisionReport& claimed) {
  if (!claimed.contact) return egos;
  const double time = claimed.contact_time.toSec();
  const Vector2 place = fromMessage(claimed.ego_at_contact).position();
  const auto apart = [&](const Track* ego) {
    const AgentState state = stateAt(*ego, time).value_or(ego->states.back());
    return (state.pose.position() - place).squaredNorm();
  };
  std::stable_sort(egos.begin(), egos.end(),
                   [&](const Track* a, const Track* b) { return apart(a) < apart(b); });
  return egos;
}

}  // namespace

PatternPrediction PatternPredictorService::predict(const Snapshot& snapshot,
                                                   const LaneIndex& /*lanes*/,
                                                   const CollisionRequest& request,
                                                   const Future* recorded) const {
  collision_forge::PredictPattern service;
  service.request.scene = toMessage(snapshot);
  service.request.request = toMessage(request);
  if (recorded) service.request.recorded_future = toMessage(*recorded);
  PatternPrediction prediction;
  prediction.status = caller_.call(service);
  const bool is_declined = prediction.status.code != StatusCode::kOk;
  if (is_declined && service.response.future.ego.states.empty()) return prediction;
  prediction.future = fromMessage(service.response.future);
  checkFuture(prediction.future, limits_, "future of predict_pattern");
  for (const auto& pattern : service.response.patterns) {
    prediction.patterns.push_back(fromMessage(pattern));
    checkPattern(prediction.patterns.back(), limits_, "patterns of predict_pattern");
  }
  on_prediction_(prediction);
  return prediction;
}

Attack TrajectoryRealizerService::realize(const RealizationTask& task) const {
  collision_forge::RealizeTrajectory service;
  service.request = messageOf(task);
  const Status status = caller_.call(service);
  if (status.code != StatusCode::kOk) return rejection(status);
  const collision_forge::Attack& answer = service.response.attack;
  Attack attack;
  attack.pattern = fromMessage(answer.pattern);
  attack.trajectory = fromMessage(answer.trajectory);
  checkTrajectory(attack.trajectory, limits_, "attack of realize_trajectory");
  attack.effort = answer.effort;
  if (!(attack.effort >= 0.0 && std::isfinite(attack.effort))) {
    throw MessageError("effort of realize_trajectory = " + numberText(attack.effort) +
                       " is not a finite number >= 0");
  }
  const auto& agents = task.input.snapshot.agents;
  const auto attacker = std::find_if(agents.begin(), agents.end(), [&](const Track& agent) {
    return agent.id == attack.trajectory.attacker_id;
  });
  if (attacker == agents.end()) {
    throw MessageError("attacker_id of realize_trajectory = \"" + attack.trajectory.attacker_id +
                       "\" is not in the scene");
  }
  attack.trajectory = {attacker->id, attacker->agent_class, attacker->size,
                       std::move(attack.trajectory.points)};
  AttackJudge judge(task.input, options_, task.exact);
  const bool is_accepted =
      judge.accepts(attack, *attacker, nearestFirst(judge.searched(), answer.report));
  return is_accepted ? attack : rejection(judge.refusal(task.patterns));
}

}  // namespace forge
