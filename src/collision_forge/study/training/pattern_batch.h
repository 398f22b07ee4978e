#pragma once

#include <torch/torch.h>

#include <vector>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/study/training/options.h"
#include "collision_forge/study/training/training_draw.h"

namespace forge {

/// A batch of B samples on one device, with T prediction times, G groups of K anchors and C
/// candidates each. A of the samples have an attack. Poses are in the ego's frame at t0, in m.
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
  torch::Tensor scales;             ///< [B, T, 2]: m, along and across the anchor's heading
  torch::Tensor ego_truth;          ///< [B, T, 4]: x, y, cos, sin of the recorded pose
  torch::Tensor time_weight;        ///< [B, T]
  torch::Tensor attack_requests;    ///< [A, kRequestFeatures]
  torch::Tensor attack_rows;        ///< [A]: indices of the samples with an attack
  torch::Tensor candidates;         ///< [A, C, kCandidateFeatures], for the expected ego pose
  torch::Tensor candidate_mask;     ///< [A, C]: 1 for a candidate, 0 for padding
  torch::Tensor attacker;           ///< [A]: index of the true attacker among the candidates
  torch::Tensor attacker_features;  ///< [A, 1, kCandidateFeatures], for the true ego pose
  torch::Tensor offset_truth;       ///< [A, 4]: x, y in units of kOffsetScale, cos, sin
};

/// Returns a batch on the CPU. `draws` must not be empty, and all must have the same number of
/// times; the samples must have been made with `features`.
PatternBatch batchOf(const std::vector<TrainingDraw>& draws, const PatternFeatureOptions& features,
                     const TrainingOptions& options);

/// Returns the batch on a device, with floating-point tensors of type `type`.
PatternBatch movedTo(const PatternBatch& batch, const torch::Device& device,
                     torch::Dtype type = torch::kFloat32);

}  // namespace forge
