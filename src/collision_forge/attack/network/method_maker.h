#pragma once

#include <memory>
#include <string>

#include "collision_forge/attack/network/foresight.h"
#include "collision_forge/attack/network/network_ego_futures.h"
#include "collision_forge/attack/search/method_registry.h"

namespace forge {

/// One method of a run, made anew for every scene that it must not have learned from. Cheap to
/// copy; may be used from many threads.
class MethodMaker {
 public:
  /// An empty name is defaultMethod(). Throws std::invalid_argument for a name that `methods` does
  /// not have, and for a method that lacks what it needs.
  MethodMaker(const std::string& name, const MethodRegistry& methods, const AttackOptions& options,
              Foresight foresight);

  const std::string& name() const { return entry_.name; }
  bool isSeeded() const { return entry_.is_seeded; }
  const AttackOptions& options() const { return options_; }

  std::unique_ptr<const AttackMethod> make() const { return makeOf(foresight_); }
  /// For a scene on test: a method that knows nothing of it, where its models can.
  std::unique_ptr<const AttackMethod> makeWithoutScene(const std::string& scene) const {
    return makeOf(foresight_.withoutScene(scene));
  }
  /// How the ego may drive on.
  std::shared_ptr<const EgoFutureSampler> egoFutures() const {
    return std::make_shared<NetworkEgoFutures>(options_.ego_futures, foresight_);
  }
  /// How the ego of a scene on test may drive on, by models that know nothing of it.
  std::shared_ptr<const EgoFutureSampler> egoFuturesWithoutScene(const std::string& scene) const {
    return std::make_shared<NetworkEgoFutures>(options_.ego_futures,
                                               foresight_.withoutScene(scene));
  }

 private:
  std::unique_ptr<const AttackMethod> makeOf(const Foresight& foresight) const;

  AttackOptions options_;
  Foresight foresight_;
  MethodRegistry::Entry entry_;
};

}  // namespace forge
