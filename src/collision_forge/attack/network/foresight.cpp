#include "collision_forge/attack/network/foresight.h"

namespace forge {

PredictionModels PredictionModels::withoutScene(const std::string& scene) const {
  return {forge::withoutScene(speeds, scene), forge::withoutScene(network, scene), known_type,
          scene};
}

}  // namespace forge
