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

/// The numbers of nuplan-devkit's metrics; angles, distances and limits of comfort are those of
/// PdmScoringOptions.
struct NuplanScoreOptions {
  double min_progress_share = 0.2;  ///< of the recorded ego's progress; less is no progress
  double least_progress = 2.0;      ///< m; less counts as this, of ego and recording
  double ttc_horizon = 0.95;        ///< s; a collision sooner, at constant velocities, is too close
  double direction_window = 1.0;    ///< s over which driving off the route's lanes is summed
  double max_overspeed = 2.23;      ///< m/s over the limit in the mean; the score is then 0
  int acceleration_window = 8;      ///< states over which accelerations are smoothed
  int rate_window = 15;             ///< states that jerk and rates of the yaw are derived from
  double progress_weight = 5.0;
  double ttc_weight = 5.0;
  double speed_limit_weight = 4.0;  ///< where a lane has a limit; nuScenes' have none
  double comfort_weight = 2.0;
};

/// A rollout in the terms of nuPlan's closed-loop score (nuplan-devkit, evaluation metrics); every
/// one in [0, 1], 1 is good.
struct NuplanScore {
  double no_at_fault_collision = 1.0;  ///< 0 with an agent, 0.5 with a static object
  double drivable_area = 1.0;
  double driving_direction = 1.0;     ///< 1, 0.5 or 0
  double making_progress = 1.0;       ///< 1 or 0
  double time_to_collision = 1.0;     ///< 1 or 0
  double comfort = 1.0;               ///< 1 or 0
  double progress = 1.0;              ///< of the recorded ego's
  std::optional<double> speed_limit;  ///< empty where no lane that was driven on has a limit
  /// The product of the first four times the weighted mean of the others that are known.
  double total = 1.0;
};

/// A part of the score by its name, as results and tables have it.
struct NuplanPart {
  const char* name;
  double NuplanScore::*value;
};
/// All but the speed limit, the total last.
const std::array<NuplanPart, 8>& nuplanParts();

/// Who the ego touched, if anybody.
struct NuplanContact {
  bool at_fault = false;
  bool is_static_object = false;
};

/// Looks at a rollout step by step.
class NuplanJudge {
 public:
  /// `map` must outlive it. `scoring` has the angles and distances that PDM-Closed shares.
  NuplanJudge(const PdmMap& map, const EgoVehicle& ego, const PdmScoringOptions& scoring,
              const NuplanScoreOptions& options);

  /// The ego and everybody else at a time, in order; `ignored` are looked at by nobody.
  void see(const TrajectoryPoint& ego, const std::vector<Track>& agents,
           const std::set<std::string>& ignored);

  /// What was seen until the contact or the end; `driven` and `recorded` are the progress along the
  /// route, m.
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
