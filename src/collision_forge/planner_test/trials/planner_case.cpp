#include "collision_forge/planner_test/trials/planner_case.h"

#include <utility>

#include "collision_forge/base/scene/support_vehicles.h"

namespace forge {

PlannerCase caseOfScenario(const Scenario& scenario, const IndexedScene& indexed,
                           const AnswerOptions& options) {
  PlannerCase one;
  one.scene = scenario.asked.scene;
  one.request = scenario.asked.request;
  one.scenario.snapshot.now = scenario.asked.now;
  one.status = scenario.answer.status;
  if (one.status.code != StatusCode::kOk) return one;
  const CrashDefinition& asked = scenario.asked.request.crash;
  one.request.crash = options.crash;
  one.request.crash.believable = asked.believable;
  one.request.crash.limits = asked.limits;
  auto found = momentAt(indexed, scenario.asked.now, options.attack.prediction.history_frames);
  if (const Status* status = std::get_if<Status>(&found)) {
    one.status = *status;
    return one;
  }
  Moment& moment = std::get<Moment>(found);
  addSupports(scenario.answer.supports, moment.snapshot);
  addSupports(scenario.answer.supports, *moment.recorded);
  one.scenario = {std::move(moment.snapshot),
                  std::move(*moment.recorded),
                  scenario.answer.trajectory,
                  one.request.type,
                  scenario.ego,
                  indexed.lanes,
                  indexed.scene.lights};
  one.scenario.turning = one.request.turning;
  addAttackerPast(one.scenario);
  one.pattern = scenario.answer.pattern;
  one.effort = scenario.answer.effort;
  return one;
}

}  // namespace forge
