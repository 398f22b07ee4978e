#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/planners/pdm_comfort.h"
#include "collision_forge/planner_test/planners/pdm_forecast.h"
#include "collision_forge/planner_test/planners/pdm_map.h"
#include "collision_forge/planner_test/planners/pdm_motion.h"
#include "collision_forge/planner_test/planners/pdm_path.h"

namespace forge {

/// Score of a motion; every term and the total are in [0, 1], where 1 is good.
struct PdmScore {
  double collision =
      1.0;  ///< 0 after an at-fault collision; static_collision_score with a static object
  std::optional<double> collision_time;  ///< s from t0, of the first at-fault collision
  double drivable_area = 0.0;            ///< 0 after leaving the drivable area
  double driving_direction =
      0.0;                ///< 1, wrong_way_score or 0 by the distance driven off the route's lanes
  double driven = 0.0;    ///< m along the centreline, not negative
  double progress = 0.0;  ///< share 0..1 of the best motion's; see PdmScorer::score()
  double time_to_collision = 1.0;  ///< 0 after a state that is too close
  std::optional<double> ttc_time;  ///< s from t0, of the first state that is too close
  double comfort = 0.0;            ///< 1 if comfortable, else 0
  double total = 0.0;  ///< product of the first three terms times the weighted mean of the others
};

/// Everything that motions are scored against. All references must outlive the scorer.
struct PdmSurroundings {
  const PdmForecast& forecast;
  const PdmMap& map;
  const PdmPath& centerline;
  const PdmComfort& comfort;
};

/// Scores motions as PDM-Closed does (Dauner et al. 2023), one term at a time.
class PdmScorer {
 public:
  /// Keeps the references in `surroundings`.
  PdmScorer(const PdmSurroundings& surroundings, const PdmScoringOptions& options);

  /// Scores all terms of all motions. Progress is `driven` times the product of the first three
  /// terms, as a share of the largest such value. If no value exceeds `options.min_progress`,
  /// progress is 1, or 0 for motions whose product is 0.
  std::vector<PdmScore> score(const std::vector<PdmMotion>& motions) const;

 private:
  using Places = std::vector<PdmPlace>;  // of each state

  /// A collision is at fault if the agent stands, the ego's front hits it, or the ego's side hits
  /// it while the ego is in several lanes or off the road; never if the ego stands or the agent is
  /// behind it. After a contact without fault, the agent is ignored.
  void scoreCollisions(const PdmMotion& motion, const Places& places, PdmScore& score) const;
  bool isAtFault(const PdmMotion& motion, const PdmPlace& place, std::size_t agent,
                 std::size_t step) const;
  /// Requires that the ego, driving straight at constant speed, hits no agent ahead of it within
  /// the TTC times; nor one beside it while it is in several lanes, off the road or in an
  /// intersection.
  void scoreTimeToCollision(const PdmMotion& motion, const Places& places, PdmScore& score) const;
  bool isTooClose(const PdmMotion& motion, const PdmPlace& place, std::size_t step,
                  std::vector<bool>& is_ignored) const;
  /// Scores the longest uninterrupted distance driven off the route's lanes.
  double drivingDirection(const PdmMotion& motion, const Places& places) const;
  /// Returns the cosine of the angle between the ego's heading and the direction from its rear axle
  /// to `point`.
  static double cosineTo(const BicycleState& state, const Vector2& point);

  PdmSurroundings surroundings_;
  PdmScoringOptions options_;
  double ahead_cosine_;
  double behind_cosine_;
  std::vector<std::size_t> ttc_steps_;
};

}  // namespace forge
