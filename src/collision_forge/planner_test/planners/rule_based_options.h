#pragma once

#include <vector>

namespace forge {

/// Which of its ways the ego drives.
enum class EgoWay {
  kFirst,       ///< of the nearest lane the first
  kAlongRoute,  ///< the one that stays nearest to its route
};

/// config/planners.yaml, section rule_based, where the unit and source of each of its keys stand.
/// The first four are those of its section published or tuned. Numbers without a key are those of
/// STRIVE's published implementation (Rempe et al. 2022, arXiv 2112.05077); "measured" ones are
/// derived from what it returns (test/parity/rule_based_parity_test.cpp).
struct RuleBasedOptions {
  double max_speed = 0.0;
  double max_acceleration = 0.0;
  double distance_weight = 0.0;
  double distance_weight_rate = 0.0;
  double step = 0.2;      ///< s between two calls, too: STRIVE executes a step, then plans anew
  int steps = 25;         ///< 5 s; the first 12 lead to a middle speed, the others to an end speed
  int middle_speeds = 5;  ///< tried, evenly spread over what can be reached and is allowed ...
  int end_speeds = 5;     ///< ... and for each of these at the end
  double interaction_radius = 0.0;
  std::vector<double> speed_shares;
  std::vector<double> acceleration_shares;
  double on_lane_distance = 2.0;      ///< m between a vehicle and the lane that it drives on
  double on_lane_heading = 0.349066;  ///< rad (20 degrees) between both
  /// Over the branches on either side of a lane that are followed. Ours: the published has no
  /// bound, and few places have as many.
  int max_paths = 100;
  /// m that ways are longer than is driven at max_speed in all steps; measured. Behind somebody the
  /// same with its own speed, where it drives backwards.
  double length_buffer = 5.0;
  double bend_length = 3.5;     ///< m in which a lane, bent through the vehicle, fades to 1/e
  double sample_spacing = 0.4;  ///< m of lane between knots of a way, about
  double node_spacing = 1.0;    ///< m of lane between nodes of the graph, at most; as maps are read
  double max_probability = 0.0;
  EgoWay ego_way = EgoWay::kFirst;
};

}  // namespace forge
