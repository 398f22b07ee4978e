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

LqrOptions readLqr(Section section) {
  LqrOptions options;
  options.step = section.positive("step");
  options.horizon = section.count("horizon", 1);
  options.speed_weight = section.positive("speed_weight");
  options.acceleration_weight = section.nonNegative("acceleration_weight");
  options.lateral_weight = section.nonNegative("lateral_weight");
  options.heading_weight = section.nonNegative("heading_weight");
  options.steering_weight = section.nonNegative("steering_weight");
  options.steering_rate_weight = section.positive("steering_rate_weight");
  options.stop_speed = section.nonNegative("stop_speed");
  options.stop_gain = section.nonNegative("stop_gain");
  options.jerk_penalty = section.positive("jerk_penalty");
  options.curvature_rate_penalty = section.positive("curvature_rate_penalty");
  section.finish();
  return options;
}

}  // namespace

PlannerOptions loadPlanners(const std::string& directory, const VehicleLimits& limits) {
  Section file = openConfigFile(directory, "planners.yaml");
  PlannerOptions options;
  options.bicycle = readKinematicBicycle(file.section("bicycle"), limits);
  options.lqr = readLqr(file.section("lqr"));
  file.finish();
  return options;
}

}  // namespace forge
