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
  /// 0 after an at-fault collision with an agent, PdmScoringOptions::static_collision_score with a
  /// static object, else 1.
  double collision = 1.0;
  /// s from t0, of the first at-fault collision; empty if there is none.
  std::optional<double> collision_time;
  /// 1, or 0 if a corner of the box leaves the drivable area at any state.
  double drivable_area = 0.0;
  /// 1, wrong_way_score or 0 by the longest distance driven without a break off the route's lanes.
  double driving_direction = 0.0;
  double driven = 0.0;    ///< m along the centreline from the first to the last middle of the ego's
                          ///< box, not negative; not a term of the score
  double progress = 0.0;  ///< share 0..1 of the best motion's; see PdmScorer::score()
  double time_to_collision = 1.0;  ///< 0 if a state is too close to a collision, else 1
  /// s from t0, of the first state that is too close; empty if there is none.
  std::optional<double> ttc_time;
  double comfort = 0.0;  ///< 1 if comfortable, else 0
  /// Product of collision, drivable_area and driving_direction times the weighted mean of progress,
  /// time_to_collision and comfort (weights of PdmScoringOptions).
  double total = 0.0;
};

/// Everything that motions are scored against. All references must outlive the scorer.
struct PdmSurroundings {
  /// Other agents; must reach beyond the motions by the longest of ttc_times.
  const PdmForecast& forecast;
  const PdmMap& map;          ///< of the same frame
  const PdmPath& centerline;  ///< of the route, for progress
  const PdmComfort& comfort;  ///< for motions of as many states
};

/// Scores motions as PDM-Closed does (Dauner et al. 2023), one term at a time.
class PdmScorer {
 public:
  /// Keeps the references in `surroundings`; copies `options`.
  PdmScorer(const PdmSurroundings& surroundings, const PdmScoringOptions& options);

  /// Returns the score of each motion, in order; empty for no motions. Red lights affect no term.
  /// All motions have as many states as `comfort` expects. Progress is `driven` times the product
  /// of collision, drivable_area and driving_direction, as a share of the largest such value among
  /// `motions`. If no value exceeds `options.min_progress`, progress is 1, or 0 for motions whose
  /// product is 0.
  std::vector<PdmScore> score(const std::vector<PdmMotion>& motions) const;

 private:
  using Places = std::vector<PdmPlace>;  // of each state

  /// A collision is at fault if the agent stands, the ego's front hits it, or the ego's side hits
  /// it while the ego is in several lanes or off the road; never if the ego stands or the agent is
  /// behind it. After a contact without fault, the agent is ignored.
  void scoreCollisions(const PdmMotion& motion, const Places& places, PdmScore& score) const;
  /// Returns whether a contact with `agent` (index) at `step` is the ego's fault. `place`: of the
  /// ego's box then.
  bool isAtFault(const PdmMotion& motion, const PdmPlace& place, std::size_t agent,
                 std::size_t step) const;
  /// Requires that the ego, driving straight at constant speed, hits no agent ahead of it within
  /// the TTC times; nor one beside it while it is in several lanes, off the road or in an
  /// intersection.
  void scoreTimeToCollision(const PdmMotion& motion, const Places& places, PdmScore& score) const;
  /// Returns whether the state at `step` fails the test of scoreTimeToCollision(); marks agents in
  /// `is_ignored` that it touches without failing.
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
  std::vector<std::size_t> ttc_steps_;  ///< ttc_times as numbers of steps
};

}  // namespace forge
