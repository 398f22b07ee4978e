#include "collision_forge/planners/pdm_motion.h"

#include <utility>

namespace forge {
namespace {

void append(const BicycleState& state, const EgoVehicle& ego, PdmMotion& motion) {
  motion.states.push_back(state);
  motion.boxes.push_back({boxMiddleOf(state.rear_axle, ego.center_offset), ego.size});
}

}  // namespace

PdmMotion simulate(const BicycleState& start, std::vector<Pose2> rear_axle_poses,
                   const KinematicBicycle& bicycle, LqrTracker& tracker, double step,
                   const EgoVehicle& ego) {
  const std::size_t count = rear_axle_poses.size();
  tracker.setReference(std::move(rear_axle_poses));
  PdmMotion motion;
  motion.states.reserve(count);
  motion.boxes.reserve(count);
  append(start, ego, motion);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const BicycleState& state = motion.states.back();
    append(bicycle.step(state, tracker.command(state, i), step), ego, motion);
  }
  return motion;
}

PdmMotion simulateBraking(const BicycleState& start, double braking, int steps,
                          const KinematicBicycle& bicycle, double step, const EgoVehicle& ego) {
  PdmMotion motion;
  append(start, ego, motion);
  for (int i = 0; i < steps; ++i) {
    append(bicycle.step(motion.states.back(), {-braking, 0.0}, step), ego, motion);
  }
  return motion;
}

}  // namespace forge
