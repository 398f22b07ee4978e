#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/planner_test/planners/torchscript_planner.h"

namespace forge {

/// A learned model of the traffic: a TorchScript file with the inputs and the output that
/// docs/learned_planner.md defines, run in a worker process. Every call starts from the state of
/// the file after loading, so a result depends on the arguments alone. Not thread-safe.
class BackgroundModel {
 public:
  /// Takes a worker of `options.workers` that has loaded and tested the file, or starts one.
  /// `options.contract` must be &kTrafficContract, `lanes` (the map) not null. Throws
  /// PlannerFileError.
  BackgroundModel(const TorchscriptOptions& options, std::shared_ptr<const LaneIndex> lanes);
  /// Returns the worker to the pool.
  ~BackgroundModel();
  BackgroundModel(const BackgroundModel&) = delete;
  BackgroundModel& operator=(const BackgroundModel&) = delete;

  /// Returns the poses (middle of the box, global map frame) `step` seconds (> 0) from now, by
  /// Track::id, of the kContractAgents agents nearest to the ego; other agents and agents without
  /// states have no entry. Now is the time of the last point of `ego_history`, which must not be
  /// empty; `ego_history` and `agents` as in PlannerInputs::at(). Throws std::runtime_error, naming
  /// the file, for a failure of the file, for a pose that is not finite, and (as WorkerTimeout) if
  /// the worker does not respond in time.
  std::map<std::string, Pose2> next(const std::vector<TrajectoryPoint>& ego_history,
                                    const std::vector<Track>& agents, double step);

 private:
  TorchscriptOptions options_;
  std::shared_ptr<const LaneIndex> lanes_;
  std::unique_ptr<PlannerWorker> worker_;
};

}  // namespace forge
