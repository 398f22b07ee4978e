#include "collision_forge/study/evaluation/clip_methods.h"

#include <functional>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/search/baselines.h"
#include "collision_forge/study/evaluation/clip_attackers.h"
#include "collision_forge/study/evaluation/published_search.h"

namespace forge {
namespace {

const char* const kConstantVelocity = "constant_velocity";
const char* const kPublishedSearch = "published_search";
const char* const kPublishedNetwork = "published_network";

/// A method that derives the attacker's trajectory from the clip. The protocols verify it against
/// the recorded future, so the report stays empty.
class ClipMethod : public AttackMethod {
 public:
  using Drive = std::function<AttackerTrajectory(const Moment&, const CollisionRequest&)>;

  explicit ClipMethod(Drive drive) : drive_(std::move(drive)) {}

  Attack answer(const Moment& moment, const CollisionRequest& request) const override {
    Attack answer;
    answer.trajectory = drive_(moment, request);
    return answer;
  }

 private:
  Drive drive_;
};

/// Drives to the pattern of another method with the final speed and acceleration of the data set's
/// attacker.
class LookaheadMethod : public AttackMethod {
 public:
  LookaheadMethod(std::unique_ptr<const AttackMethod> method, const CollideClip* clip,
                  const AttackOptions& options)
      : method_(std::move(method)), clip_(clip), options_(options) {}

  Attack answer(const Moment& moment, const CollisionRequest& request) const override {
    Attack answer = method_->answer(moment, request);
    if (answer.status.code != StatusCode::kOk) return answer;
    const std::vector<std::optional<CollideState>>& frames = clip_->attacker().frames;
    const auto last = static_cast<std::size_t>(clip_->collision_frame);
    const double seconds = clip_->times[last] - clip_->times[last - 1];
    const double speed = frames[last]->speed;
    const EndMotion end{speed, (speed - frames[last - 1]->speed) / seconds};
    answer.trajectory =
        patternAttacker(answer.pattern, moment.snapshot, request.tta, options_, end);
    answer.report = {};
    return answer;
  }

 private:
  std::unique_ptr<const AttackMethod> method_;
  const CollideClip* clip_;
  AttackOptions options_;
};

std::unique_ptr<const AttackMethod> publishedSearch(const CollideClip* clip,
                                                    const EvaluationOptions& evaluation,
                                                    const AttackOptions& options,
                                                    const MethodPredictors& predictors) {
  return std::make_unique<ClipMethod>([=](const Moment& moment, const CollisionRequest& request) {
    return publishedSearchAttacker(*clip, moment.snapshot,
                                   moment.recorded ? &*moment.recorded : nullptr, request,
                                   *moment.lanes, predictors.ego_futures, options, evaluation);
  });
}

}  // namespace

MethodRegistry clipMethods(const MethodRegistry& methods, const CollideClip* clip,
                           const EvaluationOptions& evaluation) {
  const BoxSize box = evaluation.collide.box;
  MethodRegistry registry;
  registry.add({"recorded", "the data set's attacker", false, [=](const MethodSetup& setup) {
                  const SearchOptions search = setup.options.search;
                  return std::make_unique<ClipMethod>([=](const Moment&, const CollisionRequest&) {
                    return recordedAttacker(*clip, box, search);
                  });
                }});
  registry.add({kConstantVelocity, "baseline: the attacker keeps its speed and heading", false,
                [=](const MethodSetup& setup) {
                  const SearchOptions search = setup.options.search;
                  return std::make_unique<ClipMethod>([=](const Moment&, const CollisionRequest&) {
                    return constantVelocityAttacker(*clip, box, search);
                  });
                }});
  for (const MethodRegistry::Entry& entry : methods.entries()) {
    if (entry.name != kConstantVelocity) registry.add(entry);
  }
  if (methods.has(kPublishedNetwork)) {
    const MethodRegistry::Entry published = methods.at(kPublishedNetwork);
    registry.add({std::string(kPublishedNetwork) + "_lookahead",
                  "the published network with the recorded attacker's final speed and "
                  "acceleration, as in the released code",
                  published.is_seeded, [=](const MethodSetup& setup) {
                    return std::make_unique<LookaheadMethod>(published.make(setup), clip,
                                                             setup.options);
                  }});
  }
  registry.add({kPublishedSearch,
                "the attack search with the objective of the published protocol, without limits",
                true, [=](const MethodSetup& setup) {
                  return publishedSearch(clip, evaluation, setup.options, setup.kinematic);
                }});
  registry.add({withNetworks(kPublishedSearch),
                "the same search with futures predicted by the network", true,
                [=](const MethodSetup& setup) {
                  return publishedSearch(clip, evaluation, setup.options, networksOf(setup));
                }});
  return registry;
}

}  // namespace forge
