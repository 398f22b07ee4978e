#include "collision_forge/planner_test/planners/pdm_motion.h"

#include <utility>

namespace forge {

PdmMotion motionOf(std::vector<BicycleState> states, const EgoVehicle& ego) {
  PdmMotion motion{std::move(states), {}};
  motion.boxes.reserve(motion.states.size());
  for (const BicycleState& state : motion.states) {
    motion.boxes.push_back({boxMiddleOf(state.rear_axle, ego.center_offset), ego.size});
  }
  return motion;
}

PdmMotion simulate(const BicycleState& start, std::vector<Pose2> rear_axle_poses,
                   const KinematicBicycle& bicycle, LqrTracker& tracker, double step,
                   const EgoVehicle& ego) {
  const std::size_t count = rear_axle_poses.size();
  tracker.setReference(std::move(rear_axle_poses));
  std::vector<BicycleState> states = {start};
  states.reserve(count);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    states.push_back(bicycle.step(states.back(), tracker.command(states.back(), i), step));
  }
  return motionOf(std::move(states), ego);
}

}  // namespace forge
