#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/lane_graph.h"
#include "collision_forge/planner_test/planners/lane_matches.h"
#include "collision_forge/planner_test/planners/rule_based_options.h"

namespace forge {

/// A candidate path of a vehicle, given by knots. Lengths are measured along the path from the
/// vehicle's middle; negative lengths are behind it. Positions in m, global map frame.
class LaneSpline {
 public:
  /// A point of the path.
  struct Point {
    Vector2 position{0.0, 0.0};  ///< m
    Vector2 heading{1.0, 0.0};   ///< along the path, unit length at the knots, shorter between them
  };
  /// A point with its length along the path.
  struct Knot {
    double length = 0.0;  ///< m along the path from the vehicle
    Point point;          ///< at this length
  };

  /// `knots`: from behind to ahead, with increasing lengths. Throws std::invalid_argument if
  /// `knots` is empty.
  explicit LaneSpline(std::vector<Knot> knots);

  /// Returns the point at a length (m). Interpolates position and heading linearly between the
  /// knots; extends the path straight beyond both ends.
  Point at(double length) const;

 private:
  std::vector<Knot> knots_;
};

/// Range of lengths at which a path will be evaluated. Knots beyond it are left out, which does not
/// change the path within it.
struct Reach {
  double ahead = 0.0;   ///< m, greatest length
  double behind = 0.0;  ///< m, the greatest length behind the vehicle, not negative
};

/// Returns the candidate paths of a vehicle over a lane graph, at least one: one along every graph
/// path through every edge in `matches` (matchedEdges()), in their order, then of the edges at each
/// branch. Each is bent to pass through the vehicle's middle. The graph path goes on for the
/// distance driven at max_speed in all steps plus `length_buffer`, or ends with the lanes;
/// LaneSpline::at() continues it straight. `options.max_paths` bounds the paths ahead of an edge,
/// and those behind it. Without a match, returns one straight path along the heading. If
/// `reach.behind` is 0, paths that differ only behind the vehicle are returned once. `vehicle`:
/// global map frame; `speed`: m/s along its heading, negative backwards, sets how far paths lead
/// behind the vehicle.
std::vector<LaneSpline> laneSplinesOf(const LaneGraph& graph, const std::vector<EdgeMatch>& matches,
                                      const Pose2& vehicle, double speed, const Reach& reach,
                                      const RuleBasedOptions& options);

}  // namespace forge
