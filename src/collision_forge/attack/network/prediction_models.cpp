#include "collision_forge/attack/network/prediction_models.h"

namespace forge {

PredictionModels PredictionModels::withoutScene(const std::string& scene) const {
  return {forge::withoutScene(speeds, scene), forge::withoutScene(network, scene), known_type,
          scene};
}

}  // namespace forge
