#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/base/files/worker_process.h"

namespace forge {

/// config/planners.yaml, section torchscript, where each number's unit and source stand.
struct TorchscriptFileOptions {
  std::string file;
  std::string device;
  double timeout = 0.0;
  double start_timeout = 0.0;
};

/// A file that no planner can be made of; names it and says why.
struct PlannerFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A learned planner's file, run in a process of its own, which libtorch is loaded into: a file
/// that crashes or never ends takes nothing else with it.
class PlannerWorker {
 public:
  /// Loads the file and tries it. Throws PlannerFileError.
  explicit PlannerWorker(const TorchscriptFileOptions& options);

  /// A new rollout: the planner forgets. It and plan() throw std::runtime_error for what goes wrong
  /// in the file, WorkerTimeout when it does not answer in time. After that isUsable() no more.
  void begin();
  /// The numbers of kContractInputs; those of kContractOutput.
  std::vector<float> plan(const std::vector<float>& inputs);

  bool isUsable() const { return is_usable_; }
  /// Says which file this is, as it was when it was loaded.
  const std::string& key() const { return key_; }
  /// s of the processor.
  double processorTime() const { return process_.processorTime(); }

 private:
  void ask(char request, const std::vector<float>& numbers, std::vector<float>& answer);
  void receiveAnswer(std::vector<float>& numbers);

  TorchscriptFileOptions options_;
  std::string key_;
  WorkerProcess process_;
  bool is_usable_ = true;
};

/// Workers that are not at work. A file takes a second to load, which not every rollout needs to
/// wait for. May be used from many threads.
class PlannerWorkers {
 public:
  /// One that was given back, or a new one. A file that was written anew is loaded anew. Throws
  /// PlannerFileError.
  std::unique_ptr<PlannerWorker> take(const TorchscriptFileOptions& options);
  /// Nothing is kept of one that is not usable.
  void giveBack(std::unique_ptr<PlannerWorker> worker);

 private:
  std::mutex mutex_;
  std::multimap<std::string, std::unique_ptr<PlannerWorker>> idle_;  // by key()
};

}  // namespace forge
