#pragma once

#include <ros/ros.h>

#include <mutex>
#include <optional>
#include <string>

#include "collision_forge/ros/markers/planner_markers.h"
#include "collision_forge/ros/markers/repeated_markers.h"

namespace forge {

/// Animates the rollout of a planner test, from t0 to ShownRollout::standTime(), in a loop at
/// wall-clock speed with a pause of 3 s at the end, on the topics `planner_markers`,
/// `planner_scene_markers` and `shown_area`. Meanwhile `planner_test_shown` is true, and other
/// nodes leave the picture unchanged. The animation ends on stop() and when a paused replay (with
/// /clock) continues; over a running replay it plays once. Thread-safe.
class PlannerPlayback {
 public:
  /// Publishes from wall timers of `node`, in its callback queue. `severity`: for the motion after
  /// a contact.
  PlannerPlayback(ros::NodeHandle node, const SeverityOptions& severity);

  /// Shows a test from its begin, in place of the one shown before. `trial`: the test of the
  /// planner named `planner` in `scenario`; all three are copied. `trial.outcome.driven` must not
  /// be empty.
  void play(const PlannerTrial& trial, const CrashScenario& scenario, const std::string& planner);
  /// Ends the animation and deletes its markers; does nothing if no test is shown.
  void stop();

 private:
  /// Timer callback: publishes the picture of the present time, or ends the animation.
  void show(const ros::WallTimerEvent& event);
  /// Timer callback: publishes the static markers again.
  void repeat(const ros::WallTimerEvent& event);
  /// Returns true if the running replay may take the picture over. `since`: s since the begin of
  /// this pass; `duration`: s of a pass without the pause at its end.
  bool isReplaceable(double since, double duration);
  void clear();              ///< deletes test and markers; needs the lock
  void publishShownState();  ///< publishes planner_test_shown

  SeverityOptions severity_;
  RepeatedMarkers ways_;     ///< planner_markers
  ros::Publisher scenes_;    ///< planner_scene_markers
  ros::Publisher areas_;     ///< shown_area
  ros::Publisher is_shown_;  ///< planner_test_shown
  std::mutex mutex_;
  std::optional<ShownRollout> shown_;  ///< empty: no animation
  ros::WallTime begin_;                ///< begin of this pass
  ros::Time clock_;                    ///< /clock of the replay at the last update
  ros::WallTime moved_;                ///< last change of the replay's clock
  bool was_still_ = false;             ///< the replay paused while the test was shown
  ros::WallTimer timer_;               ///< calls show()
  ros::WallTimer repeat_timer_;        ///< calls repeat()
};

}  // namespace forge
