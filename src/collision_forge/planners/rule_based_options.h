#pragma once

#include <vector>

namespace forge {

/// config/planners.yaml, section rule_based, where each number's unit and source stand. The first
/// four are those of its section published or tuned.
struct RuleBasedOptions {
  double max_speed = 0.0;
  double max_acceleration = 0.0;
  double distance_weight = 0.0;
  double distance_weight_rate = 0.0;
  double step = 0.0;
  int steps = 0;
  int middle_speeds = 0;
  int end_speeds = 0;
  double interaction_radius = 0.0;
  std::vector<double> speed_shares;
  double acceleration_share = 0.0;
  double on_lane_distance = 0.0;
  double on_lane_heading = 0.0;
  int max_paths = 0;
  double bend_length = 0.0;
  double sample_spacing = 0.0;
  int circles = 0;
  double safety_buffer = 0.0;
  double max_probability = 0.0;
};

}  // namespace forge
