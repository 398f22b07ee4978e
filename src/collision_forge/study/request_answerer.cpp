#include "collision_forge/study/request_answerer.h"

#include <utility>

namespace forge {

RequestAnswerer::RequestAnswerer(SceneSource& scenes, MethodMaker method, CrashDefinition crash,
                                 const EgoVehicle& ego)
    : scenes_(scenes), method_(std::move(method)), crash_(std::move(crash)), ego_(ego) {}

Scenario RequestAnswerer::answer(const SceneRequest& asked) const {
  Scenario scenario{asked, ego_, {}};
  const PredictionOptions& options = method_.options().prediction;
  const auto found = momentAt(*scenes_.at(asked.scene), asked.now, options.history_frames);
  if (const Status* status = std::get_if<Status>(&found)) {
    scenario.answer.status = *status;
    return scenario;
  }
  CollisionRequest request = asked.request;
  request.crash = crash_;
  scenario.answer = generateCollision(*method_.makeWithoutScene(asked.scene),
                                      std::get<Moment>(found), request, options);
  return scenario;
}

}  // namespace forge
