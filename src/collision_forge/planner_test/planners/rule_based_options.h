#pragma once

#include <vector>

namespace forge {

/// Choice among the ego's candidate paths.
enum class EgoWay {
  kFirst,       ///< the first of the nearest lane
  kAlongRoute,  ///< the path that stays nearest to its route
};

/// Options of RuleBasedPlanner: config/planners.yaml, section rule_based, where the source of each
/// of its keys stands; the first four come from its section published or tuned. Numbers without a
/// key are those in STRIVE's published implementation (Rempe et al. 2022, arXiv 2112.05077);
/// "measured" ones were derived from its outputs (test/parity/rule_based_parity_test.cpp).
struct RuleBasedOptions {
  double max_speed = 0.0;             ///< m/s
  double max_acceleration = 0.0;      ///< m/s2, also of braking
  double distance_weight = 0.0;       ///< 1/m, weight of a gap at t0
  double distance_weight_rate = 0.0;  ///< 1/m, increase of the weight per step
  double step = 0.2;      ///< s, also between two calls: STRIVE executes one step, then replans
  int steps = 25;         ///< 5 s; the first 12 lead to a middle speed, the others to an end speed
  int middle_speeds = 5;  ///< number of middle speeds, even over the reachable allowed range ...
  int end_speeds = 5;     ///< ... and of end speeds for each middle speed
  double interaction_radius = 0.0;          ///< m between middles; farther agents are ignored
  std::vector<double> speed_shares;         ///< share 0..1 of another agent's speed
  std::vector<double> acceleration_shares;  ///< share 0..1 of max_acceleration
  double on_lane_distance = 2.0;            ///< m from a vehicle to its lane, at most
  double on_lane_heading = 0.349066;        ///< rad (20 degrees) between both, at most
  /// Largest number of paths over the branches ahead of and behind an edge. Added here: the
  /// published implementation has no limit, and few places have as many.
  int max_paths = 100;
  /// m that paths exceed the distance driven at max_speed in all steps; measured. Behind an agent
  /// that drives backwards, the same with its own speed.
  double length_buffer = 5.0;
  double bend_length = 3.5;  ///< m over which the bend of a path towards the vehicle decays to 1/e
  double sample_spacing = 0.4;   ///< m of lane between the knots of a path, approximately
  double node_spacing = 1.0;     ///< m of lane between nodes of the graph, at most
  double max_probability = 0.0;  ///< 0..1, of a collision; a motion is safe below it
  EgoWay ego_way = EgoWay::kFirst;
};

}  // namespace forge
