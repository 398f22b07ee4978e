#include "collision_forge/attack/network/foresight.h"

#include "collision_forge/attack/network/network_ego_futures.h"
#include "collision_forge/attack/network/network_pattern_predictor.h"

namespace forge {

Foresight Foresight::withoutScene(const std::string& scene) const {
  return {forge::withoutScene(speeds, scene), forge::withoutScene(network, scene), known_type,
          scene};
}

std::shared_ptr<const EgoFutureSampler> Foresight::egoFutures(
    const EgoFutureOptions& options) const {
  return std::make_shared<NetworkEgoFutures>(options, *this);
}

std::unique_ptr<const PatternPredictor> Foresight::patterns(const AttackOptions& options) const {
  return std::make_unique<NetworkPatternPredictor>(options, *this);
}

}  // namespace forge
