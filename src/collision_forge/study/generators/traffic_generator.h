#pragma once

#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

/// A learned model that predicts the motion of all agents for a few frames, given a collision type
/// and the remaining time. Thread-safe.
class TrafficGenerator : public TrafficModel {
 public:
  explicit TrafficGenerator(const TrafficOptions& traffic) : traffic_(traffic) {}

  /// Predicts poses [B, A, future_frames, 3] in the frame of the batch. Poses of agents that are
  /// not observed in the whole history are undefined. Deterministic for a given state of `noise`.
  /// Called by rollOut() once per iteration, from several threads.
  virtual torch::Tensor predict(const TrafficBatch& history, torch::Generator noise) const = 0;

  /// The errors are mean displacements (m) over one prediction: of the attacker, then of all
  /// agents.
  std::vector<std::string> errorNames() const override;
  std::vector<ErrorSum> errorsOn(const TrafficBatch& batch, torch::Generator noise) const override;

  const TrafficOptions& traffic() const override { return traffic_; }

  /// Returns a GeneratorMethod for any name.
  std::unique_ptr<const AttackMethod> method(const AttackOptions& options) const override;

 private:
  TrafficOptions traffic_;
};

/// Returns the yaws [B, A, T] along steps [B, A, T, 2] (m), starting with `yaw` [B, A]; steps
/// shorter than `min_step` (m) keep the previous yaw.
torch::Tensor yawsAlong(const torch::Tensor& steps, torch::Tensor yaw, double min_step);

}  // namespace forge
