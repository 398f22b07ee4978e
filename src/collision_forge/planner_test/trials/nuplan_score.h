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
  /// Share 0..1 of the recorded ego's progress; at or below it making_progress is 0.
  double min_progress_share = 0.2;
  double least_progress = 2.0;  ///< m; lower bound applied to the progress of ego and recording
  /// s; a collision sooner, at constant velocities, sets time_to_collision to 0.
  double ttc_horizon = 0.95;
  double direction_window = 1.0;  ///< s over which the distance off the route's lanes is summed
  double max_overspeed = 2.23;    ///< m/s over the limit, mean, at which the score reaches 0
  int acceleration_window = 8;    ///< number of states over which accelerations are smoothed
  int rate_window = 15;           ///< number of states from which jerk and yaw rates are derived
  // Weights of the terms in the mean of NuplanScore::total.
  double progress_weight = 5.0;  ///< of `progress`
  double ttc_weight = 5.0;       ///< of `time_to_collision`
  /// Weight of `speed_limit`, used if a lane has a limit; nuScenes' lanes have none.
  double speed_limit_weight = 4.0;
  double comfort_weight = 2.0;  ///< of `comfort`
};

/// The terms of nuPlan's closed-loop score of a rollout (nuplan-devkit, evaluation metrics); each
/// in [0, 1], where 1 is good.
struct NuplanScore {
  /// 0 after an at-fault collision with an agent, PdmScoringOptions::static_collision_score with a
  /// static object, else 1.
  double no_at_fault_collision = 1.0;
  double drivable_area = 1.0;  ///< 0 if a corner of the box leaves the drivable area, else 1
  /// 1, wrong_way_score or 0 by the greatest distance driven off the route's lanes within
  /// direction_window (wrong_way_distance, max_wrong_way_distance of PdmScoringOptions).
  double driving_direction = 1.0;
  double making_progress = 1.0;  ///< 1 if `progress` exceeds min_progress_share, else 0
  /// 0 if a collision was nearer than ttc_horizon at any step, else 1. Counts agents ahead, and
  /// beside the ego while it is in several lanes or in an intersection; not while the ego stands.
  double time_to_collision = 1.0;
  double comfort = 1.0;  ///< 1 if all limits of PdmComfortOptions are kept, else 0
  /// Share of the recorded ego's progress along the route, at most 1 (both raised to
  /// least_progress); 0 for an ego more than least_progress behind its start
  double progress = 1.0;
  std::optional<double> speed_limit;  ///< 1 minus mean overspeed over all steps / max_overspeed, at
                                      ///< least 0; empty if no lane driven on has a limit
  /// Product of the first four terms times the weighted mean of progress, time_to_collision,
  /// comfort and, if known, speed_limit.
  double total = 1.0;
};

/// A term of the score with its name in results and tables ("score" for the total).
struct NuplanPart {
  const char* name;            ///< e.g. "drivable_area"
  double NuplanScore::*value;  ///< the member
};
/// Returns all terms but the speed limit, in the order of NuplanScore up to `progress`, each under
/// the name of its member; the total is last, as "score".
const std::array<NuplanPart, 8>& nuplanParts();

/// The ego's contact, as the score needs it.
struct NuplanContact {
  bool at_fault = false;          ///< the ego is at fault, isAtFault()
  bool is_static_object = false;  ///< the ego touches a static object
};

/// Accumulates the data of a rollout step by step and computes its score. Poses are the middle of
/// the box in the global map frame.
class NuplanJudge {
 public:
  /// `map`: areas around the route; must outlive the judge. `scoring`: angles and distances shared
  /// with PDM-Closed.
  NuplanJudge(const PdmMap& map, const EgoVehicle& ego, const PdmScoringOptions& scoring,
              const NuplanScoreOptions& options);

  /// Adds the states of one step; call in order of time, from t0 on. `agents`: other agents, each
  /// with a state at that time as its newest. Agents with an id in `ignored` are skipped.
  void addStep(const TrajectoryPoint& ego, const std::vector<Track>& agents,
               const std::set<std::string>& ignored);

  /// Returns the score of the steps so far (at least one). `contact`: the ego's first contact;
  /// nullopt if there is none. `driven` and `recorded`: progress of the ego and the recorded ego
  /// along the route, m.
  NuplanScore score(const std::optional<NuplanContact>& contact, double driven,
                    double recorded) const;

 private:
  /// Returns whether the ego collides within ttc_horizon at constant velocities. `place`: of its
  /// box.
  bool isTooClose(const TrajectoryPoint& ego, const PdmPlace& place,
                  const std::vector<Track>& agents, const std::set<std::string>& ignored) const;
  /// Returns NuplanScore::driving_direction of the steps so far.
  double drivingDirection() const;
  /// Returns whether all limits of comfort are kept; true for fewer than five states.
  bool isComfortable() const;

  const PdmMap& map_;
  EgoVehicle ego_;
  PdmScoringOptions scoring_;
  NuplanScoreOptions options_;
  std::vector<TrajectoryPoint> driven_;  ///< the ego at each step
  std::vector<bool> is_wrong_way_;       ///< PdmPlace::is_wrong_way at each step
  double overspeed_ = 0.0;               // m/s, summed over the states
  bool has_speed_limit_ = false;
  bool leaves_road_ = false;
  bool is_too_close_ = false;
};

}  // namespace forge
