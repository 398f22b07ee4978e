// An attack method as another package could add it: the first predicted pattern with a quintic that
// passes verify(). Once named in methods.yaml, the live node, forge and the panel offer it.
#include "collision_forge/attack/search/baselines.h"
#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {
namespace {

class FirstVerifiedQuintic : public AttackMethod {
 public:
  explicit FirstVerifiedQuintic(const MethodSetup& setup)
      : options_(setup.options), predictor_(setup.kinematic.patterns) {}

  Attack answer(const Moment& moment, const CollisionRequest& request) const override {
    const PatternPrediction predicted = predictor_->predict(
        moment.snapshot, *moment.lanes, request, moment.recorded ? &*moment.recorded : nullptr);
    Attack answer;
    answer.status = predicted.status;
    for (const CollisionPattern& pattern : predicted.patterns) {
      answer.trajectory = patternAttacker(pattern, moment.snapshot, request.tta, options_);
      answer.pattern = pattern;
      answer.report =
          verify(answer.trajectory, {moment.snapshot, predicted.future, request, *moment.lanes},
                 options_.verification);
      if (answer.report.verified()) break;
    }
    return answer;
  }

 private:
  AttackOptions options_;
  std::shared_ptr<const PatternPredictor> predictor_;
};

}  // namespace
}  // namespace forge

extern "C" void addCollisionForgeMethods(forge::MethodRegistry& methods) {
  methods.add({"first_verified_quintic", "one quintic to each pattern until one is verified", false,
               [](const forge::MethodSetup& setup) {
                 return std::make_unique<forge::FirstVerifiedQuintic>(setup);
               }});
}
