#pragma once

#include <memory>
#include <optional>
#include <string>

#include "collision_forge/attack/options.h"
#include "collision_forge/attack/pattern_predictor.h"
#include "collision_forge/forecast/ego_futures.h"
#include "collision_forge/forecast/speed_forecaster.h"
#include "collision_forge/network/pattern_network.h"

namespace forge {

/// What futures and patterns are foreseen by: fitted and trained models. Cheap to copy; may be used
/// from many threads.
struct Foresight {
  std::shared_ptr<const SpeedForecaster> speeds;    ///< null: the present acceleration fades
  std::shared_ptr<const PatternNetworks> networks;  ///< null: no learning
  /// The request's type, where the networks were trained on clips of the very scene. What they know
  /// by heart of it, the type brings up; in other scenes it misleads what tells the ego's place.
  std::optional<CollisionType> known_type;

  Foresight withoutNetworks() const { return {speeds, nullptr, std::nullopt}; }

  /// Neither model uses what was recorded in `left_out_scene`.
  std::shared_ptr<const EgoFutureSampler> egoFutures(const EgoFutureOptions& options,
                                                     const std::string& left_out_scene = "") const;
  std::unique_ptr<const PatternPredictor> patterns(const AttackOptions& options,
                                                   const std::string& left_out_scene = "") const;
};

}  // namespace forge
