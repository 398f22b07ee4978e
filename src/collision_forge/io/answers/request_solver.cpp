#include "collision_forge/io/answers/request_solver.h"

#include <utility>

#include "collision_forge/attack/policy/adaptive_answer.h"
#include "collision_forge/attack/search/generate_collision.h"

namespace forge {

RequestSolver::RequestSolver(SceneSource& scenes, MethodMaker method, CrashDefinition crash,
                             const EgoVehicle& ego, const AdaptiveOptions& adaptive)
    : scenes_(scenes),
      method_(std::move(method)),
      crash_(std::move(crash)),
      ego_(ego),
      adaptive_(adaptive) {}

Scenario RequestSolver::answer(const SceneRequest& asked) const {
  Scenario scenario{asked, ego_, {}};
  const PredictionOptions& options = method_.options().prediction;
  const auto recording = scenes_.at(asked.scene);
  scenario.ego = egoVehicleOf(recording->scene, ego_.center_offset);
  const auto found = momentAt(*recording, asked.now, options.history_frames);
  if (const Status* status = std::get_if<Status>(&found)) {
    scenario.answer.status = *status;
    return scenario;
  }
  CollisionRequest request = asked.request;
  request.crash = crash_;
  const Moment& moment = std::get<Moment>(found);
  const auto method = method_.makeWithoutScene(asked.scene);
  if (request.mode != Mode::kAdaptive) {
    scenario.answer = generateCollision(*method, moment, request, options);
    scenario.asked.request = withTypeOf(scenario.asked.request, scenario.answer);
    return scenario;
  }
  const AttackerSetup setup{method_.egoFuturesWithoutScene(asked.scene), method_.options(),
                            adaptive_};
  AdaptiveDrive answer = rejectMisses(
      requestAdaptively(*method, moment, recording->scene, scenario.ego, request, setup), request);
  scenario.answer = std::move(answer.attack);
  scenario.asked.request = withTypeOf(scenario.asked.request, scenario.answer);
  scenario.plans = std::move(answer.plans);
  return scenario;
}

}  // namespace forge
