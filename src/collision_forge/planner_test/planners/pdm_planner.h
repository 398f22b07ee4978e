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
  PdmPlanner(const PdmOptions& options, const RouteCenterlineOptions& route,
             const KinematicBicycleOptions& bicycle, const LqrOptions& lqr);

  void initialize(const DrivingTask& task) override;
  /// As Planner::plan(); the points have only time, pose and speed.
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;
  std::vector<std::vector<Pose2>> proposals() const override;

  /// Access to the last plan's details; empty before initialize().
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
