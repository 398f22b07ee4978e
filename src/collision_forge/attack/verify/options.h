#pragma once

#include "collision_forge/attack/verify/drive_limits.h"

namespace forge {

class Section;

/// config/vehicle_limits.yaml, strict, where each number's unit and source stand: of any vehicle
/// alike, as the strict protocol has them, and of the cars that planners drive.
struct VehicleLimits {
  double max_forward_acceleration = 0.0;
  double max_braking = 0.0;
  double max_total_acceleration = 0.0;
  double max_curvature = 0.0;
  double max_speed = 0.0;
  double curvature_min_speed = 0.0;
  double heading_slack = 0.0;
  double heading_per_metre = 0.0;
};

/// config/believability.yaml, where each number's unit and source stand.
struct BelievabilityOptions {
  double lane_distance = 0.0;
  double lane_heading = 0.0;
  double road_distance = 0.0;
  double road_heading = 0.0;
  double island_reach = 0.0;
  double before_contact = 0.0;
  double pull_out = 0.0;
  double min_on_lane = 0.0;
  double max_wrong_way = 0.0;
  double max_off_road = 0.0;
};

/// How a trajectory is verified.
struct VerificationOptions {
  VehicleLimits limits;        ///< of attackers by LimitSet::kStrict
  DriveLimitOptions drivable;  ///< of attackers by LimitSet::kDrivable
  BelievabilityOptions believability;
  double overlap_tolerance = 0.001;  ///< m; contacts shallower than this may be missed
  double off_road_interval = 0.5;  ///< s between the poses of which the off-road share is the mean
};

void readOptions(Section& section, VehicleLimits& limits);
/// config/vehicle_limits.yaml
void readVehicleLimits(Section& section, VerificationOptions& options);
void readOptions(Section& section, BelievabilityOptions& options);

}  // namespace forge
