#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/planners/planner_inputs.h"
#include "collision_forge/planner_test/planners/planner_worker.h"

namespace forge {

/// config/planners.yaml, section torchscript.
struct TorchscriptOptions : TorchscriptFileOptions {
  double interval = 0.0;
  /// Shared by all planners that are made with copies of these options.
  std::shared_ptr<PlannerWorkers> workers = std::make_shared<PlannerWorkers>();
};

/// A learned planner: a TorchScript file of the contract of docs/learned_planner.md.
class TorchscriptPlanner : public Planner {
 public:
  /// Loads the file and tries it. Throws PlannerFileError.
  TorchscriptPlanner(const TorchscriptOptions& options, const RouteCenterlineOptions& route);
  ~TorchscriptPlanner() override;

  void initialize(const DrivingTask& task) override;
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;
  double otherProcessorTime() const override { return worker_->processorTime(); }

 private:
  void remember(const TrajectoryPoint& ego);

  TorchscriptOptions options_;
  RouteCenterlineOptions route_options_;
  std::unique_ptr<PlannerWorker> worker_;
  std::optional<PlannerInputs> inputs_;
  std::vector<TrajectoryPoint> history_;  // of the ego, as long as the contract asks for
};

}  // namespace forge
