#pragma once

#include <memory>

#include "collision_forge/study/generators/traffic_generator.h"

namespace forge {

/// Creates C-SGAN: Social-GAN (Gupta et al., CVPR 2018, arXiv 1803.10892) with the request's type
/// and time as input of each decoder step (arXiv 2510.12206, Sec. 4). The .cpp lists deviations.
std::shared_ptr<TrafficGenerator> makeSocialGan(const SocialGanOptions& options,
                                                const TrafficOptions& traffic,
                                                torch::Device device);

}  // namespace forge
