#pragma once

#include <vector>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/planner_test/planners/lqr_tracker.h"

namespace forge {

/// A simulated motion of the ego: one entry per step, the first at t0. Global map frame.
struct PdmMotion {
  std::vector<BicycleState> states;  ///< of the rear axle
  std::vector<OrientedBox> boxes;    ///< the ego's box at each of `states`
};

/// Returns the states with the ego's box at each of them. `ego`: size of the box and its place on
/// the rear axle.
PdmMotion motionOf(std::vector<BicycleState> states, const EgoVehicle& ego);

/// Simulates the bicycle from `start` as the tracker follows poses of the rear axle, `step` seconds
/// apart, the first at t0. Returns as many entries as poses; the first state is `start`. Sets the
/// reference of `tracker`. Throws std::invalid_argument for fewer than two poses.
PdmMotion simulate(const BicycleState& start, std::vector<Pose2> rear_axle_poses,
                   const KinematicBicycle& bicycle, LqrTracker& tracker, double step,
                   const EgoVehicle& ego);

}  // namespace forge
