#include "collision_forge/study/clip_evaluation.h"

#include <algorithm>
#include <utility>

#include "collision_forge/attack/request_check.h"
#include "collision_forge/data/collide_scene.h"
#include "collision_forge/network/method_maker.h"
#include "collision_forge/study/clip_attackers.h"
#include "collision_forge/study/clip_methods.h"
#include "collision_forge/study/published.h"
#include "collision_forge/study/strict.h"

namespace forge {
namespace {

const std::vector<std::string> kBaselines = {"recorded", "constant_velocity", "nominal"};

/// What counts in every clip; what comes is measured, whatever the confidence.
CrashDefinition clipCrash(CrashDefinition crash) {
  crash.min_confidence = 0.0;
  return rulesOfClips(std::move(crash));
}

/// What may be known of a clip's scene.
Foresight foresightOf(const Foresight& foresight, const CollideClip& clip,
                      const EvaluationPlan& plan) {
  if (!plan.seen_scenes) return foresight.withoutScene(clip.scene);
  return {foresight.speeds, foresight.network, clip.type};
}

/// A clip made ready for all methods.
class ClipCase {
 public:
  ClipCase(const CollideClip& clip, std::shared_ptr<const LaneIndex> lanes,
           const ClipEvaluationSetup& setup, const EvaluationPlan& plan)
      : clip_(clip),
        study_(setup.study),
        methods_(clipMethods(setup.methods, &clip, setup.study.evaluation)),
        foresight_(foresightOf(setup.foresight, clip, plan)),
        request_(requestOf(clip, plan.mode, setup.study.attack.prediction.min_tta,
                           clipCrash(setup.study.crash))) {
    const Scene scene = toScene(clip, study_.evaluation.collide, lanes->sharedMap());
    moment_ = {snapshotAt(scene, clip.now(), study_.attack.prediction.history_frames),
               recordedFuture(scene, clip.now()), std::move(lanes)};
  }

  Realization answer(const std::string& method, std::uint64_t seed) const {
    CollisionRequest request = request_;
    request.seed = seed;
    const MethodMaker maker(method, methods_, study_.attack, foresight_);
    Realization refused;
    if (maker.isSeeded()) {
      refused.status = checkRequest(request, moment_.snapshot, study_.attack.prediction);
    }
    if (refused.status.code != StatusCode::kOk) return refused;
    return attempt(*maker.make(), moment_, request);
  }

  void judge(const Realization& answer, const std::string& method, Protocol protocol,
             ResultRow& row) const {
    if (protocol == Protocol::kStrict) {
      const VerificationInput input{moment_.snapshot, *moment_.recorded, request_, *moment_.lanes};
      describeOutcome(strictOutcome(answer.trajectory, input, study_.attack.verification),
                      clip_.now(), row);
      if (methods_.at(method).is_seeded && answer.report.contact) {
        row.confidence = answer.report.confidence;
      }
    } else {
      judgeAsPublished(
          method == kBaselines.front() ? recordedFrames(clip_) : framesOf(clip_, answer.trajectory),
          row);
    }
  }

 private:
  void judgeAsPublished(const std::vector<Pose2>& frames, ResultRow& row) const {
    const PublishedOutcome outcome = publishedOutcome(clip_, frames, study_.evaluation.published);
    row.meets = {outcome.isHit(), outcome.similar};
    if (outcome.event == PublishedOutcome::Event::kNone) return;
    const double frame =
        static_cast<double>(outcome.step) / study_.evaluation.published.steps_per_interval;
    row.contact_after = kCollideFrameInterval * (frame - kCollideNowFrame);
    if (outcome.isHit()) {
      row.relative_heading = outcome.relative_heading;
    } else {
      const bool is_ego = outcome.event == PublishedOutcome::Event::kEgoOther;
      row.note = (is_ego ? "ego touches " : "attacker touches ") + outcome.other_id;
    }
  }

  const CollideClip& clip_;
  const StudyOptions& study_;
  MethodRegistry methods_;
  Foresight foresight_;
  CollisionRequest request_;
  Moment moment_;
};

ResultRow rowOf(const ClipCase& clip_case, const CollideClip& clip, Protocol protocol,
                const std::string& method, std::uint64_t seed) {
  const Realization answer = clip_case.answer(method, seed);
  ResultRow row;
  row.name = clip.name;
  row.scene = clip.scene;
  row.type = clip.type;
  row.tta = clip.nominalTta();
  row.method = method;
  row.seed = seed;
  row.status = toString(answer.status.code);
  row.meets.assign(measuresOf(protocol).size(), false);
  if (answer.status.code == StatusCode::kOk) {
    clip_case.judge(answer, method, protocol, row);
  } else {
    row.note = answer.status.message;
  }
  return row;
}

/// Seeds matter to methods that draw alone.
int seedsOf(const std::string& method, const EvaluationPlan& plan) {
  const bool is_baseline =
      std::find(kBaselines.begin(), kBaselines.end(), method) != kBaselines.end();
  return plan.is_seeded && !is_baseline ? plan.seeds : 1;
}

}  // namespace

std::vector<std::string> methodsOf(const EvaluationPlan& plan) {
  std::vector<std::string> names = kBaselines;
  for (const std::string& name : {withoutNetworks(plan.method), plan.method}) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::size_t rowsPerClip(const EvaluationPlan& plan) {
  std::size_t rows = 0;
  for (const std::string& method : methodsOf(plan)) {
    rows += static_cast<std::size_t>(seedsOf(method, plan));
  }
  return rows;
}

std::vector<ResultRow> evaluateClip(const CollideClip& clip, std::shared_ptr<const LaneIndex> lanes,
                                    const ClipEvaluationSetup& setup, const EvaluationPlan& plan) {
  const ClipCase clip_case(clip, std::move(lanes), setup, plan);
  std::vector<ResultRow> rows;
  for (const std::string& method : methodsOf(plan)) {
    for (int seed = 0; seed < seedsOf(method, plan); ++seed) {
      rows.push_back(
          rowOf(clip_case, clip, plan.protocol, method, static_cast<std::uint64_t>(seed)));
    }
  }
  return rows;
}

}  // namespace forge
