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
  std::string file;            ///< path of the TorchScript file; empty: none
  std::string device;          ///< "cpu", "cuda" or "auto" (CUDA if there is a device)
  double timeout = 0.0;        ///< s of the wall clock per call
  double start_timeout = 0.0;  ///< s of the wall clock to load libtorch and the file
  /// Inputs and output of the file; not null, static.
  const ModelContract* contract = &kPlannerContract;
};

/// Thrown if a model file cannot be used; the message names the file and the reason.
struct PlannerFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs a model file in a process of its own, which loads libtorch, so that a crash or
/// an endless loop in the file does not affect the caller. Not thread-safe.
class PlannerWorker {
 public:
  /// Starts the process, loads the file and runs it on test inputs (PlannerModule). Throws
  /// PlannerFileError if no file is given, this build has no worker program, or the file cannot be
  /// used.
  explicit PlannerWorker(const TorchscriptFileOptions& options);

  /// Starts a new rollout and resets the model's state. begin() and plan() throw
  /// std::runtime_error, naming the file, for errors in the file or of the process, and
  /// WorkerTimeout if it does not respond in `options.timeout` seconds. After either, isUsable()
  /// returns false.
  void begin();
  /// Runs the file on the concatenated numbers of the contract's inputs, `contract->numbers()`
  /// many; returns the numbers of its output, row by row. begin() must have been called.
  std::vector<float> plan(const std::vector<float>& inputs);

  /// Returns false after begin() or plan() has thrown; such a worker must be replaced.
  bool isUsable() const { return is_usable_; }
  /// Returns workerKey() as of the start of the worker.
  const std::string& key() const { return key_; }

 private:
  /// Sends a request with its numbers and reads the reply into `answer`, whose size is the expected
  /// count.
  void ask(char request, const std::vector<float>& numbers, std::vector<float>& answer);
  /// Reads a reply with as many numbers as `numbers` has. Throws std::runtime_error for a failure
  /// that the worker reports.
  void receiveAnswer(std::vector<float>& numbers);

  TorchscriptFileOptions options_;
  std::string key_;
  WorkerProcess process_;
  bool is_usable_ = true;
};

/// Returns the key of the worker in its pool: name of the contract, device, both timeouts (to 1e-6
/// s), path of the file and time of its last change. Two keys differ if and only if one of these
/// differs. Does not throw if the file is missing, whose time then is a constant.
std::string workerKey(const TorchscriptFileOptions& options);

/// Reuses loaded files, because loading takes about a second.
using PlannerWorkers = IdleWorkers<PlannerWorker, TorchscriptFileOptions>;

}  // namespace forge
