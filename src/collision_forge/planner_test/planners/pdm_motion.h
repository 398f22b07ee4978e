#pragma once

#include <vector>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/planner_test/planners/lqr_tracker.h"

namespace forge {

/// A simulated motion of the ego: one entry per step, the first at t0.
struct PdmMotion {
  std::vector<BicycleState> states;
  std::vector<OrientedBox> boxes;
};

/// Adds the ego's box to each of the states.
PdmMotion motionOf(std::vector<BicycleState> states, const EgoVehicle& ego);

/// Simulates the bicycle from `start` as the tracker follows poses of the rear axle `step` seconds
/// apart. Returns as many entries as poses.
PdmMotion simulate(const BicycleState& start, std::vector<Pose2> rear_axle_poses,
                   const KinematicBicycle& bicycle, LqrTracker& tracker, double step,
                   const EgoVehicle& ego);

}  // namespace forge
