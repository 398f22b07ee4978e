#pragma once

#include <vector>

#include "collision_forge/planners/lqr_tracker.h"
#include "collision_forge/scene/scene.h"

namespace forge {

/// How the ego would move, every step, the first entry now.
struct PdmMotion {
  std::vector<BicycleState> states;
  std::vector<OrientedBox> boxes;
};

/// Drives the bicycle from `start` along poses of the rear axle that follow each other every `step`
/// seconds; as many entries as poses.
PdmMotion simulate(const BicycleState& start, std::vector<Pose2> rear_axle_poses,
                   const KinematicBicycle& bicycle, LqrTracker& tracker, double step,
                   const EgoVehicle& ego);

/// Brakes from `start` by a constant command, the front wheel as it is, for `steps` steps.
PdmMotion simulateBraking(const BicycleState& start, double braking, int steps,
                          const KinematicBicycle& bicycle, double step, const EgoVehicle& ego);

}  // namespace forge
