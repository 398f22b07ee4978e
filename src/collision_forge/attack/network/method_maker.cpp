#include "collision_forge/attack/network/method_maker.h"

#include <stdexcept>
#include <utility>

#include "collision_forge/attack/network/network_pattern_predictor.h"

namespace forge {
namespace {

MethodPredictors predictorsOf(const AttackOptions& options, const PredictionModels& foresight) {
  return {std::make_shared<NetworkEgoFutures>(options.ego_futures, foresight),
          std::make_unique<NetworkPatternPredictor>(options, foresight)};
}

}  // namespace

MethodMaker::MethodMaker(const std::string& name, const MethodRegistry& methods,
                         const AttackOptions& options, PredictionModels foresight)
    : options_(options),
      foresight_(std::move(foresight)),
      entry_(methods.at(name.empty() ? defaultMethod(foresight_.network != nullptr) : name)) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("method " + entry_.name + ": " + error.what());
  }
}

std::unique_ptr<const AttackMethod> MethodMaker::makeOf(const PredictionModels& foresight) const {
  MethodSetup setup{
      options_, predictorsOf(options_, foresight.withoutNetwork()), {}, foresight.unseen_scene};
  if (foresight.network) setup.networks = predictorsOf(options_, foresight);
  return entry_.make(setup);
}

}  // namespace forge
