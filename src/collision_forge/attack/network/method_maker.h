#pragma once

#include <memory>
#include <string>

#include "collision_forge/attack/network/network_ego_futures.h"
#include "collision_forge/attack/network/prediction_models.h"
#include "collision_forge/attack/search/method_registry.h"

namespace forge {

/// Makes one attack method for a run, and variants for test scenes that its models must not have
/// been trained on. Cheap to copy; usable from many threads at once.
class MethodMaker {
 public:
  /// An empty `name` selects defaultMethod(). Throws std::invalid_argument if `methods` has no such
  /// name or the method lacks a required input, such as a network: makes the method once to check.
  /// Keeps no reference to `methods`.
  MethodMaker(const std::string& name, const MethodRegistry& methods, const AttackOptions& options,
              PredictionModels models);

  /// Returns the method's name in the registry.
  const std::string& name() const { return entry_.name; }
  /// Returns true if results depend on the request's seed.
  bool isSeeded() const { return entry_.is_seeded; }
  /// Returns the options of the constructor.
  const AttackOptions& options() const { return options_; }

  /// Returns a new method with all models.
  std::unique_ptr<const AttackMethod> make() const { return makeOf(models_); }
  /// Returns a new method with models trained without the scene named `scene`, where there are any;
  /// other models are kept.
  std::unique_ptr<const AttackMethod> makeWithoutScene(const std::string& scene) const {
    return makeOf(models_.withoutScene(scene));
  }
  /// Returns a new sampler of ego futures with all models.
  std::shared_ptr<const EgoFutureSampler> egoFutures() const {
    return std::make_shared<NetworkEgoFutures>(options_.ego_futures, models_);
  }
  /// Returns a new sampler of ego futures with the models of makeWithoutScene().
  std::shared_ptr<const EgoFutureSampler> egoFuturesWithoutScene(const std::string& scene) const {
    return std::make_shared<NetworkEgoFutures>(options_.ego_futures, models_.withoutScene(scene));
  }

 private:
  std::unique_ptr<const AttackMethod> makeOf(const PredictionModels& models) const;

  AttackOptions options_;
  PredictionModels models_;
  MethodRegistry::Entry entry_;
};

}  // namespace forge
