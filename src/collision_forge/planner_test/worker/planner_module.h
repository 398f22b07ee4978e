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
  /// Loads the file and runs it on two test inputs: all numbers 0 (no agents and lanes around the
  /// ego), and all numbers 1 (all inputs filled). `device`: "cpu", "cuda" or "auto" (CUDA if there
  /// is a device). `contract` must outlive the module. Sets libtorch's global state: one thread,
  /// deterministic algorithms. Throws std::runtime_error with the reason, which names the tensor,
  /// if the file cannot be loaded or does not match the contract, if an output for a test input is
  /// not finite, and for "cuda" without a device.
  PlannerModule(const std::string& file, const std::string& device, const ModelContract& contract);

  /// Starts a new rollout; must be called before plan(). Restores the module's state after loading
  /// and reseeds libtorch's random numbers.
  void begin();
  /// Runs forward() on the concatenated numbers of the contract's inputs, `contract.numbers()`
  /// many; returns the numbers of its output, row by row. State that the module keeps lasts until
  /// the next begin(). Throws std::runtime_error for an error in the file and for an output of
  /// another shape or type; does not check that the output is finite.
  std::vector<float> plan(const std::vector<float>& inputs);

 private:
  /// Runs the file on the two test inputs. Throws as the constructor.
  void tryOut();

  const ModelContract& contract_;
  torch::Device device_;
  torch::jit::Module loaded_;  ///< as loaded, never run
  torch::jit::Module module_;  ///< copy of this rollout, set by begin()
};

}  // namespace forge
