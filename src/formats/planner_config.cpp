#include "formats/planner_config.h"

#include "formats/config_section.h"

namespace forge {
namespace {

constexpr double kMaxSteering = 1.5;  // rad; short of a wheel across the car

KinematicBicycleOptions readKinematicBicycle(Section section, const VehicleLimits& limits) {
  KinematicBicycleOptions options;
  options.wheelbase = section.positive("wheelbase");
  options.max_steering = section.within("max_steering", 0.0, kMaxSteering);
  options.max_acceleration = limits.max_forward_acceleration;
  options.max_braking = limits.max_braking;
  options.acceleration_lag = section.nonNegative("acceleration_lag");
  options.steering_lag = section.nonNegative("steering_lag");
  section.finish();
  return options;
}

}  // namespace

PlannerOptions loadPlanners(const std::string& directory, const VehicleLimits& limits) {
  Section file = openConfigFile(directory, "planners.yaml");
  PlannerOptions options;
  options.bicycle = readKinematicBicycle(file.section("bicycle"), limits);
  file.finish();
  return options;
}

}  // namespace forge
