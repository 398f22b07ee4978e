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

/// Means over the samples that have them.
struct TrainingLosses {
  double ego = 0.0;        ///< negative logarithm of the density (1/m2) at where the ego went
  double heading = 0.0;    ///< 1 - cos of the error
  double offset = 0.0;     ///< smooth L1
  double selection = 0.0;  ///< cross entropy
  double total = 0.0;      ///< weighed as TrainingOptions have it
};

/// This process among those that train one network together, each on its part of every batch.
struct TrainingRanks {
  int rank = 0;
  int size = 1;
  /// Replaces numbers by their sums over all ranks, to the same bits everywhere; every rank calls
  /// it as often. Not needed by one alone.
  std::function<void(std::vector<double>&)> sum;
};

/// Trains a pattern network. The same samples, options and seed give the same weights on the same
/// machine with one thread; a run that is stopped between epochs and goes on from its saved state
/// as well.
class PatternTrainer {
 public:
  /// `device` is "cpu" or "cuda". Throws TrainingError for CUDA where there is none.
  PatternTrainer(const PatternFeatureOptions& features, const PatternNetworkOptions& network,
                 const TrainingOptions& options, const std::string& device, int threads,
                 std::uint64_t seed);
  ~PatternTrainer();

  /// Gradients are averaged over the ranks from now on. All have the same samples, options and
  /// seed, and the same result; for as many ranks always the same one, for others another.
  void trainTogether(TrainingRanks ranks);

  int epochsDone() const;

  /// One pass over `chosen` of the samples in random order. `on_batch` is told the samples done.
  /// Throws TrainingError when the ranks do not hold the same weights afterwards.
  TrainingLosses trainEpoch(const std::vector<TrainingSample>& samples,
                            const std::vector<std::size_t>& chosen,
                            const std::function<void(std::size_t)>& on_batch = nullptr);

  /// Without training, noise and dropout, by the averaged weights.
  TrainingLosses losses(const std::vector<TrainingSample>& samples,
                        const std::vector<std::size_t>& chosen);

  /// The average of the weights over the last few hundred steps.
  PatternWeights weights() const;

  /// Everything that going on takes, as bytes of a file.
  std::string state() const;
  /// Takes it from a file. Throws TrainingError naming one that is absent, damaged or of another
  /// training.
  void load(const std::string& path);

  /// The loss of the weights as they are (not averaged) and its derivatives, for checks: a row of
  /// numbers a layer, the matrix row by row, then the bias. From then on the weights have double
  /// precision, and nothing can be trained.
  double lossAndGradients(const std::vector<TrainingSample>& samples,
                          std::map<std::string, std::vector<double>>* gradients);
  /// Adds to one number of a layer, counted as above.
  void nudge(const std::string& layer, std::size_t number, double change);
  /// The weights as they are.
  PatternWeights presentWeights() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace forge
