#include "collision_forge/network/foresight.h"

#include "collision_forge/network/network_ego_futures.h"
#include "collision_forge/network/network_pattern_predictor.h"

namespace forge {

std::shared_ptr<const EgoFutureSampler> Foresight::egoFutures(
    const EgoFutureOptions& options, const std::string& left_out_scene) const {
  return std::make_shared<NetworkEgoFutures>(options, networks, speeds, left_out_scene, known_type);
}

std::unique_ptr<const PatternPredictor> Foresight::patterns(
    const AttackOptions& options, const std::string& left_out_scene) const {
  return std::make_unique<NetworkPatternPredictor>(options,
                                                   egoFutures(options.ego_futures, left_out_scene),
                                                   networks, left_out_scene, known_type);
}

}  // namespace forge
