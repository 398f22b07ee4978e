#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/network/pattern_weights.h"
#include "collision_forge/study/training/options.h"
#include "collision_forge/study/training/training_error.h"
#include "collision_forge/study/training/training_sample.h"

namespace forge {

/// Mean losses over the samples, `ego` and `heading` over their prediction times, too; see
/// lossesOf().
struct TrainingLosses {
  double ego = 0.0;  ///< negative log of the predicted density (1/m2) at the ego's true position
  double heading = 0.0;  ///< 1 - cos of the error of the ego's heading
  double offset = 0.0;  ///< smooth L1 of the attacker's offset, x and y in units of kOffsetScale; 0
                        ///< without attacks
  double selection = 0.0;  ///< cross entropy of the choice of the attacker; 0 without attacks
  double total = 0.0;      ///< sum with the weights of TrainingOptions
};

/// Trains a collision-pattern network. Deterministic on one machine with one thread: the same
/// samples, options and seed give the same weights, also if the training is interrupted between
/// epochs and resumed with load(state()). Not thread-safe.
class PatternTrainer {
 public:
  /// `device`: "cpu" or "cuda"; `threads`: CPU threads of libtorch. Throws TrainingError if CUDA is
  /// not available. Sets the threads and the seed of libtorch for the whole process.
  PatternTrainer(const PatternFeatureOptions& features, const PatternNetworkOptions& network,
                 const TrainingOptions& options, const std::string& device, int threads,
                 std::uint64_t seed);
  ~PatternTrainer();

  /// Returns the number of epochs trained, including the epochs of a loaded state.
  int epochsDone() const;

  /// Trains one epoch on the samples with the indices `chosen` into `samples` (not empty), in
  /// random order; the last batch may be smaller. Calls `on_batch`, if set, on the same thread
  /// after each batch with the number of samples done in this epoch. Returns the mean losses over
  /// the epoch, each from before its step.
  TrainingLosses trainEpoch(const std::vector<TrainingSample>& samples,
                            const std::vector<std::size_t>& chosen,
                            const std::function<void(std::size_t)>& on_batch = nullptr);

  /// Returns the mean losses of the averaged weights (weights()) on the samples with the indices
  /// `chosen` (0 if there are none), without dropout and with a fixed choice of times and noise.
  TrainingLosses losses(const std::vector<TrainingSample>& samples,
                        const std::vector<std::size_t>& chosen);

  /// Returns the exponential moving average of the weights over the last few hundred steps.
  PatternWeights weights() const;

  /// Returns the complete training state (weights, average, optimizer, progress), as the content of
  /// a file for load().
  std::string state() const;
  /// Restores a state from a file. Throws TrainingError, naming `path`, if the file is missing,
  /// damaged, or of a training with another seed or network.
  void load(const std::string& path);

  /// For tests: returns the total loss of the current (not averaged) weights and, unless null,
  /// stores its `gradients` by layer name, the matrix row by row, then the bias. Converts the
  /// weights to double precision; the trainer must not train afterwards.
  double lossAndGradients(const std::vector<TrainingSample>& samples,
                          std::map<std::string, std::vector<double>>* gradients);
  /// For tests: adds `change` to weight `number` of a layer, counted as in lossAndGradients().
  void nudge(const std::string& layer, std::size_t number, double change);
  /// Returns the current weights, without averaging.
  PatternWeights currentWeights() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace forge
