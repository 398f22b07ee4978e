#include "collision_forge/study/generators/traffic_generator.h"

namespace forge {

std::vector<std::string> TrafficGenerator::errorNames() const { return {"attacker_m", "all_m"}; }

std::vector<ErrorSum> TrafficGenerator::errorsOn(const TrafficBatch& batch,
                                                 torch::Generator noise) const {
  const TrafficBatch history = historyOf(batch, traffic_.history_frames);
  const torch::Tensor came = batch.poses.slice(2, traffic_.history_frames);
  const torch::Tensor counted = batch.seen.slice(2, traffic_.history_frames) *
                                seenThroughout(history, traffic_.history_frames).unsqueeze(2);
  const torch::Tensor apart = (predict(history, noise) - came).slice(3, 0, 2).norm(2, 3) * counted;
  const auto attacker = static_cast<long>(kAttackerAgent);
  const auto sumOf = [](const torch::Tensor& numbers) {
    return numbers.sum(torch::kFloat64).item<double>();
  };
  return {{sumOf(apart.select(1, attacker)), sumOf(counted.select(1, attacker))},
          {sumOf(apart), sumOf(counted)}};
}

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
