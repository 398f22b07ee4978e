#pragma once

#include <torch/script.h>

#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/planner_contract.h"

namespace forge {

/// Runs a TorchScript file as a planner or as a traffic model. Deterministic if its operations are:
/// one thread, no graph optimisation at run time, the same random seed in every rollout. Not
/// thread-safe.
class PlannerModule {
 public:
  /// Loads the file and runs it on two test inputs: no agents around the ego, and all inputs
  /// filled. `device`: "cpu", "cuda" or "auto". Throws std::runtime_error, naming the tensor, if
  /// the file does not match the contract.
  PlannerModule(const std::string& file, const std::string& device, const ModelContract& contract);

  /// Starts a new rollout: restores the state after loading.
  void begin();
  /// Runs forward() on the concatenated numbers of the contract's inputs; returns the numbers of
  /// its output. Throws std::runtime_error for an error in the file and for an output of another
  /// shape or type; does not check that the output is finite.
  std::vector<float> plan(const std::vector<float>& inputs);

 private:
  void tryOut();

  const ModelContract& contract_;
  torch::Device device_;
  torch::jit::Module loaded_;
  torch::jit::Module module_;  // of this rollout
};

}  // namespace forge
