#pragma once

#include <memory>
#include <vector>

#include "collision_forge/study/generators/traffic_generator.h"

namespace forge {

/// How much noise each step of a diffusion adds, and what is left of the signal after it.
struct NoiseSchedule {
  std::vector<double> beta;       ///< of step t at index t; 0 at index 0, the signal itself
  std::vector<double> alpha_bar;  ///< product of 1 - beta up to step t; 1 at index 0
};

/// Betas at equal distances from `beta_first` to `beta_last`.
NoiseSchedule noiseSchedule(const MidOptions& options);

/// C-MID: MID (Gu et al., CVPR 2022, arXiv 2203.13777), a diffusion model of futures, with the
/// request's type and time beside what its denoiser sees (arXiv 2510.12206, Sec. 4). What is
/// simplified or left to choose is named in the source. Predicts with the dropout of its network's
/// mode; made in that of evaluation. Throws std::runtime_error where the diffusion leaves the
/// finite numbers.
std::shared_ptr<TrafficGenerator> makeMid(const MidOptions& options, const TrafficOptions& traffic,
                                          torch::Device device);

}  // namespace forge
