#include <algorithm>

#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/attack/search/search_method.h"

/// Sorts the patterns of another predictor by the attacker's speed, highest first.
struct FastestFirst : forge::PatternPredictor {
  std::shared_ptr<const forge::PatternPredictor> other;

  forge::PatternPrediction predict(const forge::Snapshot& snapshot, const forge::LaneIndex& lanes,
                                   const forge::CollisionRequest& request,
                                   const forge::Future* recorded) const override {
    auto prediction = other->predict(snapshot, lanes, request, recorded);
    std::stable_sort(prediction.patterns.begin(), prediction.patterns.end(),
                     [](auto& a, auto& b) { return a.attacker_speed > b.attacker_speed; });
    return prediction;
  }
};

/// Realises the first pattern, or none.
struct FirstPattern : forge::AttackMethod {
  FastestFirst predictor;
  forge::AttackOptions options;

  forge::Attack answer(const forge::Moment& moment,
                       const forge::CollisionRequest& request) const override {
    auto prediction = predictor.predict(moment.snapshot, *moment.lanes, request,
                                        moment.recorded ? &*moment.recorded : nullptr);
    if (prediction.patterns.size() > 1) prediction.patterns.resize(1);
    return forge::realize(
        {prediction.patterns, {moment.snapshot, prediction.future, request, *moment.lanes}},
        options);
  }
};

extern "C" void addCollisionForgeMethods(forge::MethodRegistry& methods) {
  methods.add({"example", "the fastest attacker's pattern alone", true, [](const auto& setup) {
                 auto method = std::make_unique<FirstPattern>();
                 method->predictor.other = setup.kinematic.patterns;
                 method->options = setup.options;
                 return method;
               }});
}
