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
  double timeout = 0.0;        ///< s of the wall clock until a response to begin() or plan()
  double start_timeout = 0.0;  ///< s of the wall clock until the process is ready
  /// Parameters of the planner by name, handed to a process as environment variables NAME=VALUE, to
  /// a node as ROS parameters /NAME of its own master.
  std::map<std::string, double> parameters;
  std::string command;  ///< command line for /bin/sh; empty: the user gave none
  /// true: the command starts a ROS node; false: a process of the line protocol.
  bool is_node = false;
};

/// A process that plans by the line protocol of docs/planners.md: one JSON object per line, on
/// stdin and stdout. Not thread-safe.
class PlannerProcess {
 public:
  /// Runs the command in a shell and waits until the process is ready; parameters are environment
  /// variables. A node runs below the program planner_node, which gets the parameters; timeouts are
  /// then 1 s longer. Throws PlannerFileError if the process cannot be used; the message names the
  /// command and the reason.
  explicit PlannerProcess(const PlannerProcessOptions& options);

  /// Begins a rollout of `task`. `interval`: s of scene time between two calls of plan(). begin()
  /// and plan() throw PlannerTimeout if no response arrives in time, LatePlan if the node's
  /// response is late, and std::runtime_error for a process that has ended and for its errors;
  /// messages name the command. After any of these, isUsable() returns false.
  void begin(const DrivingTask& task, double interval);
  /// Returns the points of the response to an observation, unchecked; empty if the response has
  /// none. begin() must have been called.
  std::vector<TrajectoryPoint> plan(const Observation& observation);

  /// Returns false after begin() or plan() has thrown; such a process must be replaced.
  bool isUsable() const { return is_usable_; }
  /// Returns processKey() of the constructor's options.
  const std::string& key() const { return key_; }

 private:
  /// Sends `line` and returns the points of the response; none if it has no points.
  std::vector<TrajectoryPoint> ask(const std::string& line);

  PlannerProcessOptions options_;
  std::string key_;
  WorkerProcess process_;
  bool is_usable_ = true;
};

/// Returns the key of the process in its pool: kind (node or line protocol), command, and names and
/// values of the parameters. Two keys differ if and only if one of these differs; timeouts do not
/// count, so a process from the pool keeps the timeouts it was started with.
std::string processKey(const PlannerProcessOptions& options);

/// Reuses running processes, because starting one takes long.
using PlannerProcesses = IdleWorkers<PlannerProcess, PlannerProcessOptions>;

/// A planner outside this process: config/planners.yaml, section external.
struct ExternalOptions : PlannerProcessOptions {
  double interval = 0.0;  ///< s of scene time between two calls of plan()
  /// Pool shared by all planners that are created from copies of these options.
  std::shared_ptr<PlannerProcesses> processes = std::make_shared<PlannerProcesses>();  ///< not null
};

/// The planner `external`: each rollout uses one process of the pool for itself.
class ProcessPlanner : public Planner {
 public:
  explicit ProcessPlanner(const ExternalOptions& options) : options_(options) {}
  /// Returns its process to the pool.
  ~ProcessPlanner() override;

  /// Returns its process, if it has one, to the pool, then takes an idle process with the
  /// processKey() of its options from there or starts one, so that errors of the command show
  /// before a rollout. Throws PlannerFileError if no command was given or the process cannot be
  /// used.
  void start();

  /// Begins a rollout: takes a process as start() does, normally the same one again (a new one
  /// after a failure), and sends it the task. Throws as start() and PlannerProcess::begin().
  void initialize(const DrivingTask& task) override;
  /// Returns the response of the process. Throws as PlannerProcess::plan().
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

 private:
  /// Returns the process, if there is one, to the pool.
  void giveBack();

  ExternalOptions options_;
  std::unique_ptr<PlannerProcess> process_;  ///< null before start()
};

}  // namespace forge
