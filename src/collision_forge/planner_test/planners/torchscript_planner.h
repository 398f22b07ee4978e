#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/planners/planner_inputs.h"
#include "collision_forge/planner_test/planners/planner_worker.h"

namespace forge {

/// Options of TorchscriptPlanner: config/planners.yaml, section torchscript.
struct TorchscriptOptions : TorchscriptFileOptions {
  double interval = 0.0;  ///< s of scene time between two calls of plan()
  /// Worker pool (not null), shared by all planners that are created from copies of these options.
  std::shared_ptr<PlannerWorkers> workers = std::make_shared<PlannerWorkers>();
};

/// A learned planner: runs a TorchScript file with the inputs and outputs that
/// docs/learned_planner.md defines.
class TorchscriptPlanner : public Planner {
 public:
  /// Takes a worker of `options.workers` that has loaded and tested the file, or starts one;
  /// `options.contract` must be &kPlannerContract. `route`: how the centreline of the route is
  /// found. Throws PlannerFileError.
  TorchscriptPlanner(const TorchscriptOptions& options, const RouteCenterlineOptions& route);
  /// Returns the worker to the pool.
  ~TorchscriptPlanner() override;

  /// As Planner::initialize(); restores the model's state after loading and forgets earlier states
  /// of the ego. A worker that has failed is not replaced: the planner then fails again. Throws as
  /// PlannerInputs, PlannerTimeout if the worker does not respond, and std::runtime_error for a
  /// failure of the file.
  void initialize(const DrivingTask& task) override;
  /// As Planner::plan(): the observation's ego, then kContractPoses points, kContractPoseStep
  /// seconds apart, the first of them one such step later; speeds, accelerations and curvatures are
  /// derived from the poses. Throws PlannerTimeout if the worker does not respond and
  /// std::runtime_error for a failure of the file.
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

 private:
  /// Appends the state to history_ and drops states that no input needs.
  void remember(const TrajectoryPoint& ego);

  TorchscriptOptions options_;
  RouteCenterlineOptions route_options_;
  std::unique_ptr<PlannerWorker> worker_;
  std::optional<PlannerInputs> inputs_;
  std::vector<TrajectoryPoint> history_;  // of the ego, as long as the input needs
};

}  // namespace forge
