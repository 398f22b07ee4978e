#pragma once

#include "collision_forge/attack/severity/options.h"
#include "collision_forge/attack/verify/drive_limits.h"

namespace forge {

class Section;

/// Key `strict` of config/vehicle_limits.yaml, which has the sources: limits of the strict
/// protocol, equal for all vehicles, and of the cars that planners drive.
struct VehicleLimits {
  double max_forward_acceleration = 0.0;  ///< m/s2
  double max_braking = 0.0;               ///< m/s2, deceleration
  double max_total_acceleration = 0.0;  ///< m/s2, norm of the longitudinal and lateral acceleration
  double max_curvature = 0.0;           ///< 1/m, largest |curvature|
  double max_speed = 0.0;               ///< m/s, forwards; reversing is never allowed
  double curvature_min_speed = 0.0;     ///< m/s; below it the heading limits replace max_curvature
  double heading_slack = 0.0;      ///< rad of turn allowed at speeds below curvature_min_speed ...
  double heading_per_metre = 0.0;  ///< ... plus this many rad per m driven at such speeds
};

/// Limits of plausible driving, config/believability.yaml, which has the reasons.
struct BelievabilityOptions {
  double lane_distance = 0.0;   ///< m, largest from the box centre to the centreline of its lane
  double lane_heading = 0.0;    ///< rad, largest between the box and its lane
  double road_distance = 0.0;   ///< m, largest from the ego's box to a lane of fittingLanes()
  double road_heading = 0.0;    ///< rad by which the type's heading band is widened
  double island_reach = 0.0;    ///< m, reach of isOnIsland(): to the road on both sides
  double before_contact = 0.0;  ///< s before contact until which the lane is kept
  double pull_out = 0.0;        ///< s, the same for an attacker that stands at its first point
  double min_on_lane = 0.0;     ///< smallest RoadUse::on_lane of a plausible attack
  double max_wrong_way = 0.0;   ///< largest RoadUse::wrong_way of a plausible attack
  double max_off_road = 0.0;    ///< largest excess of RoadUse::off_road over its value at t0
};

/// Options of verify(): config/vehicle_limits.yaml, believability.yaml and severity.yaml; the last
/// two fields have no key.
struct VerificationOptions {
  VehicleLimits limits;        ///< of all attackers, if the request has LimitSet::kStrict
  DriveLimitOptions drivable;  ///< of attackers by class, if the request has LimitSet::kDrivable
  BelievabilityOptions believability;
  SeverityOptions severity;
  double overlap_tolerance = 0.001;  ///< m; contacts shallower than this may be missed
  double off_road_interval = 0.5;    ///< s between the poses averaged by offRoadShare()
};

// Read the struct from its section. Throw ConfigError for a missing key or a value out of range.
void readOptions(Section& section, VehicleLimits& limits);
/// Reads `strict`, `drivable` and `lengths` of config/vehicle_limits.yaml.
void readVehicleLimits(Section& section, VerificationOptions& options);
void readOptions(Section& section, BelievabilityOptions& options);

}  // namespace forge
