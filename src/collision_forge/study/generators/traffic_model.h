#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/study/generators/traffic_batch.h"

namespace forge {

/// An error summed over what it counts.
struct ErrorSum {
  double sum = 0.0;
  double count = 0.0;
};

/// A model of the literature that learns from clips: what its training, its file and its methods
/// need. The const members may be called from many threads, training from one.
class TrafficModel : public std::enable_shared_from_this<TrafficModel> {
 public:
  virtual ~TrafficModel() = default;

  /// What trainStep() tells, in this order.
  virtual std::vector<std::string> lossNames() const = 0;
  /// One step of training on a batch with its future; NaN for a loss that this step does not have.
  virtual std::vector<double> trainStep(const TrafficBatch& batch) = 0;

  /// What errorsOn() tells, in this order, with the unit at the end; the last one chooses the best
  /// epoch.
  virtual std::vector<std::string> errorNames() const = 0;
  virtual std::vector<ErrorSum> errorsOn(const TrafficBatch& batch,
                                         torch::Generator noise) const = 0;

  virtual int epochs() const = 0;
  virtual int batchSize() const = 0;
  /// What its clips and batches are made with.
  virtual const TrafficOptions& traffic() const = 0;

  /// What is learned.
  virtual std::shared_ptr<torch::nn::Module> network() const = 0;
  /// The rest of what going on with training takes.
  virtual void saveTraining(torch::serialize::OutputArchive& archive) const = 0;
  virtual void loadTraining(torch::serialize::InputArchive& archive) = 0;

  /// One of the methods that live on this model, by its name.
  virtual std::unique_ptr<const AttackMethod> method(const std::string& name,
                                                     const AttackOptions& options) const = 0;
};

/// A source of random numbers of its own.
torch::Generator noiseOf(std::uint64_t seed);

}  // namespace forge
