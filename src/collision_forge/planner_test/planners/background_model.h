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
  /// Takes a worker that has loaded and tested the file. Throws PlannerFileError.
  /// `options.contract` must be &kTrafficContract, `lanes` not null.
  BackgroundModel(const TorchscriptOptions& options, std::shared_ptr<const LaneIndex> lanes);
  ~BackgroundModel();
  BackgroundModel(const BackgroundModel&) = delete;
  BackgroundModel& operator=(const BackgroundModel&) = delete;

  /// Returns the poses `step` seconds from now, by id, of the kContractAgents agents nearest to the
  /// ego. `ego_history`: as in PlannerInputs::at(). Throws std::runtime_error, naming the file, for
  /// a failure of the file and for a pose that is not finite.
  std::map<std::string, Pose2> next(const std::vector<TrajectoryPoint>& ego_history,
                                    const std::vector<Track>& agents, double step);

 private:
  TorchscriptOptions options_;
  std::shared_ptr<const LaneIndex> lanes_;
  std::unique_ptr<PlannerWorker> worker_;
};

}  // namespace forge
