#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/files/worker_process.h"
#include "collision_forge/planner_test/planners/idle_workers.h"
#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/planners/planner_worker.h"

namespace forge {

/// How a planner's process is started: config/planners.yaml, section external, where each number's
/// source stands, and the command line.
struct PlannerProcessOptions {
  double timeout = 0.0;                      ///< s of the wall clock for a response
  double start_timeout = 0.0;                ///< s of the wall clock until the process is ready
  std::map<std::string, double> parameters;  ///< parameters of the planner by name
  std::string command;                       ///< of the shell; empty: none was given
  bool is_node = false;  ///< the command starts a ROS node instead of a line-protocol process
};

/// A process that plans by the line protocol of docs/planners.md: one JSON object per line, on
/// stdin and stdout. Not thread-safe.
class PlannerProcess {
 public:
  /// Runs the command in a shell and waits until the process is ready; parameters are environment
  /// variables. A node runs below the program planner_node, which gets the parameters. Throws
  /// PlannerFileError if the process cannot be used; the message names the command and the reason.
  explicit PlannerProcess(const PlannerProcessOptions& options);

  /// Begins a rollout. `interval`: s between two calls of plan(). begin() and plan() throw
  /// PlannerTimeout if no response arrives in time, and std::runtime_error for a process that has
  /// ended and for its errors. After either, isUsable() returns false.
  void begin(const DrivingTask& task, double interval);
  /// Returns the response to an observation, unchecked.
  std::vector<TrajectoryPoint> plan(const Observation& observation);

  /// Returns false after begin() or plan() has thrown; such a process must be replaced.
  bool isUsable() const { return is_usable_; }
  /// Returns processKey() of the options.
  const std::string& key() const { return key_; }

 private:
  /// Sends `line` and returns the points of the response; none if it has no points.
  std::vector<TrajectoryPoint> ask(const std::string& line);

  PlannerProcessOptions options_;
  std::string key_;
  WorkerProcess process_;
  bool is_usable_ = true;
};

/// Returns a text that is equal for equal commands with equal parameters.
std::string processKey(const PlannerProcessOptions& options);

/// Reuses running processes, because starting one takes long.
using PlannerProcesses = IdleWorkers<PlannerProcess, PlannerProcessOptions>;

/// A planner outside this process: config/planners.yaml, section external.
struct ExternalOptions : PlannerProcessOptions {
  double interval = 0.0;  ///< s between two calls
  /// Pool shared by all planners that are created from copies of these options.
  std::shared_ptr<PlannerProcesses> processes = std::make_shared<PlannerProcesses>();
};

/// The planner `external`: each rollout uses one process of the pool for itself.
class ProcessPlanner : public Planner {
 public:
  explicit ProcessPlanner(const ExternalOptions& options) : options_(options) {}
  ~ProcessPlanner() override;

  /// Takes or starts a process, and keeps it for the next rollout. Throws PlannerFileError if no
  /// command was given or the process cannot be used.
  void start();

  /// Begins a rollout with a process as of start(). Throws as start() and PlannerProcess::begin().
  void initialize(const DrivingTask& task) override;
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

 private:
  void giveBack();

  ExternalOptions options_;
  std::unique_ptr<PlannerProcess> process_;
};

}  // namespace forge
