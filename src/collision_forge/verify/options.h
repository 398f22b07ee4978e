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
  double time_tolerance = 0.0;
  double overlap_tolerance = 0.0;
  double off_road_interval = 0.0;
};

void readOptions(Section& section, VehicleLimits& limits);
/// `time_margin` is that of SearchOptions, which attacks keep to the ends of the time tolerance.
void readOptions(Section& section, VerificationOptions& options, double time_margin);

}  // namespace forge
