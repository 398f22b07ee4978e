#pragma once

#include <memory>
#include <vector>

#include "collision_forge/study/generators/traffic_generator.h"

namespace forge {

/// The noise schedule of a diffusion model, for steps 0 to MidOptions::diffusion_steps.
struct NoiseSchedule {
  std::vector<double> beta;       ///< noise variance of step t at index t; 0 at index 0
  std::vector<double> alpha_bar;  ///< product of 1 - beta up to step t; 1 at index 0
};

/// Returns the schedule with betas linearly spaced from `beta_first` at step 1 to `beta_last` at
/// the last step.
NoiseSchedule noiseSchedule(const MidOptions& options);

/// Creates C-MID: MID (Gu et al., CVPR 2022, arXiv 2203.13777), a diffusion model of futures, with
/// the request's type and time as additional input of the denoiser (arXiv 2510.12206, Sec. 4). The
/// .cpp lists deviations. Created in evaluation mode; in training mode predict() applies dropout.
/// predict() throws std::runtime_error for values that are not finite.
std::shared_ptr<TrafficGenerator> makeMid(const MidOptions& options, const TrafficOptions& traffic,
                                          torch::Device device);

}  // namespace forge
