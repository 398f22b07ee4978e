#include "collision_forge/trials/planner_case.h"

#include <utility>

#include "collision_forge/attack/generator.h"
#include "collision_forge/data/collide_scene.h"
#include "collision_forge/study/baselines.h"
#include "collision_forge/study/request_answerer.h"
#include "collision_forge/study/strict.h"

namespace forge {
namespace {

/// Where the two stand to each other in the recording at the time asked for; the set has no
/// pattern.
CollisionPattern patternOf(const PlannerCase& one) {
  const CrashScenario& scenario = one.scenario;
  const double time = scenario.snapshot.now + one.request.tta;
  CollisionPattern pattern;
  pattern.type = one.request.type;
  pattern.attacker_id = scenario.attacker.attacker_id;
  pattern.time = time;
  const auto ego = stateAt(scenario.recorded.ego, time);
  const auto attacker = stateAt(attackerTrack(scenario), time);
  if (!ego || !attacker) return pattern;
  pattern.ego = {ego->pose, scenario.ego.size};
  pattern.attacker_offset = relativeTo(ego->pose, attacker->pose);
  pattern.attacker_speed = attacker->velocity.norm();
  return pattern;
}

Realization answerClip(const CollideClip& clip, const CrashScenario& scenario,
                       const CollisionRequest& request, const Foresight& foresight,
                       const Config& config) {
  const AttackOptions options = withAngleRules(config.attack);
  const auto predictor = foresight.withoutScene(clip.scene).patterns(options);
  return generateCollision(request, scenario.snapshot, *scenario.lanes, &scenario.recorded,
                           *predictor, options);
}

}  // namespace

PlannerCase caseOfScenario(const Scenario& scenario, const IndexedScene& indexed,
                           const Config& config) {
  PlannerCase one;
  one.scene = scenario.asked.scene;
  one.request = scenario.asked.request;
  one.scenario.snapshot.now = scenario.asked.now;
  one.status = scenario.answer.status;
  if (one.status.code != StatusCode::kOk) return one;
  RecordedMoment moment =
      momentAt(indexed.scene, scenario.asked.now, config.attack.prediction.history_frames);
  one.status = moment.status;
  if (one.status.code != StatusCode::kOk) return one;
  one.scenario = {std::move(moment.snapshot),
                  std::move(moment.recorded),
                  scenario.answer.trajectory,
                  one.request.type,
                  scenario.ego,
                  indexed.lanes};
  one.pattern = scenario.answer.pattern;
  return one;
}

PlannerCase caseOfClip(const CollideClip& clip, ClipAttacker attacker,
                       std::shared_ptr<const LaneIndex> lanes, const Foresight& foresight,
                       const Config& config) {
  const BoxSize& box = config.evaluation.collide.box;
  const Scene scene = toScene(clip, config.evaluation.collide, lanes->sharedMap());
  PlannerCase one;
  one.name = clip.name;
  one.clip = clip;
  one.scene = clip.scene;
  one.request = requestOf(clip, attacker == ClipAttacker::kReplay ? Mode::kReplay : Mode::kHistory,
                          config.attack.prediction.min_tta);
  one.scenario = {snapshotAt(scene, clip.now(), config.attack.prediction.history_frames),
                  recordedFuture(scene, clip.now()),
                  {},
                  clip.type,
                  {box, config.ego_vehicle.center_offset},
                  std::move(lanes)};
  if (attacker == ClipAttacker::kRecorded) {
    one.scenario.attacker = recordedAttacker(clip, box, config.attack.search);
    one.pattern = patternOf(one);
    return one;
  }
  Realization answer = answerClip(clip, one.scenario, one.request, foresight, config);
  one.status = answer.status;
  one.scenario.attacker = std::move(answer.trajectory);
  one.pattern = answer.pattern;
  return one;
}

}  // namespace forge
