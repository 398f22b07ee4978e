#pragma once

#include <memory>

#include "collision_forge/study/generators/traffic_generator.h"

namespace forge {

/// C-STRIVE: the traffic model of STRIVE (Rempe et al., CVPR 2022, arXiv 2112.05077), a graph
/// conditional VAE whose decoder drives kinematic bicycles, with the request's type and time at the
/// decoder (arXiv 2510.12206, Sec. 4). What is simplified or left to choose is named in the source.
std::shared_ptr<TrafficGenerator> makeStrive(const StriveOptions& options,
                                             const StriveAttackOptions& attack,
                                             const TrafficOptions& traffic, torch::Device device);

}  // namespace forge
