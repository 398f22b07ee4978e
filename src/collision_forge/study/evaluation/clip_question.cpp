#include "collision_forge/study/evaluation/clip_question.h"

#include <utility>

#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/io/collide/collide_scene.h"
#include "collision_forge/study/evaluation/clip_attackers.h"
#include "collision_forge/study/evaluation/clip_methods.h"

namespace forge {
namespace {

CrashDefinition clipCrash(CrashDefinition crash) {
  crash.min_confidence = 0.0;
  return withClipRules(std::move(crash));
}

}  // namespace

MethodMaker clipMethod(const std::string& name, const CollideClip& clip,
                       const ClipEvaluationSetup& setup, bool seen_scenes) {
  const PredictionModels models =
      seen_scenes ? PredictionModels{setup.models.speeds, setup.models.network, clip.type}
                  : setup.models.withoutScene(clip.scene);
  return {name, clipMethods(setup.methods, &clip, setup.study.evaluation), setup.study.attack,
          models};
}

ClipQuestion::ClipQuestion(const CollideClip& clip, std::shared_ptr<const LaneIndex> lanes,
                           Mode mode, const StudyOptions& study)
    : prediction_(study.attack.prediction),
      request_(requestOf(clip, mode, prediction_.min_tta, clipCrash(study.crash))),
      recording_(toScene(clip, study.evaluation.collide, lanes->sharedMap())),
      moment_{snapshotAt(recording_, clip.now(), prediction_.history_frames),
              recordedFuture(recording_, clip.now()), std::move(lanes)} {}

Status ClipQuestion::check(const MethodMaker& maker) const {
  return maker.isSeeded() ? checkRequest(request_, moment_.snapshot, prediction_) : Status();
}

Attack ClipQuestion::ask(const AttackMethod& method, std::uint64_t seed) const {
  CollisionRequest request = request_;
  request.seed = seed;
  return attempt(method, moment_, request);
}

Attack ClipQuestion::answer(const MethodMaker& maker, const AttackMethod& method,
                            std::uint64_t seed) const {
  const Status status = check(maker);
  return status.code == StatusCode::kOk ? ask(method, seed) : rejection(status);
}

}  // namespace forge
