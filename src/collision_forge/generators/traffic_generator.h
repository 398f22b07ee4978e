#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/generators/traffic_batch.h"

namespace forge {

/// A learned model of how traffic drives on for a few frames, given a collision type and the time
/// to it. prediction may be asked from many threads, training from one.
class TrafficGenerator {
 public:
  virtual ~TrafficGenerator() = default;

  /// Poses [B, A, future_frames, 3] that follow a batch of histories, in its frame; those of agents
  /// that were not seen throughout mean nothing. The same `noise` gives the same poses.
  virtual torch::Tensor predict(const TrafficBatch& history, torch::Generator noise) const = 0;

  /// What trainStep() tells, in this order.
  virtual std::vector<std::string> lossNames() const = 0;
  /// One step of training on a batch with its future; NaN for a loss that this step does not have.
  virtual std::vector<double> trainStep(const TrafficBatch& batch) = 0;

  virtual int epochs() const = 0;
  virtual int batchSize() const = 0;

  /// What predict() needs.
  virtual std::shared_ptr<torch::nn::Module> network() const = 0;
  /// The rest of what going on with training takes.
  virtual void saveTraining(torch::serialize::OutputArchive& archive) const = 0;
  virtual void loadTraining(torch::serialize::InputArchive& archive) = 0;
};

/// Throws std::invalid_argument for an unknown name. `seed` of the weights before training.
std::unique_ptr<TrafficGenerator> makeGenerator(const std::string& name,
                                                const GeneratorOptions& options,
                                                torch::Device device, std::uint64_t seed);

/// A source of random numbers of its own.
torch::Generator noiseOf(std::uint64_t seed);

/// Yaws [B, A, T] along steps [B, A, T, 2] in m, from `yaw` [B, A] on; kept in steps shorter than
/// `min_step`.
torch::Tensor yawsAlong(const torch::Tensor& steps, torch::Tensor yaw, double min_step);

}  // namespace forge
