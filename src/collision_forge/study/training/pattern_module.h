#pragma once

#include <torch/torch.h>

#include <map>
#include <string>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/network/pattern_weights.h"
#include "collision_forge/study/training/pattern_batch.h"

namespace forge {

/// The network of PatternNetwork, to be trained.
class PatternModuleImpl : public torch::nn::Module {
 public:
  /// `dropout` of single numbers, `context_dropout` of all that is told of other agents and lanes.
  PatternModuleImpl(const PatternNetworkOptions& options, double dropout, double context_dropout);

  torch::Tensor encode(const PatternBatch& batch);  ///< [B, scene]
  torch::Tensor withRequest(const torch::Tensor& scene, const torch::Tensor& requests);
  /// [B, T, G * K, 6]; the prior is in the score.
  torch::Tensor ego(const torch::Tensor& with_request, const PatternBatch& batch);
  /// [A, C, 5]
  torch::Tensor candidates(const torch::Tensor& with_request, const torch::Tensor& features);

 private:
  torch::nn::Linear layer(const std::string& name) { return layers_.at(name); }
  torch::Tensor polylines(const torch::Tensor& vectors, const torch::Tensor& mask,
                          const std::string& name);

  PatternNetworkOptions options_;
  double context_dropout_ = 0.0;
  std::map<std::string, torch::nn::Linear> layers_;
  torch::nn::Dropout dropout_;
};
TORCH_MODULE(PatternModule);

/// Each [1] and differentiable; offset and selection by the layers candidate_* alone.
struct BatchLosses {
  torch::Tensor ego;
  torch::Tensor heading;
  torch::Tensor offset;
  torch::Tensor selection;
};
BatchLosses lossesOf(PatternModule& module, const PatternBatch& batch);

}  // namespace forge
