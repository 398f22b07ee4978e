#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "collision_forge/planner_test/trials/planner_crash.h"
#include "collision_forge/planner_test/trials/planner_trial.h"
#include "collision_forge/ros/markers/label_places.h"
#include "collision_forge/ros/markers/shown_area.h"

namespace forge {

/// Returns the static markers of a planner test: the paths of the planner's ego, the recorded ego
/// and the attacker up to the end of the test, and the proposals of the planner's last call. Starts
/// with DELETEALL. Colours: ros/markers/marker_colors.h.
visualization_msgs::MarkerArray plannerMarkers(const PlannerTrial& trial,
                                               const CrashScenario& scenario);

/// A planner test with the data for its animation.
struct ShownRollout {
  PlannerTrial trial;
  CrashScenario scenario;
  std::string planner;
  std::optional<PlannerCrash> crash = {};  ///< crashOf() the outcome; empty without a contact
  LabelSide words_side = {};               ///< place of the text beside the ego at standstill

  double now() const { return scenario.snapshot.now; }
  /// Returns the end of the rollout, s: the contact if there is one.
  double end() const { return trial.outcome.driven.back().time; }
  /// Returns the time, s, at which the ego stands after the contact; end() without a contact.
  double standTime() const { return crash ? crash->motion.standTime() : end(); }
};

/// The text is placed beside the paths of all vehicles.
ShownRollout shownRollout(const PlannerTrial& trial, const CrashScenario& scenario,
                          const std::string& planner, const SeverityOptions& severity);

/// Returns the picture at `time`, s on the scenario's clock: the boxes of the planner's ego, the
/// attacker and the other agents, and as text the time since t0 or, from end() on, the outcome.
/// After a contact the ego and the touched vehicle move by their post-crash motion, and other
/// agents as recorded; reactive agents stand. From standTime() on all stand. Starts with DELETEALL.
visualization_msgs::MarkerArray rolloutMarkers(const ShownRollout& shown, double time);

/// Returns the part of the map that contains the ego and the attacker at `time`, and the ego at
/// standstill.
ShownArea rolloutArea(const ShownRollout& shown, double time);

}  // namespace forge
