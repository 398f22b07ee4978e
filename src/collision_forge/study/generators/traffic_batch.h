#pragma once

#include <torch/torch.h>

#include <vector>

#include "collision_forge/study/generators/traffic_clip.h"

namespace forge {

/// Size of the condition vector: one-hot collision type (5) and remaining time.
inline constexpr int kConditionNumbers = 6;

/// Divisor of the remaining frames in the condition; arXiv 2510.12206: N = (FRAME - 8) / 12.
inline constexpr double kTtaFrames = 12.0;

/// Size of a lane point: x and y (m), cos and sin of the heading, 1 in an intersection.
inline constexpr int kLaneNumbers = 5;

/// A window of a clip: `history_frames` frames up to frame `now`, and the frames after it.
struct TrafficWindow {
  const TrafficClip* clip = nullptr;  ///< must outlive the window
  int now = 0;                        ///< index of the frame at t0
};

/// Windows as tensors (float): B windows, A agents, T frames, L lane pieces of P points.
/// Coordinates are in the frame of the window's ego at t0. Agents are in the order of
/// TrafficClip::agents (0: the ego, 1: the attacker); frame history_frames - 1 is t0.
struct TrafficBatch {
  torch::Tensor poses;      ///< [B, A, T, 3] x and y in m, yaw in rad; 0 if not observed
  torch::Tensor seen;       ///< [B, A, T] 1 if the agent is observed in the frame, else 0
  torch::Tensor condition;  ///< [B, 6] one-hot type in the order of kCollisionTypes, the only types
                            ///< that models know; last (collision_frame - now - 1) / kTtaFrames
  torch::Tensor lanes;      ///< [B, L, P, 5] kLaneNumbers, nearest to ego or attacker first
  torch::Tensor lane_seen;  ///< [B, L, P] 1 where there is a point, else 0
};

/// Returns the batch of the windows (at least one), on the CPU, with `future_frames` frames after
/// t0; 0: history only. Frames beyond the end of a clip count as not observed. A and L are the
/// largest numbers in a window; smaller windows are padded with unobserved agents and missing
/// lanes. Ego and attacker must be observed at each `now`.
TrafficBatch batchOf(const std::vector<TrafficWindow>& windows, const TrafficOptions& options,
                     int future_frames);

/// Returns the windows of a clip whose history is complete and whose future_frames end at the crash
/// at the latest, one per frame, by ascending t0; if there is none, the window with the earliest t0
/// (frame history_frames - 1). `clip` must outlive them.
std::vector<TrafficWindow> windowsOf(const TrafficClip& clip, const TrafficOptions& options);

/// Returns the batch on a device.
TrafficBatch movedTo(const TrafficBatch& batch, torch::Device device);

/// Returns the batch with the first `history_frames` frames only; the tensors share memory with
/// `batch`.
TrafficBatch historyOf(const TrafficBatch& batch, int history_frames);

/// Returns [B, A] with 1 for agents that are observed in all of the first `frames` frames, else 0.
torch::Tensor seenThroughout(const TrafficBatch& batch, int frames);

}  // namespace forge
