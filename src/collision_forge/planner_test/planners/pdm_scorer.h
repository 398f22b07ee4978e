#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/planners/pdm_comfort.h"
#include "collision_forge/planner_test/planners/pdm_forecast.h"
#include "collision_forge/planner_test/planners/pdm_map.h"
#include "collision_forge/planner_test/planners/pdm_motion.h"
#include "collision_forge/planner_test/planners/pdm_path.h"

namespace forge {

/// What a motion is worth; every term and the total in [0, 1], 1 is good.
struct PdmScore {
  double collision = 1.0;  ///< 0 after an at-fault collision, the static score with a static object
  std::optional<double> collision_time;  ///< s from now, of the first such
  double drivable_area = 0.0;
  double driving_direction = 0.0;
  double driven = 0.0;    ///< m along the centreline, not negative
  double progress = 0.0;  ///< of these, beside the best motion's
  double time_to_collision = 1.0;
  std::optional<double> ttc_time;  ///< s from now, of the first state that is too close
  double comfort = 0.0;
  double total = 0.0;
};

/// What the motions of one planning step are held against. All must outlive the scorer.
struct PdmSurroundings {
  const PdmForecast& forecast;
  const PdmMap& map;
  const PdmPath& centerline;
  const PdmComfort& comfort;
};

/// Scores motions as PDM-Closed does (Dauner et al. 2023), each term for itself.
class PdmScorer {
 public:
  PdmScorer(const PdmSurroundings& surroundings, const PdmScoringOptions& options);

  /// All terms. Progress is beside the farthest of the motions that the first three terms do not
  /// rule out; where none gets farther than options.min_progress it is 1, and 0 for those ruled
  /// out.
  std::vector<PdmScore> score(const std::vector<PdmMotion>& motions) const;

 private:
  using Places = std::vector<PdmPlace>;  // of each state

  /// A collision is the ego's fault if the agent stands, or the ego's front hits it, or the ego's
  /// side while the ego is in several lanes or off the road; never while the ego stands or with an
  /// agent behind it. Whom the ego touches without fault is let alone from then on.
  void scoreCollisions(const PdmMotion& motion, const Places& places, PdmScore& score) const;
  bool isAtFault(const PdmMotion& motion, const PdmPlace& place, std::size_t agent,
                 std::size_t step) const;
  /// Going on straight at its speed the ego must hit nobody ahead of it within the times looked
  /// ahead (nor beside it while it is in several lanes, off the road or in an intersection).
  void scoreTimeToCollision(const PdmMotion& motion, const Places& places, PdmScore& score) const;
  bool isTooClose(const PdmMotion& motion, const PdmPlace& place, std::size_t step,
                  std::vector<bool>& let_alone) const;
  /// By the longest way driven without a break where no lane of the route is.
  double drivingDirection(const PdmMotion& motion, const Places& places) const;
  /// Cosine of the angle from the ego's heading to `point`, seen from its rear axle.
  static double cosineTo(const BicycleState& state, const Vector2& point);

  PdmSurroundings surroundings_;
  PdmScoringOptions options_;
  double ahead_cosine_;
  double behind_cosine_;
  std::vector<std::size_t> ttc_steps_;
};

}  // namespace forge
