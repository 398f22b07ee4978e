#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/study/training/options.h"
#include "collision_forge/study/training/planner_samples.h"

namespace forge {

/// Average displacement errors: the distance between planned and recorded positions, averaged over
/// the poses up to a horizon and over the samples.
struct DisplacementErrors {
  static constexpr std::array<double, 3> kTimes = {2.0, 4.0, 8.0};  ///< s, horizons
  std::array<double, kTimes.size()> means{};         ///< m, by horizon; 0 without samples
  std::array<std::size_t, kTimes.size()> moments{};  ///< samples with so long a recording
};

/// Returns the errors of a plan that continues straight at the current speed, on the samples with
/// the indices `chosen`.
DisplacementErrors constantVelocityErrors(const std::vector<PlannerSample>& samples,
                                          const std::vector<std::size_t>& chosen);

/// Trains the small planner of data/weights, modelled on PDM-Open (Dauner et al. 2023): a network
/// with two hidden layers that maps the ego's history and the route to 8 s of poses, trained with
/// an L1 loss. Deterministic on one machine for the same samples, options and seed.
class PlannerTrainer {
 public:
  /// `threads`: CPU threads of libtorch; `seed`: of initial weights, sample order and augmentation.
  PlannerTrainer(const PlannerTrainingOptions& options, int threads, std::uint64_t seed);
  ~PlannerTrainer();

  /// Trains one epoch on the samples with the indices `chosen`, in random order. Returns the mean
  /// loss, m.
  double trainEpoch(const std::vector<PlannerSample>& samples,
                    const std::vector<std::size_t>& chosen);

  /// Returns the errors of the current planner on the samples with the indices `chosen`.
  DisplacementErrors errors(const std::vector<PlannerSample>& samples,
                            const std::vector<std::size_t>& chosen);

  /// Writes a TorchScript file for the planner torchscript. Stores the names of the scenes that
  /// were left out in its extra file left_out_scenes. Throws std::runtime_error as AsideFile.
  void save(const std::string& path, const std::vector<std::string>& left_out_scenes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace forge
