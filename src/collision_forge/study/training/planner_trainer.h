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

/// Means over moments: the distance between planned and driven places, over all poses up to a time.
struct DisplacementErrors {
  static constexpr std::array<double, 3> kTimes = {2.0, 4.0, 8.0};  ///< s
  std::array<double, kTimes.size()> means{};                        ///< m
  std::array<std::size_t, kTimes.size()> moments{};  ///< whose recording lasts so long
};

/// On at the present speed, straight ahead.
DisplacementErrors constantVelocityErrors(const std::vector<PlannerSample>& samples,
                                          const std::vector<std::size_t>& chosen);

/// Trains the small planner of data/weights after PDM-Open (Dauner et al. 2023): a network of two
/// hidden layers from the ego's history and the route ahead to eight seconds of poses, by the
/// absolute error. The same samples, options and seed give the same planner on the same machine.
class PlannerTrainer {
 public:
  PlannerTrainer(const PlannerTrainingOptions& options, int threads, std::uint64_t seed);
  ~PlannerTrainer();

  /// One pass over the chosen samples in random order; the mean loss, m.
  double trainEpoch(const std::vector<PlannerSample>& samples,
                    const std::vector<std::size_t>& chosen);

  DisplacementErrors errors(const std::vector<PlannerSample>& samples,
                            const std::vector<std::size_t>& chosen);

  /// As a TorchScript file for the planner torchscript, with the names of the scenes that it does
  /// not know as its extra file left_out_scenes. Throws as AsideFile does.
  void save(const std::string& path, const std::vector<std::string>& left_out_scenes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace forge
