#pragma once

#include <memory>
#include <optional>
#include <string>

#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/attack/network/pattern_network.h"
#include "collision_forge/base/scene/collision_type.h"

namespace forge {

/// Trained models that predict ego futures and collision patterns. Cheap to copy; usable from many
/// threads at once.
struct PredictionModels {
  std::shared_ptr<const SpeedForecaster> speeds;  ///< null: the acceleration at t0 decays
  std::shared_ptr<const PatternNetwork> network;  ///< null: kinematic prediction only
  /// The requested type. Set only if the scene was in the network's training set; in unseen scenes,
  /// conditioning on the type makes the ego prediction worse.
  std::optional<CollisionType> known_type;
  std::string unseen_scene = {};  ///< name of the test scene that models must not know; empty: none

  /// Returns the models for kinematic prediction only.
  PredictionModels withoutNetwork() const { return {speeds, nullptr, std::nullopt, unseen_scene}; }
  /// Returns the models fitted without `scene`, for tests on it; models without such a fold are
  /// kept, and so are known_type and models that are null. `unseen_scene` of the result is `scene`.
  PredictionModels withoutScene(const std::string& scene) const;
};

}  // namespace forge
