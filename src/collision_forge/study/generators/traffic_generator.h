#pragma once

#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

/// A learned model that predicts the motion of all agents for a few frames, given a collision type
/// and the remaining time. Thread-safe.
class TrafficGenerator : public TrafficModel {
 public:
  /// `traffic`: TrafficModel::traffic() of this model.
  explicit TrafficGenerator(const TrafficOptions& traffic) : traffic_(traffic) {}

  /// Returns predicted poses [B, A, future_frames, 3] (x and y in m, yaw in rad) of the frames
  /// after t0, in the frame of the batch. `history`: a batch of history_frames frames. Poses of
  /// agents that are not observed in the whole history are undefined. Deterministic for a given
  /// state of `noise`. Called by rollOut() once per iteration, from several threads.
  virtual torch::Tensor predict(const TrafficBatch& history, torch::Generator noise) const = 0;

  /// Returns {"attacker_m", "all_m"}: displacements (m) in the frames of one prediction, of the
  /// attacker, then of all agents (attacker and ego included), both only if observed in the whole
  /// history and in the frame.
  std::vector<std::string> errorNames() const override;
  std::vector<ErrorSum> errorsOn(const TrafficBatch& batch, torch::Generator noise) const override;

  const TrafficOptions& traffic() const override { return traffic_; }

  /// Returns a GeneratorMethod with this model.
  std::unique_ptr<const AttackMethod> method(const AttackOptions& options) const override;

 private:
  TrafficOptions traffic_;
};

/// Returns the yaws [B, A, T] (rad) at the end of the steps [B, A, T, 2] (m): the direction of each
/// step; steps shorter than `min_step` (m) keep the previous yaw. `yaw` [B, A] is the yaw before
/// the first step.
torch::Tensor yawsAlong(const torch::Tensor& steps, torch::Tensor yaw, double min_step);

}  // namespace forge
