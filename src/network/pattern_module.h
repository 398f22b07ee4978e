#pragma once

#include <torch/torch.h>

#include <map>
#include <string>

#include "network/network_options.h"
#include "network/pattern_weights.h"

namespace forge {

/// A batch of B samples on one device; T times each, G groups of K anchors, C candidates.
struct PatternBatch {
  torch::Tensor agents;             ///< [B, agents, frames, kAgentVector]
  torch::Tensor agent_mask;         ///< [B, agents, frames]
  torch::Tensor lanes;              ///< [B, lanes, points, kLaneVector]
  torch::Tensor lane_mask;          ///< [B, lanes, points]
  torch::Tensor ego;                ///< [B, kEgoFeatures]
  torch::Tensor requests;           ///< [B, T, kRequestFeatures]
  torch::Tensor groups;             ///< [B, T, G, kGroupFeatures]
  torch::Tensor anchors;            ///< [B, T, G, K, kAnchorFeatures]
  torch::Tensor prior;              ///< [B, T, G * K]
  torch::Tensor poses;              ///< [B, T, G * K, 4]
  torch::Tensor scales;             ///< [B, T, 2]: along, across
  torch::Tensor ego_truth;          ///< [B, T, 4]: x, y, cos, sin
  torch::Tensor time_weight;        ///< [B, T]
  torch::Tensor attack_requests;    ///< [A, kRequestFeatures]
  torch::Tensor attack_rows;        ///< [A]: which samples have an attack
  torch::Tensor candidates;         ///< [A, C, kCandidateFeatures], by the ego's expected pose
  torch::Tensor candidate_mask;     ///< [A, C]
  torch::Tensor attacker;           ///< [A]
  torch::Tensor attacker_features;  ///< [A, 1, kCandidateFeatures], by the ego's true pose
  torch::Tensor offset_truth;       ///< [A, 4]: x, y over their scale, cos, sin
};

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

/// Each [1] and differentiable.
struct BatchLosses {
  torch::Tensor ego;
  torch::Tensor heading;
  torch::Tensor offset;
  torch::Tensor selection;
};
BatchLosses lossesOf(PatternModule& module, const PatternBatch& batch);

}  // namespace forge
