#pragma once

#include <torch/torch.h>

#include <vector>

#include "collision_forge/study/generators/traffic_clip.h"

namespace forge {

/// Numbers that say what is asked for: the type, one of five, and the time that is left.
inline constexpr int kConditionNumbers = 6;

/// arXiv 2510.12206: N = (FRAME - 8) / 12.
inline constexpr double kTtaFrames = 12.0;

/// Numbers of a point of a lane: x and y in m, cos and sin of the heading, 1 in an intersection.
inline constexpr int kLaneNumbers = 5;

/// Some frames of a clip: `history_frames` up to frame `now`, and what came after it.
struct TrafficWindow {
  const TrafficClip* clip = nullptr;
  int now = 0;
};

/// Windows as tensors: B of them, A agents, T frames, L pieces of lanes of P points. Frame of the
/// window's ego at its now.
struct TrafficBatch {
  torch::Tensor poses;      ///< [B, A, T, 3] x and y in m, yaw in rad; 0 where nobody is seen
  torch::Tensor seen;       ///< [B, A, T] 1 where an agent is seen, else 0
  torch::Tensor condition;  ///< [B, 6] one-hot type; (collision_frame - now - 1) / 12
  torch::Tensor lanes;      ///< [B, L, P, 5] kLaneNumbers, nearest to ego or attacker first
  torch::Tensor lane_seen;  ///< [B, L, P] 1 where there is a point, else 0
};

/// With `future_frames` frames after each window's now; 0: the history alone.
TrafficBatch batchOf(const std::vector<TrafficWindow>& windows, const TrafficOptions& options,
                     int future_frames);

/// All windows of a clip that have one known frame of future at least.
std::vector<TrafficWindow> windowsOf(const TrafficClip& clip, const TrafficOptions& options);

/// The same on a device.
TrafficBatch movedTo(const TrafficBatch& batch, torch::Device device);

/// Everything but [B, A, T, 3] to a batch's first T frames.
TrafficBatch historyOf(const TrafficBatch& batch, int history_frames);

/// [B, A] 1 for who is seen in each of these frames.
torch::Tensor seenThroughout(const TrafficBatch& batch, int frames);

}  // namespace forge
