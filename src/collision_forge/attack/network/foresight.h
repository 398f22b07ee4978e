#pragma once

#include <memory>
#include <optional>
#include <string>

#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/attack/network/pattern_network.h"
#include "collision_forge/base/scene/collision_type.h"

namespace forge {

/// What futures and patterns are foreseen by: fitted and trained models. Cheap to copy; may be used
/// from many threads.
struct Foresight {
  std::shared_ptr<const SpeedForecaster> speeds;  ///< null: the present acceleration fades
  std::shared_ptr<const PatternNetwork> network;  ///< null: no learning
  /// The request's type, where the network was trained on clips of the very scene. What it knows
  /// by heart of it, the type brings up; in other scenes it misleads what tells the ego's place.
  std::optional<CollisionType> known_type;
  std::string unseen_scene = {};  ///< that is on test; empty: none

  Foresight withoutNetwork() const { return {speeds, nullptr, std::nullopt, unseen_scene}; }
  /// For a scene on test: models that know nothing of it, where there are any.
  Foresight withoutScene(const std::string& scene) const;
};

}  // namespace forge
