#pragma once

#include <memory>
#include <string>

#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

/// The options of a model that sees no lanes are made to have none. Throws std::invalid_argument
/// for an unknown name. `seed` of the weights before training.
std::shared_ptr<TrafficModel> makeTrafficModel(const std::string& name, GeneratorOptions options,
                                               torch::Device device, std::uint64_t seed);

}  // namespace forge
