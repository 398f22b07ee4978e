#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "collision_forge/planner_test/trials/planner_crash.h"
#include "collision_forge/planner_test/trials/planner_trial.h"
#include "collision_forge/ros/markers/label_places.h"
#include "collision_forge/ros/markers/shown_area.h"

namespace forge {

/// Returns the static markers of the test `trial` in `scenario`: the paths of the planner's ego,
/// the recorded ego and the planned attacker (CrashScenario::attacker) up to the end of the test,
/// and the proposals of the planner's last call. Map frame, stamp t0. Starts with DELETEALL.
/// Colours: ros/markers/marker_colors.h. `trial.outcome.driven` must not be empty.
visualization_msgs::MarkerArray plannerMarkers(const PlannerTrial& trial,
                                               const CrashScenario& scenario);

/// A planner test with the data for its animation; shownRollout() makes it. Times: s, clock of the
/// scenario.
struct ShownRollout {
  PlannerTrial trial;
  CrashScenario scenario;
  std::string planner;                     ///< name of the planner, for the text
  std::optional<PlannerCrash> crash = {};  ///< crashOf() the outcome; empty as there
  LabelSide words_side = {};               ///< place of the text beside the ego at standTime()

  /// Returns t0, s.
  double now() const { return scenario.snapshot.now; }
  /// Returns the time of the last driven state, s, which is the contact if there is one.
  double end() const { return trial.outcome.driven.back().time; }
  /// Returns the time, s, at which ego and touched vehicle both stand after the contact
  /// (PostCrashMotion::standTime()); end() without a contact.
  double standTime() const { return crash ? crash->motion.standTime() : end(); }
};

/// Returns the data for the animation of the test `trial` of the planner named `planner` in
/// `scenario`. Chooses the place of the text so that it covers as little as possible of the paths
/// of all vehicles. `severity`: for crashOf(). `trial.outcome.driven` must not be empty.
ShownRollout shownRollout(const PlannerTrial& trial, const CrashScenario& scenario,
                          const std::string& planner, const SeverityOptions& severity);

/// Returns the picture at `time`, s on the scenario's clock, from t0 on: the boxes of the planner's
/// ego, the attacker and the other agents (an agent without a state then is left out), and as text
/// the time since t0 or, from end() on, the outcome with a disc at the contact. After a contact the
/// ego and the touched vehicle move by their post-crash motion, and other agents as recorded;
/// agents that reacted in the test stand. From standTime() on all stand. Map frame. Starts with
/// DELETEALL.
visualization_msgs::MarkerArray rolloutMarkers(const ShownRollout& shown, double time);

/// Returns the part of the map that contains the ego and the attacker at `time` (s, scenario's
/// clock, from t0 on; standTime() for a later one), the ego at standTime(), and the text.
ShownArea rolloutArea(const ShownRollout& shown, double time);

}  // namespace forge
