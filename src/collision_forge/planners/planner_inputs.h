#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planners/planner.h"
#include "collision_forge/planners/route_centerline.h"
#include "collision_forge/planners/sampled_way.h"

namespace forge {

/// What a learned planner is given along one drive, as planner_contract.h has it: in the frame of
/// the ego now (middle of the box, x forward, y left), metres, radians, m/s, not normalised. Where
/// nothing is, numbers and mask are 0.
class PlannerInputs {
 public:
  /// Throws std::invalid_argument for a task without lanes or without a route.
  PlannerInputs(const DrivingTask& task, const RouteCenterlineOptions& options);

  /// The numbers of all of kContractInputs, one after the other. `ego_history`: the ego as it was
  /// seen, times increasing, the last now. Called tick by tick: where the route meets itself, the
  /// ego is where it drove on to.
  std::vector<float> at(const std::vector<TrajectoryPoint>& ego_history,
                        const std::vector<Track>& agents);

 private:
  void writeRoute(const Pose2& ego, float* route);

  std::shared_ptr<const LaneIndex> lanes_;
  SampledWay way_;
  std::optional<std::size_t> way_sample_;  // where the ego was on the way at the last call
};

}  // namespace forge
