#include "collision_forge/attack/verify/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {

void readOptions(Section& section, VehicleLimits& limits) {
  limits.max_forward_acceleration = section.positive("max_forward_acceleration");
  limits.max_braking = section.positive("max_braking");
  limits.max_total_acceleration = section.positive("max_total_acceleration");
  limits.max_curvature = section.positive("max_curvature");
  limits.max_speed = section.positive("max_speed");
  limits.curvature_min_speed = section.nonNegative("curvature_min_speed");
  limits.heading_slack = section.nonNegative("heading_slack");
  limits.heading_per_metre = section.nonNegative("heading_per_metre");
}

void readVehicleLimits(Section& section, VerificationOptions& options) {
  section.read("strict", options.limits);
  readOptions(section, options.drivable);
}

void readOptions(Section& section, BelievabilityOptions& options) {
  options.lane_distance = section.positive("lane_distance");
  options.lane_heading = section.angle("lane_heading");
  options.road_distance = section.nonNegative("road_distance");
  options.road_heading = section.angle("road_heading");
  options.island_reach = section.positive("island_reach");
  options.before_contact = section.nonNegative("before_contact");
  options.pull_out = section.nonNegative("pull_out");
  options.min_on_lane = section.share("min_on_lane");
  options.max_wrong_way = section.share("max_wrong_way");
  options.max_off_road = section.share("max_off_road");
}

}  // namespace forge
