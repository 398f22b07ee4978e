#pragma once

#include <torch/torch.h>

#include <map>
#include <string>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/network/pattern_weights.h"
#include "collision_forge/study/training/pattern_batch.h"

namespace forge {

/// The trainable counterpart of PatternNetwork, with the same layers. Shapes as in PatternBatch.
class PatternModuleImpl : public torch::nn::Module {
 public:
  /// `dropout`: probability to drop single activations; `context_dropout`: probability to drop the
  /// whole context (other agents and lanes) of a sample. Both apply in training mode only.
  PatternModuleImpl(const PatternNetworkOptions& options, double dropout, double context_dropout);

  /// Returns the encoded scenes [B, PatternNetworkOptions::scene].
  torch::Tensor encode(const PatternBatch& batch);
  /// Joins encoded scenes [..., scene] with the features of a request each, [...,
  /// kRequestFeatures]; returns a tensor of the shape of `scene`.
  torch::Tensor withRequest(const torch::Tensor& scene, const torch::Tensor& requests);
  /// Returns [B, T, G * K, 6] for the anchors: score (a logit, including the prior), mean offset
  /// along and across the anchor's heading in units of batch.scales, log of the spread along and
  /// across in the same units, turn from the anchor's heading (rad). `with_request`: withRequest()
  /// [B, T, scene].
  torch::Tensor ego(const torch::Tensor& with_request, const PatternBatch& batch);
  /// Returns [A, C, 5] for candidates: score (a logit), then x, y (units of kOffsetScale), cos, sin
  /// of the attacker's offset if it is this candidate. `with_request`: withRequest() [A, scene];
  /// `features`: [A, C, kCandidateFeatures].
  torch::Tensor candidates(const torch::Tensor& with_request, const torch::Tensor& features);

 private:
  /// Returns a layer of layerShapes().
  torch::nn::Linear layer(const std::string& name) { return layers_.at(name); }
  /// Returns the features [B, polylines, hidden] of polylines of masked vectors; `name`: "agent" or
  /// "lane".
  torch::Tensor polylines(const torch::Tensor& vectors, const torch::Tensor& mask,
                          const std::string& name);

  PatternNetworkOptions options_;
  double context_dropout_ = 0.0;
  std::map<std::string, torch::nn::Linear> layers_;
  torch::nn::Dropout dropout_;
};
TORCH_MODULE(PatternModule);

/// Scalar differentiable losses, without the weights of TrainingOptions. Offset and selection train
/// only the layers candidate_*.
struct BatchLosses {
  torch::Tensor ego;        ///< as TrainingLosses::ego
  torch::Tensor heading;    ///< as TrainingLosses::heading
  torch::Tensor offset;     ///< as TrainingLosses::offset
  torch::Tensor selection;  ///< as TrainingLosses::selection
};
/// Returns the losses of a batch (tensors without dimensions); offset and selection are 0 without
/// attacks in it.
BatchLosses lossesOf(PatternModule& module, const PatternBatch& batch);

}  // namespace forge
