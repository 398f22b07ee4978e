#pragma once

#include <memory>
#include <string>

#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

/// Creates an untrained model, one of trafficModelNames(), on a device. `seed` determines the
/// initial weights; it seeds libtorch for the whole process. For models that ignore lanes (c_sgan,
/// c_mid), sets max_lanes to 0. Throws std::invalid_argument for an unknown name.
std::shared_ptr<TrafficModel> makeTrafficModel(const std::string& name, GeneratorOptions options,
                                               torch::Device device, std::uint64_t seed);

}  // namespace forge
