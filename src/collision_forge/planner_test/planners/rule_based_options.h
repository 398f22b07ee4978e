#pragma once

#include <vector>

namespace forge {

/// Choice among the ego's candidate paths.
enum class EgoWay {
  kFirst,       ///< the first path from the nearest lane, matchedEdges()
  kAlongRoute,  ///< the path that stays nearest to its route
};

/// Options of RuleBasedPlanner: config/planners.yaml, section rule_based, where the source of each
/// of its keys stands; the first four come from its section published or tuned. Numbers without a
/// key are those in STRIVE's published implementation (Rempe et al. 2022, arXiv 2112.05077);
/// "measured" ones were derived from its outputs (test/parity/rule_based_parity_test.cpp).
struct RuleBasedOptions {
  double max_speed = 0.0;  ///< m/s, of the ego
  /// m/s2, also of braking; of the ego, and of other agents times a share.
  double max_acceleration = 0.0;
  double distance_weight = 0.0;       ///< 1/m, weight of a gap at t0 in collisionProbability()
  double distance_weight_rate = 0.0;  ///< 1/m, increase of the weight per step
  double step = 0.2;  ///< s, also between two calls: STRIVE executes one step, then replans
  int steps = 25;     ///< 5 s; the first 12 lead to a middle speed, the others to an end speed
  /// Number of middle speeds, evenly spread over the reachable and allowed range.
  int middle_speeds = 5;
  int end_speeds = 5;               ///< number of end speeds for each middle speed, likewise
  double interaction_radius = 0.0;  ///< m between middles; farther agents are ignored
  /// Predicted target speeds of another agent, as shares of its speed.
  std::vector<double> speed_shares;
  /// Its predicted accelerations, as shares of max_acceleration.
  std::vector<double> acceleration_shares;
  double on_lane_distance = 2.0;  ///< m from a vehicle's middle to its lane's centreline, at most
  double on_lane_heading = 0.349066;  ///< rad (20 degrees) between the directions of both, at most
  /// Largest number of paths over the branches ahead of and behind an edge. Added here: the
  /// published implementation has no limit, and few places have as many.
  int max_paths = 100;
  /// m that paths exceed the distance driven at max_speed in all steps; measured. Behind an agent
  /// that drives backwards, the same with its own speed.
  double length_buffer = 5.0;
  double bend_length = 3.5;  ///< m over which the bend of a path towards the vehicle decays to 1/e
  double sample_spacing = 0.4;   ///< m of lane between the knots of a path, approximately
  double node_spacing = 1.0;     ///< m of lane between nodes of the graph, at most
  double max_probability = 0.0;  ///< 0..1, of a collision at any step; a profile is safe below it
  EgoWay ego_way = EgoWay::kFirst;  ///< which candidate path the ego takes
};

}  // namespace forge
