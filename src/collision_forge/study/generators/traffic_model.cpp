#include "collision_forge/study/generators/traffic_model.h"

#include <ATen/CPUGeneratorImpl.h>

namespace forge {

torch::Generator noiseOf(std::uint64_t seed) { return at::detail::createCPUGenerator(seed); }

}  // namespace forge
