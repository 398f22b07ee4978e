#pragma once

#include <torch/torch.h>

#include <string>

#include "collision_forge/study/training/training_error.h"

namespace forge {

/// Returns the device named "cpu" or "cuda". Throws TrainingError for another name or if CUDA is
/// not available.
torch::Device trainingDevice(const std::string& name);

}  // namespace forge
