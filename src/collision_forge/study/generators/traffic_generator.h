#pragma once

#include "collision_forge/study/generators/traffic_model.h"

namespace forge {

/// A learned model of how traffic drives on for a few frames, given a collision type and the time
/// to it.
class TrafficGenerator : public TrafficModel {
 public:
  explicit TrafficGenerator(const TrafficOptions& traffic) : traffic_(traffic) {}

  /// Poses [B, A, future_frames, 3] that follow a batch of histories, in its frame; those of agents
  /// that were not seen throughout mean nothing. The same `noise` gives the same poses.
  virtual torch::Tensor predict(const TrafficBatch& history, torch::Generator noise) const = 0;

  /// The mean distance between what is driven and what came over one iteration: of the attacker,
  /// then of everybody.
  std::vector<std::string> errorNames() const override;
  std::vector<ErrorSum> errorsOn(const TrafficBatch& batch, torch::Generator noise) const override;

  const TrafficOptions& traffic() const override { return traffic_; }

  /// GeneratorMethod, whatever the name.
  std::unique_ptr<const AttackMethod> method(const std::string& name,
                                             const AttackOptions& options) const override;

 private:
  TrafficOptions traffic_;
};

/// Yaws [B, A, T] along steps [B, A, T, 2] in m, from `yaw` [B, A] on; kept in steps shorter than
/// `min_step`.
torch::Tensor yawsAlong(const torch::Tensor& steps, torch::Tensor yaw, double min_step);

}  // namespace forge
