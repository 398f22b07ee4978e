#include "collision_forge/study/evaluation/clip_evaluation.h"

#include <algorithm>
#include <map>
#include <utility>

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/attack/policy/adaptive_answer.h"
#include "collision_forge/attack/verify/strict_outcome.h"
#include "collision_forge/study/evaluation/clip_attackers.h"
#include "collision_forge/study/evaluation/outcome_row.h"
#include "collision_forge/study/evaluation/published.h"

namespace forge {
namespace {

const std::vector<std::string> kBaselines = {"recorded", "constant_velocity", "nominal"};
constexpr char kFirstPlan[] = "first_plan";

/// A clip with the data that all methods share.
class ClipCase {
 public:
  ClipCase(const CollideClip& clip, std::shared_ptr<const LaneIndex> lanes,
           const ClipEvaluationSetup& setup, const EvaluationPlan& plan)
      : clip_(clip),
        setup_(setup),
        plan_(plan),
        question_(clip, std::move(lanes), plan.mode == Mode::kAdaptive ? Mode::kHistory : plan.mode,
                  setup.study) {}

  MethodMaker maker(const std::string& row) const {
    return clipMethod(row == kFirstPlan ? plan_.method : row, clip_, setup_, plan_.seen_scenes);
  }

  Realization answer(const std::string& row, const MethodMaker& maker, std::uint64_t seed) {
    if (plan_.mode != Mode::kAdaptive || isBaseline(row)) {
      return question_.answer(maker, *maker.make(), seed);
    }
    CollisionRequest request = question_.request();
    request.seed = seed;
    request.crash.limits = kAdaptiveLimits;
    Realization first = firstPlan(maker, request);
    if (row == kFirstPlan || first.status.code != StatusCode::kOk) return first;
    return driveAdaptively(std::move(first), question_.moment(), question_.recording(),
                           {setup_.study.evaluation.collide.box, 0.0}, request,
                           {maker.egoFutures(), setup_.study.attack, setup_.study.adaptive})
        .attack;
  }

  void judge(const Realization& answer, const MethodMaker& maker, ResultRow& row) const {
    if (plan_.protocol == Protocol::kStrict) {
      const Moment& moment = question_.moment();
      const VerificationInput input{moment.snapshot, *moment.recorded, question_.request(),
                                    *moment.lanes};
      describeOutcome(strictOutcome(answer.trajectory, input, setup_.study.attack.verification),
                      clip_.now(), row);
      if (maker.isSeeded() && answer.report.contact) row.confidence = answer.report.confidence;
    } else {
      judgeAsPublished(maker.name() == kBaselines.front() ? recordedFrames(clip_)
                                                          : framesOf(clip_, answer.trajectory),
                       row);
    }
  }

 private:
  /// Returns the first plan of a method; caches it, because two rows use the plan's method.
  Realization firstPlan(const MethodMaker& maker, const CollisionRequest& request) {
    const auto [found, is_new] = first_plans_.try_emplace({maker.name(), request.seed});
    if (!is_new) return found->second;
    Realization& first = found->second;
    first.status = question_.check(maker);
    if (first.status.code == StatusCode::kOk) {
      first = attempt(*maker.make(), question_.moment(), request);
    }
    return first;
  }

  void judgeAsPublished(const std::vector<Pose2>& frames, ResultRow& row) const {
    const PublishedOptions& published = setup_.study.evaluation.published;
    const PublishedOutcome outcome = publishedOutcome(clip_, frames, published);
    row.meets = {outcome.isHit(), outcome.similar};
    if (outcome.event == PublishedOutcome::Event::kNone) return;
    const double frame = static_cast<double>(outcome.step) / published.steps_per_interval;
    row.contact_after = kCollideFrameInterval * (frame - kCollideNowFrame);
    if (outcome.isHit()) {
      row.relative_heading = outcome.relative_heading;
    } else {
      const bool is_ego = outcome.event == PublishedOutcome::Event::kEgoOther;
      row.note = (is_ego ? "ego touches " : "attacker touches ") + outcome.other_id;
    }
  }

  const CollideClip& clip_;
  const ClipEvaluationSetup& setup_;
  const EvaluationPlan& plan_;
  ClipQuestion question_;
  std::map<std::pair<std::string, std::uint64_t>, Realization> first_plans_;  // by method, seed
};

ResultRow rowOf(ClipCase& clip_case, const CollideClip& clip, Protocol protocol,
                const std::string& method, std::uint64_t seed) {
  const MethodMaker maker = clip_case.maker(method);
  const Realization answer = clip_case.answer(method, maker, seed);
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
    clip_case.judge(answer, maker, row);
  } else {
    row.note = answer.status.message;
  }
  return row;
}

/// Returns the number of seeds to run; methods without random numbers run once.
int seedsOf(const std::string& method, const EvaluationPlan& plan) {
  return plan.is_seeded && !isBaseline(method) ? plan.seeds : 1;
}

}  // namespace

bool isBaseline(const std::string& method) {
  return std::find(kBaselines.begin(), kBaselines.end(), method) != kBaselines.end();
}

std::vector<std::string> methodsOf(const EvaluationPlan& plan) {
  std::vector<std::string> names = kBaselines;
  for (const std::string& name : {withoutNetworks(plan.method), plan.method}) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  if (plan.mode == Mode::kAdaptive) names.push_back(kFirstPlan);
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
  ClipCase clip_case(clip, std::move(lanes), setup, plan);
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
