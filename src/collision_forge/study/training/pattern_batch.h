#pragma once

#include <torch/torch.h>

#include <vector>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/study/training/options.h"
#include "collision_forge/study/training/training_draw.h"

namespace forge {

/// A batch of B samples on one device, with T prediction times, G groups of K anchors each and at
/// most C candidates per attack. A of the samples have an attack (A and thus the first dimension of
/// their tensors may be 0). Positions are in m, in the frame of the ego's box at t0; features are
/// scaled (SceneFeatures, AnchorFeatures, requestFeatures(), candidateFeatures()). Masks are 1 for
/// an entry, 0 for padding. All tensors are float, except for the indices attack_rows and attacker
/// (int64).
struct PatternBatch {
  torch::Tensor agents;  ///< [B, agents, frames, kAgentVector], the ego first, the frame at t0 last
  torch::Tensor agent_mask;  ///< [B, agents, frames]
  torch::Tensor lanes;       ///< [B, lanes, points, kLaneVector]
  torch::Tensor lane_mask;   ///< [B, lanes, points]
  torch::Tensor ego;         ///< [B, kEgoFeatures]
  torch::Tensor requests;   ///< [B, T, kRequestFeatures]: the time, and the type at the impact only
  torch::Tensor groups;     ///< [B, T, G, kGroupFeatures]
  torch::Tensor anchors;    ///< [B, T, G, K, kAnchorFeatures]
  torch::Tensor prior;      ///< [B, T, G * K]: AnchorFeatures::prior, kAbsent for a missing anchor
  torch::Tensor poses;      ///< [B, T, G * K, 4]: x, y, cos, sin of the anchors
  torch::Tensor scales;     ///< [B, T, 2]: m, along and across the anchor's heading
  torch::Tensor ego_truth;  ///< [B, T, 4]: x, y, cos, sin of the recorded pose
  torch::Tensor time_weight;      ///< [B, T]: loss weight of the time
  torch::Tensor attack_requests;  ///< [A, kRequestFeatures]: the time of the impact and the type
  /// [A]: indices in the batch of the samples with an attack, ascending.
  torch::Tensor attack_rows;
  torch::Tensor candidates;         ///< [A, C, kCandidateFeatures], for the expected ego pose
  torch::Tensor candidate_mask;     ///< [A, C]
  torch::Tensor attacker;           ///< [A]: index of the true attacker among the candidates
  torch::Tensor attacker_features;  ///< [A, 1, kCandidateFeatures], for the true ego pose
  /// [A, 4]: AttackSample::offset, x and y in units of kOffsetScale, cos, sin.
  torch::Tensor offset_truth;
};

/// Returns the batch of the draws, in their order, on the CPU. `draws` must not be empty, and all
/// must have the same number of times; the samples must have been made with `features`.
PatternBatch batchOf(const std::vector<TrainingDraw>& draws, const PatternFeatureOptions& features,
                     const TrainingOptions& options);

/// Returns the batch on a device, with floating-point tensors of type `type`. Index tensors keep
/// theirs.
PatternBatch movedTo(const PatternBatch& batch, const torch::Device& device,
                     torch::Dtype type = torch::kFloat32);

}  // namespace forge
