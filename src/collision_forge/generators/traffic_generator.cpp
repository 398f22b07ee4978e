#include "collision_forge/generators/traffic_generator.h"

#include <ATen/CPUGeneratorImpl.h>

#include <stdexcept>

#include "collision_forge/generators/social_gan.h"

namespace forge {

std::unique_ptr<TrafficGenerator> makeGenerator(const std::string& name,
                                                const GeneratorOptions& options,
                                                torch::Device device, std::uint64_t seed) {
  torch::manual_seed(seed);
  if (name == "c_sgan") return makeSocialGan(options.c_sgan, options.traffic, device);
  throw std::invalid_argument("generator \"" + name + "\" is none of c_sgan");
}

torch::Generator noiseOf(std::uint64_t seed) { return at::detail::createCPUGenerator(seed); }

torch::Tensor yawsAlong(const torch::Tensor& steps, torch::Tensor yaw, double min_step) {
  std::vector<torch::Tensor> yaws;
  for (long t = 0; t < steps.size(2); ++t) {
    const torch::Tensor step = steps.select(2, t);
    const torch::Tensor along = torch::atan2(step.select(2, 1), step.select(2, 0));
    yaw = torch::where(step.norm(2, 2) < min_step, yaw, along);
    yaws.push_back(yaw);
  }
  return torch::stack(yaws, 2);
}

}  // namespace forge
