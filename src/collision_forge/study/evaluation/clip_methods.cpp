#include "collision_forge/study/evaluation/clip_methods.h"

#include <functional>
#include <utility>

#include "collision_forge/study/evaluation/clip_attackers.h"

namespace forge {
namespace {

const char* const kConstantVelocity = "constant_velocity";

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
  return registry;
}

}  // namespace forge
