#pragma once

#include <memory>

#include "collision_forge/study/generators/traffic_generator.h"

namespace forge {

/// C-SGAN: Social-GAN (Gupta et al., CVPR 2018, arXiv 1803.10892) with the request's type and time
/// at every step of its decoder (arXiv 2510.12206, Sec. 4). What is simplified or left to choose is
/// named in the source.
std::shared_ptr<TrafficGenerator> makeSocialGan(const SocialGanOptions& options,
                                                const TrafficOptions& traffic,
                                                torch::Device device);

}  // namespace forge
