#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "collision_forge/planner_test/trials/planner_crash.h"
#include "collision_forge/planner_test/trials/planner_trial.h"
#include "collision_forge/ros/markers/label_places.h"
#include "collision_forge/ros/markers/shown_area.h"

namespace forge {

/// Returns the static paths of a planner test: the ego as the planner drove it beside the
/// recorded one and the attacker, up to the end of the test, and the proposals of the planner's
/// last call. Starts with DELETEALL. Colours: ros/markers/marker_colors.h.
visualization_msgs::MarkerArray plannerMarkers(const PlannerTrial& trial,
                                               const CrashScenario& scenario);

/// A planner's test in motion.
struct ShownRollout {
  PlannerTrial trial;
  CrashScenario scenario;
  std::string planner;
  std::optional<PlannerCrash> crash = {};  ///< crashOf() the trial's outcome
  LabelSide words_side = {};               ///< of the place where the ego comes to a stand

  double now() const { return scenario.snapshot.now; }
  /// The end of the rollout: the contact, where there is one.
  double end() const { return trial.outcome.driven.back().time; }
  /// When the ego stands after the contact; the end of the rollout without a contact.
  double standTime() const { return crash ? crash->motion.standTime() : end(); }
};

/// `limits` bound the braking of crashed vehicles. The text keeps clear of all vehicles' paths.
ShownRollout shownRollout(const PlannerTrial& trial, const CrashScenario& scenario,
                          const std::string& planner, const DriveLimitOptions& limits);

/// One instant of the rollout: the boxes of the ego as the planner drove it, of the attacker and of
/// all other agents, and as text the time since t0 of the test. From the end of the rollout on the
/// words are the outcome. After a contact the ego and the vehicle that it touches move as in
/// `shown.crash`; other agents move as recorded, and reactive ones stand. From standTime() on all
/// stand. `time` is in seconds on the scenario's clock. Starts with DELETEALL.
visualization_msgs::MarkerArray rolloutMarkers(const ShownRollout& shown, double time);

/// Returns the part of the map that holds the ego and the attacker at `time`, and where the ego
/// comes to a stand.
ShownArea rolloutArea(const ShownRollout& shown, double time);

}  // namespace forge
