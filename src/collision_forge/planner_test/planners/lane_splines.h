#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/lane_graph.h"
#include "collision_forge/planner_test/planners/lane_matches.h"
#include "collision_forge/planner_test/planners/rule_based_options.h"

namespace forge {

/// A way that a vehicle may drive, by knots; 0 is where it stands, negative lengths lie behind it.
class LaneSpline {
 public:
  struct Point {
    Vector2 position{0.0, 0.0};
    Vector2 heading{1.0, 0.0};  ///< of unit length at the knots, shorter between them
  };
  struct Knot {
    double length = 0.0;  ///< m along the way
    Point point;
  };

  /// Lengths rise. Throws std::invalid_argument without a knot.
  explicit LaneSpline(std::vector<Knot> knots);

  /// Position and heading linear between knots; beyond either end straight on.
  Point at(double length) const;

 private:
  std::vector<Knot> knots_;
};

/// How far a way will be asked for: knots farther on are left out, which changes nothing nearer.
struct Reach {
  double ahead = 0.0;   ///< m
  double behind = 0.0;  ///< m
};

/// The ways of a vehicle over a lane graph: along every path through every edge of matchedEdges(),
/// in their order and for each in that of the edges at a branch, bent so that they pass through the
/// vehicle. Straight on along its heading where no edge matches. Where nothing behind it is asked
/// for, paths that differ there alone are one.
std::vector<LaneSpline> laneSplinesOf(const LaneGraph& graph, const std::vector<EdgeMatch>& matches,
                                      const Pose2& vehicle, double speed, const Reach& reach,
                                      const RuleBasedOptions& options);

}  // namespace forge
