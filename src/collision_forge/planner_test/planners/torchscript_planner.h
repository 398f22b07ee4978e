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
  double interval = 0.0;  ///< s between two calls
  /// Worker pool, shared by all planners that are created from copies of these options.
  std::shared_ptr<PlannerWorkers> workers = std::make_shared<PlannerWorkers>();
};

/// A learned planner: runs a TorchScript file with the inputs and outputs that
/// docs/learned_planner.md defines.
class TorchscriptPlanner : public Planner {
 public:
  /// Takes a worker that has loaded and tested the file. Throws PlannerFileError.
  TorchscriptPlanner(const TorchscriptOptions& options, const RouteCenterlineOptions& route);
  ~TorchscriptPlanner() override;

  void initialize(const DrivingTask& task) override;
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;

 private:
  void remember(const TrajectoryPoint& ego);

  TorchscriptOptions options_;
  RouteCenterlineOptions route_options_;
  std::unique_ptr<PlannerWorker> worker_;
  std::optional<PlannerInputs> inputs_;
  std::vector<TrajectoryPoint> history_;  // of the ego, as long as the input needs
};

}  // namespace forge
