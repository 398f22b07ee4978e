#pragma once

#include <vector>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/planner_test/planners/lqr_tracker.h"

namespace forge {

/// How the ego would move, every step, the first entry now.
struct PdmMotion {
  std::vector<BicycleState> states;
  std::vector<OrientedBox> boxes;
};

/// The ego's box in each of the states.
PdmMotion motionOf(std::vector<BicycleState> states, const EgoVehicle& ego);

/// Drives the bicycle from `start` along poses of the rear axle that follow each other every `step`
/// seconds; as many entries as poses.
PdmMotion simulate(const BicycleState& start, std::vector<Pose2> rear_axle_poses,
                   const KinematicBicycle& bicycle, LqrTracker& tracker, double step,
                   const EgoVehicle& ego);

}  // namespace forge
