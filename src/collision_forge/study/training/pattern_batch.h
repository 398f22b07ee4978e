#pragma once

#include <torch/torch.h>

#include <vector>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/study/training/options.h"
#include "collision_forge/study/training/training_draw.h"

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

/// On the CPU. Every draw has as many times; all samples are made with `features`.
PatternBatch batchOf(const std::vector<TrainingDraw>& draws, const PatternFeatureOptions& features,
                     const TrainingOptions& options);

PatternBatch movedTo(const PatternBatch& batch, const torch::Device& device,
                     torch::Dtype type = torch::kFloat32);

}  // namespace forge
