#pragma once

#include <torch/script.h>

#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/planner_contract.h"

namespace forge {

/// A TorchScript file as a planner. Deterministic as far as its operations are: one thread, no
/// rewriting of the graph while it runs, the same random numbers in every rollout.
class PlannerModule {
 public:
  /// Loads the file and tries it on two inputs: nothing around the ego, and everything full.
  /// `device`: "cpu", "cuda" or "auto". Throws std::runtime_error, naming the tensor, for a file
  /// that does not fit.
  PlannerModule(const std::string& file, const std::string& device);

  /// A new rollout: as just loaded.
  void begin();
  /// The numbers of kContractInputs, one after the other; those of kContractOutput. Throws
  /// std::runtime_error for what goes wrong in the file, and for an output of another shape or
  /// type. Whether its numbers are finite is not looked at.
  std::vector<float> plan(const std::vector<float>& inputs);

 private:
  void tryOut();

  torch::Device device_;
  torch::jit::Module loaded_;
  torch::jit::Module module_;  // of this rollout
};

}  // namespace forge
