#pragma once

#include <vector>

namespace forge {

/// Which of its ways the ego drives.
enum class EgoWay {
  kFirst,       ///< of the nearest lane the first
  kAlongRoute,  ///< the one that stays nearest to its route
};

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
  std::vector<double> acceleration_shares;
  double on_lane_distance = 0.0;
  double on_lane_heading = 0.0;
  int max_paths = 0;
  double length_buffer = 0.0;
  double bend_length = 0.0;
  double sample_spacing = 0.0;
  double node_spacing = 0.0;
  double max_probability = 0.0;
  EgoWay ego_way = EgoWay::kFirst;
};

}  // namespace forge
