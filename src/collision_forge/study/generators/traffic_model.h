#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/study/generators/traffic_batch.h"

namespace forge {

/// A sum of errors with the number of summands; sum / count is the mean error.
struct ErrorSum {
  double sum = 0.0;    ///< in the unit of errorNames()
  double count = 0.0;  ///< number of summands, may be 0
};

/// Interface of a learned baseline from the literature, trained on clips. The training run, the
/// weight file and the attack methods use it. Const members are called from several threads, the
/// others from the training thread. Members may throw std::runtime_error (torch's c10::Error),
/// which ends the training or the request.
class TrafficModel : public std::enable_shared_from_this<TrafficModel> {
 public:
  virtual ~TrafficModel() = default;

  /// Returns the names of the losses of trainStep(), in its order.
  virtual std::vector<std::string> lossNames() const = 0;
  /// Trains one step on a batch with future frames. Called by the training run for each batch.
  /// Returns the losses, NaN for a loss that this step does not compute. May throw
  /// std::runtime_error, which ends the training.
  virtual std::vector<double> trainStep(const TrafficBatch& batch) = 0;

  /// Returns the names of the errors of errorsOn(), in its order, with the unit at the end
  /// ("attacker_m"). The last one selects the best epoch: lower is better.
  virtual std::vector<std::string> errorNames() const = 0;
  /// Returns the errors on a batch with future frames, summed. `noise` is the source of all random
  /// numbers. Called after each epoch on validation data, with the network in eval mode. Must not
  /// change the model.
  virtual std::vector<ErrorSum> errorsOn(const TrafficBatch& batch,
                                         torch::Generator noise) const = 0;

  /// Returns the number of epochs of a complete training.
  virtual int epochs() const = 0;
  /// Returns the number of windows (clips) per batch of the training.
  virtual int batchSize() const = 0;
  /// Returns the options with which clips and batches for this model must be made.
  virtual const TrafficOptions& traffic() const = 0;

  /// Returns the module with all trainable weights.
  virtual std::shared_ptr<torch::nn::Module> network() const = 0;
  /// Save to and restore from an archive the training state besides the weights, e.g. of
  /// optimizers.
  virtual void saveTraining(torch::serialize::OutputArchive& archive) const = 0;
  virtual void loadTraining(torch::serialize::InputArchive& archive) = 0;

  /// Returns the attack method based on this model. The method keeps the model alive.
  virtual std::unique_ptr<const AttackMethod> method(const AttackOptions& options) const = 0;
};

/// Returns a new CPU random number generator with the given seed.
torch::Generator noiseOf(std::uint64_t seed);

}  // namespace forge
