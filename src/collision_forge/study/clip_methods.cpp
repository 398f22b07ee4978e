#include "collision_forge/study/clip_methods.h"

#include <functional>
#include <stdexcept>
#include <utility>

#include "collision_forge/study/clip_attackers.h"
#include "collision_forge/study/published_search.h"

namespace forge {
namespace {

const char* const kConstantVelocity = "constant_velocity";
const char* const kPublishedSearch = "published_search";

/// A method that is told by the clip what its attacker drives. Held against what came by the
/// protocols, so its report stays empty.
class ClipMethod : public AttackMethod {
 public:
  using Drive = std::function<AttackerTrajectory(const Moment&, const CollisionRequest&)>;

  explicit ClipMethod(Drive drive) : drive_(std::move(drive)) {}

  Realization answer(const Moment& moment, const CollisionRequest& request) const override {
    Realization answer;
    answer.trajectory = drive_(moment, request);
    return answer;
  }

 private:
  Drive drive_;
};

std::unique_ptr<const AttackMethod> publishedSearch(const CollideClip* clip,
                                                    const EvaluationOptions& evaluation,
                                                    const AttackOptions& options,
                                                    const MethodForesight& foresight) {
  return std::make_unique<ClipMethod>([=](const Moment& moment, const CollisionRequest& request) {
    return publishedSearchAttacker(*clip, moment.snapshot,
                                   moment.recorded ? &*moment.recorded : nullptr, request,
                                   *moment.lanes, foresight.ego_futures, options, evaluation);
  });
}

}  // namespace

MethodRegistry clipMethods(const MethodRegistry& methods, const CollideClip* clip,
                           const EvaluationOptions& evaluation) {
  const BoxSize box = evaluation.collide.box;
  MethodRegistry registry;
  registry.add({"recorded", "the set's own attacker", false, [=](const MethodSetup& setup) {
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
  registry.add({kPublishedSearch, "the search on the published objective, without limits", true,
                [=](const MethodSetup& setup) {
                  return publishedSearch(clip, evaluation, setup.options, setup.kinematic);
                }});
  registry.add({withNetworks(kPublishedSearch), "the same with the futures of the networks", true,
                [=](const MethodSetup& setup) {
                  return publishedSearch(clip, evaluation, setup.options, networksOf(setup));
                }});
  return registry;
}

}  // namespace forge
