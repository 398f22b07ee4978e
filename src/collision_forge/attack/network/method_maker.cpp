#include "collision_forge/attack/network/method_maker.h"

#include <stdexcept>
#include <utility>

#include "collision_forge/attack/network/network_pattern_predictor.h"

namespace forge {
namespace {

MethodPredictors predictorsOf(const AttackOptions& options, const PredictionModels& models) {
  return {std::make_shared<NetworkEgoFutures>(options.ego_futures, models),
          std::make_unique<NetworkPatternPredictor>(options, models)};
}

}  // namespace

MethodMaker::MethodMaker(const std::string& name, const MethodRegistry& methods,
                         const AttackOptions& options, PredictionModels models)
    : options_(options),
      models_(std::move(models)),
      entry_(methods.at(name.empty() ? defaultMethod(models_.network != nullptr) : name)) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("method " + entry_.name + ": " + error.what());
  }
}

std::unique_ptr<const AttackMethod> MethodMaker::makeOf(const PredictionModels& models) const {
  MethodSetup setup{
      options_, predictorsOf(options_, models.withoutNetwork()), {}, models.unseen_scene};
  if (models.network) setup.networks = predictorsOf(options_, models);
  return entry_.make(setup);
}

}  // namespace forge
