#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/planners/pdm_closed.h"
#include "collision_forge/planner_test/planners/planner.h"

namespace forge {

/// Planner that runs PdmClosed on the lanes of the map, along the centrelines of the route. It
/// stops at red lights (withRedLights()); as published, they are leads of proposals and are not
/// scored.
class PdmPlanner : public Planner {
 public:
  /// `route`: how the route's lanes are found. `bicycle`: car of the simulation; its wheelbase is
  /// replaced by the task's. `lqr`: of the simulation's tracker.
  PdmPlanner(const PdmOptions& options, const RouteCenterlineOptions& route,
             const KinematicBicycleOptions& bicycle, const LqrOptions& lqr);

  /// As Planner::initialize(). Throws std::invalid_argument for a task without lanes and for a
  /// route without two distinct points.
  void initialize(const DrivingTask& task) override;
  /// As Planner::plan(): `output_steps` + 1 points, `step` seconds apart, the first at the
  /// observation's time. The points have only time, pose and speed (the first the observed speed,
  /// the others the mean speed along the heading since the point before); acceleration and
  /// curvature are 0.
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;
  /// As Planner::proposals(): the simulated motions of all proposals in the order of
  /// PdmClosed::candidates(), `proposal_steps` + 1 poses every `step` seconds from the
  /// observation's time on; empty before the first plan().
  std::vector<std::vector<Pose2>> proposals() const override;

  /// Returns the details of the last plan; empty before initialize(), without candidates before
  /// plan().
  const std::optional<PdmClosed>& closed() const { return closed_; }

 private:
  PdmOptions options_;
  RouteCenterlineOptions route_options_;
  KinematicBicycleOptions bicycle_options_;
  LqrOptions lqr_options_;
  DrivingTask task_;
  std::optional<PdmClosed> closed_;
  std::optional<PdmMap> map_;
  std::optional<std::vector<std::size_t>> lanes_;  // of the route, from the first plan() on
};

}  // namespace forge
