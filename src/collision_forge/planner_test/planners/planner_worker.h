#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/base/files/worker_process.h"
#include "collision_forge/planner_test/planners/idle_workers.h"
#include "collision_forge/planner_test/planners/planner_contract.h"

namespace forge {

/// Model file of a learned planner or of a traffic model: config/planners.yaml, section
/// torchscript, where each number's source stands.
struct TorchscriptFileOptions {
  std::string file;            ///< path of the TorchScript file
  std::string device;          ///< "cpu", "cuda" or "auto"
  double timeout = 0.0;        ///< s of the wall clock per call
  double start_timeout = 0.0;  ///< s of the wall clock to load libtorch and the file
  const ModelContract* contract = &kPlannerContract;  ///< inputs and output of the file
};

/// Thrown if a model file cannot be used; the message names the file and the reason.
struct PlannerFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs a model file in a process of its own, which loads libtorch, so that a crash or
/// an endless loop in the file does not affect the caller. Not thread-safe.
class PlannerWorker {
 public:
  /// Starts the process, loads the file and runs it on test inputs. Throws PlannerFileError.
  explicit PlannerWorker(const TorchscriptFileOptions& options);

  /// Starts a new rollout and resets the model's state. begin() and plan() throw
  /// std::runtime_error for errors in the file and WorkerTimeout if it does not respond in time.
  /// After either, isUsable() returns false.
  void begin();
  /// Runs the file on the concatenated numbers of the contract's inputs; returns the numbers of its
  /// output.
  std::vector<float> plan(const std::vector<float>& inputs);

  /// Returns false after begin() or plan() has thrown; such a worker must be replaced.
  bool isUsable() const { return is_usable_; }
  /// workerKey() at load time.
  const std::string& key() const { return key_; }

 private:
  void ask(char request, const std::vector<float>& numbers, std::vector<float>& answer);
  void receiveAnswer(std::vector<float>& numbers);

  TorchscriptFileOptions options_;
  std::string key_;
  WorkerProcess process_;
  bool is_usable_ = true;
};

/// Returns a text that is equal for equal options and unchanged content of the file.
std::string workerKey(const TorchscriptFileOptions& options);

/// Reuses loaded files, because loading takes about a second.
using PlannerWorkers = IdleWorkers<PlannerWorker, TorchscriptFileOptions>;

}  // namespace forge
