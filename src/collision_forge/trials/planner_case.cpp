#include "collision_forge/trials/planner_case.h"

#include <utility>

#include "collision_forge/data/collide_scene.h"
#include "collision_forge/study/clip_attackers.h"
#include "collision_forge/study/clip_question.h"
#include "collision_forge/study/strict.h"
#include "collision_forge/trials/published_planner.h"

namespace forge {
namespace {

/// Where the two stand to each other in the recording at the time asked for, with the tolerance of
/// kinematic patterns; the set has no pattern.
CollisionPattern patternOf(const PlannerCase& one, const PredictionOptions& prediction) {
  const CrashScenario& scenario = one.scenario;
  const double time = scenario.snapshot.now + one.request.tta;
  CollisionPattern pattern;
  pattern.type = one.request.type;
  pattern.attacker_id = scenario.attacker.attacker_id;
  pattern.time = time;
  pattern.tolerance = prediction.pattern_tolerance;
  const auto ego = stateAt(scenario.recorded.ego, time);
  const auto attacker = stateAt(attackerTrack(scenario), time);
  if (!ego || !attacker) return pattern;
  pattern.ego = {ego->pose, scenario.ego.size};
  pattern.attacker_offset = relativeTo(ego->pose, attacker->pose);
  pattern.attacker_speed = attacker->velocity.norm();
  return pattern;
}

/// The method's attack in a clip's case.
Realization answerTo(const PlannerCase& one, const MethodMaker& method, const StudyOptions& study,
                     ClipAnswers answers) {
  const CrashScenario& scenario = one.scenario;
  const std::unique_ptr<const AttackMethod> made = method.makeWithoutScene(one.scene);
  if (answers == ClipAnswers::kAll) {
    const ClipQuestion question(*one.clip, scenario.lanes, one.request.mode, study);
    return question.answer(method, *made, one.request.seed);
  }
  const Moment moment{scenario.snapshot, scenario.recorded, scenario.lanes};
  return generateCollision(*made, moment, one.request, study.attack.prediction);
}

}  // namespace

PlannerCase caseOfScenario(const Scenario& scenario, const IndexedScene& indexed,
                           const StudyOptions& study) {
  PlannerCase one;
  one.scene = scenario.asked.scene;
  one.request = scenario.asked.request;
  one.scenario.snapshot.now = scenario.asked.now;
  one.status = scenario.answer.status;
  if (one.status.code != StatusCode::kOk) return one;
  const CrashDefinition& asked = scenario.asked.request.crash;
  one.request.crash = study.crash;
  one.request.crash.believable = asked.believable;
  one.request.crash.limits = asked.limits;
  auto found = momentAt(indexed, scenario.asked.now, study.attack.prediction.history_frames);
  if (const Status* status = std::get_if<Status>(&found)) {
    one.status = *status;
    return one;
  }
  Moment& moment = std::get<Moment>(found);
  one.scenario = {std::move(moment.snapshot),
                  std::move(*moment.recorded),
                  scenario.answer.trajectory,
                  one.request.type,
                  scenario.ego,
                  indexed.lanes};
  showPast(one.scenario);
  one.pattern = scenario.answer.aim;
  one.effort = scenario.answer.effort;
  return one;
}

PlannerCase caseOfClip(const CollideClip& clip, ClipAttacker attacker,
                       std::shared_ptr<const LaneIndex> lanes, const MethodMaker& method,
                       const StudyOptions& study, ClipAnswers answers) {
  const BoxSize& box = study.evaluation.collide.box;
  const Scene scene = toScene(clip, study.evaluation.collide, lanes->sharedMap());
  PlannerCase one;
  one.name = clip.name;
  one.clip = clip;
  one.scene = clip.scene;
  one.request = requestOf(clip, attacker == ClipAttacker::kReplay ? Mode::kReplay : Mode::kHistory,
                          study.attack.prediction.min_tta, rulesOfClips(study.crash));
  one.scenario = {snapshotAt(scene, clip.now(), study.attack.prediction.history_frames),
                  recordedFuture(scene, clip.now()),
                  {},
                  clip.type,
                  {box, study.ego_vehicle.center_offset},
                  std::move(lanes)};
  if (attacker == ClipAttacker::kRecorded) {
    one.scenario.attacker = recordedAttacker(clip, box, study.attack.search);
    one.pattern = patternOf(one, study.attack.prediction);
    return one;
  }
  Realization answer = answerTo(one, method, study, answers);
  one.status = answer.status;
  one.scenario.attacker = std::move(answer.trajectory);
  if (one.status.code == StatusCode::kOk) one.clip = withAttacker(clip, one.scenario.attacker);
  one.pattern = answer.aim;
  one.effort = answer.effort;
  return one;
}

}  // namespace forge
