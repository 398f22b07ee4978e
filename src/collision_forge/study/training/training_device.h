#pragma once

#include <torch/torch.h>

#include <string>

#include "collision_forge/study/training/training_error.h"

namespace forge {

/// "cpu" or "cuda". Throws TrainingError for CUDA where there is none.
torch::Device trainingDevice(const std::string& name);

}  // namespace forge
