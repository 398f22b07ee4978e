#pragma once

#include <memory>

#include "collision_forge/study/generators/traffic_generator.h"

namespace forge {

/// Creates C-STRIVE: the traffic model of STRIVE (Rempe et al., CVPR 2022, arXiv 2112.05077), a
/// graph conditional VAE with kinematic bicycles in the decoder, and the request's type and time as
/// input of the decoder (arXiv 2510.12206, Sec. 4). The .cpp lists deviations.
std::shared_ptr<TrafficGenerator> makeStrive(const StriveOptions& options,
                                             const TrafficOptions& traffic, torch::Device device);

}  // namespace forge
