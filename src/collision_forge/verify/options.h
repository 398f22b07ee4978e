#pragma once

namespace forge {

class Section;

/// config/vehicle_limits.yaml, where each number's unit and source stand.
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

/// config/verification.yaml
struct VerificationOptions {
  VehicleLimits limits;  ///< of the attacker
  double overlap_tolerance = 0.0;
  double off_road_interval = 0.0;
};

void readOptions(Section& section, VehicleLimits& limits);
/// Without the limits, which have a file of their own.
void readOptions(Section& section, VerificationOptions& options);

}  // namespace forge
