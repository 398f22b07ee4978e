#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/planner_test/planners/pdm_comfort.h"
#include "collision_forge/planner_test/planners/pdm_map.h"

namespace forge {

/// Parameters of nuplan-devkit's metrics; angles, distances and limits of comfort are in
/// PdmScoringOptions.
struct NuplanScoreOptions {
  double min_progress_share =
      0.2;  ///< share 0..1 of the recorded ego's progress; below it making_progress is 0
  double least_progress = 2.0;    ///< m; lower bound applied to the progress of ego and recording
  double ttc_horizon = 0.95;      ///< s; a collision sooner, at constant velocities, is too close
  double direction_window = 1.0;  ///< s over which the distance off the route's lanes is summed
  double max_overspeed = 2.23;    ///< m/s over the limit, mean, at which the score reaches 0
  int acceleration_window = 8;    ///< states over which accelerations are smoothed
  int rate_window = 15;           ///< states from which jerk and yaw rates are derived
  // Weights of the terms in the mean of NuplanScore::total.
  double progress_weight = 5.0;
  double ttc_weight = 5.0;
  double speed_limit_weight = 4.0;  ///< used if a lane has a limit; nuScenes' lanes have none
  double comfort_weight = 2.0;
};

/// The terms of nuPlan's closed-loop score of a rollout (nuplan-devkit, evaluation metrics); each
/// in [0, 1], where 1 is good.
struct NuplanScore {
  double no_at_fault_collision = 1.0;  ///< 0 after one with an agent, 0.5 with a static object
  double drivable_area = 1.0;          ///< 1 or 0
  double driving_direction = 1.0;      ///< 1, 0.5 or 0
  double making_progress = 1.0;        ///< 1 or 0
  double time_to_collision = 1.0;      ///< 1 or 0
  double comfort = 1.0;                ///< 1 or 0
  double progress = 1.0;               ///< share of the recorded ego's progress
  std::optional<double> speed_limit;   ///< empty if no lane driven on has a limit
  /// Product of the first four terms times the weighted mean of the remaining known ones.
  double total = 1.0;
};

/// A term of the score with its name in results and tables.
struct NuplanPart {
  const char* name;
  double NuplanScore::*value;
};
/// All terms but the speed limit; the total is last.
const std::array<NuplanPart, 8>& nuplanParts();

/// The ego's contact, as the score needs it.
struct NuplanContact {
  bool at_fault = false;          ///< the ego is at fault, isAtFault()
  bool is_static_object = false;  ///< the ego touches a static object
};

/// Accumulates the data of a rollout step by step and computes its score.
class NuplanJudge {
 public:
  /// `map` must outlive the judge. `scoring`: angles and distances shared with PDM-Closed.
  NuplanJudge(const PdmMap& map, const EgoVehicle& ego, const PdmScoringOptions& scoring,
              const NuplanScoreOptions& options);

  /// Adds the states of one step; call in order of time. Agents with an id in `ignored` are
  /// skipped.
  void addStep(const TrajectoryPoint& ego, const std::vector<Track>& agents,
               const std::set<std::string>& ignored);

  /// Returns the score of the steps so far. `driven` and `recorded`: progress of the ego and the
  /// recorded ego along the route, m.
  NuplanScore score(const std::optional<NuplanContact>& contact, double driven,
                    double recorded) const;

 private:
  bool isTooClose(const TrajectoryPoint& ego, const PdmPlace& place,
                  const std::vector<Track>& agents, const std::set<std::string>& ignored) const;
  double drivingDirection() const;
  bool isComfortable() const;

  const PdmMap& map_;
  EgoVehicle ego_;
  PdmScoringOptions scoring_;
  NuplanScoreOptions options_;
  std::vector<TrajectoryPoint> driven_;
  std::vector<bool> is_wrong_way_;
  double overspeed_ = 0.0;  // m/s, summed over the states
  bool has_speed_limit_ = false;
  bool leaves_road_ = false;
  bool is_too_close_ = false;
};

}  // namespace forge
