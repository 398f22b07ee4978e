#pragma once

#include <memory>
#include <vector>

#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/planners/route_centerline.h"

namespace forge {

/// Returns pointers to the elements of `agents` (valid as long as these) that have a state, sorted
/// by the distance of their newest position to the ego's middle `ego`, nearest first; equally near
/// ones keep their order.
std::vector<const Track*> nearestAgents(const std::vector<Track>& agents, const Pose2& ego);

/// Returns the concatenated numbers of the inputs that a learned planner and a traffic model share,
/// the first five of kContractInputs; arguments as in PlannerInputs::at().
std::vector<float> sharedInputs(const LaneIndex& lanes,
                                const std::vector<TrajectoryPoint>& ego_history,
                                const std::vector<Track>& agents);

/// Builds the input tensors of a learned planner along one drive (planner_contract.h): in the
/// current frame of the ego (middle of the box, x forward, y left), m, rad, m/s, not normalised.
/// Unused entries and their mask are 0.
class PlannerInputs {
 public:
  /// `options`: how the centreline of the route is found. Keeps the task's lanes. Throws
  /// std::invalid_argument for a task without lanes or without two distinct route points.
  PlannerInputs(const DrivingTask& task, const RouteCenterlineOptions& options);

  /// Returns the concatenated numbers of all kContractInputs. `ego_history`: states of the ego
  /// (middle of the box, global map frame) at increasing times, the last is the current one; must
  /// not be empty. States between its points are interpolated; frames before the first are unknown.
  /// `agents`: as Observation::agents; a frame outside of an agent's states is unknown.
  std::vector<float> at(const std::vector<TrajectoryPoint>& ego_history,
                        const std::vector<Track>& agents) const;

 private:
  /// Writes the input "route" of an ego at `ego` to `route`, the place of its first number.
  void writeRoute(const Pose2& ego, float* route) const;

  std::shared_ptr<const LaneIndex> lanes_;
  ReferencePath way_;
};

}  // namespace forge
