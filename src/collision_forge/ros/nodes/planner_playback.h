#pragma once

#include <ros/ros.h>

#include <mutex>
#include <optional>
#include <string>

#include "collision_forge/ros/markers/planner_markers.h"
#include "collision_forge/ros/markers/repeated_markers.h"

namespace forge {

/// Animates the rollout of a planner test in a loop at wall-clock speed, on `planner_markers`,
/// `planner_scene_markers` and `shown_area`. Meanwhile `planner_test_shown` is true, and other
/// nodes leave the picture unchanged. The animation ends on stop() and when a paused replay (with
/// /clock) continues; over a running replay it plays once. Thread-safe.
class PlannerPlayback {
 public:
  PlannerPlayback(ros::NodeHandle node, const SeverityOptions& severity);

  /// Replaces the shown test.
  void play(const PlannerTrial& trial, const CrashScenario& scenario, const std::string& planner);
  /// Ends the animation.
  void stop();

 private:
  void show(const ros::WallTimerEvent& event);
  void repeat(const ros::WallTimerEvent& event);
  bool isReplaceable(double since, double duration);
  void clear();
  void publishShownState();

  SeverityOptions severity_;
  RepeatedMarkers ways_;
  ros::Publisher scenes_;
  ros::Publisher areas_;
  ros::Publisher is_shown_;
  std::mutex mutex_;
  std::optional<ShownRollout> shown_;
  ros::WallTime begin_;     ///< begin of this pass
  ros::Time clock_;         ///< /clock of the replay at the last update
  ros::WallTime moved_;     ///< last change of the replay's clock
  bool was_still_ = false;  ///< the replay paused while the test was shown
  ros::WallTimer timer_;
  ros::WallTimer repeat_timer_;
};

}  // namespace forge
