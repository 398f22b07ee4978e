#pragma once

#include <memory>
#include <vector>

#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/planners/route_centerline.h"

namespace forge {

/// What a learned planner is given along one drive, as planner_contract.h has it: in the frame of
/// the ego now (middle of the box, x forward, y left), metres, radians, m/s, not normalised. Where
/// nothing is, numbers and mask are 0.
class PlannerInputs {
 public:
  /// Throws std::invalid_argument for a task without lanes or without a route.
  PlannerInputs(const DrivingTask& task, const RouteCenterlineOptions& options);

  /// The numbers of all of kContractInputs, one after the other. `ego_history`: the ego as it was
  /// seen, times increasing, the last now.
  std::vector<float> at(const std::vector<TrajectoryPoint>& ego_history,
                        const std::vector<Track>& agents) const;

 private:
  void writeRoute(const Pose2& ego, float* route) const;

  std::shared_ptr<const LaneIndex> lanes_;
  ReferencePath way_;
};

}  // namespace forge
