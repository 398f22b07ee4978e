#include "collision_forge/study/training/training_device.h"

namespace forge {

torch::Device trainingDevice(const std::string& name) {
  if (name == "cpu") return torch::Device(torch::kCPU);
  if (name != "cuda") throw TrainingError("device = " + name + " is neither cpu nor cuda");
  if (!torch::cuda::is_available()) {
    throw TrainingError("device = cuda: this libtorch finds no CUDA device; use cpu");
  }
  return torch::Device(torch::kCUDA);
}

}  // namespace forge
