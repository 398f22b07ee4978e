#pragma once

#include <ros/ros.h>

#include <mutex>
#include <optional>
#include <string>

#include "collision_forge/ros/markers/planner_markers.h"
#include "collision_forge/ros/markers/repeated_markers.h"

namespace forge {

/// Shows the rollout of a planner's test in motion, in the time of the wall clock, again and again,
/// on `planner_markers`, `planner_scene_markers` and `shown_area`. `planner_test_shown` is true
/// while it does, so that others leave the picture to it. The rollout gives the picture back when
/// stop() is called, and where a replay with `/clock` goes on after it stood still; over a replay
/// that runs all the time the rollout plays once. Thread-safe.
class PlannerPlayback {
 public:
  /// `drivable` limits the braking of crashed vehicles.
  PlannerPlayback(ros::NodeHandle node, const DriveLimitOptions& drivable);

  /// Shows a test in place of the one before.
  void play(const PlannerTrial& trial, const CrashScenario& scenario, const std::string& planner);
  void stop();

 private:
  void show(const ros::WallTimerEvent& event);
  void repeat(const ros::WallTimerEvent& event);
  bool isReplaceable(double since, double duration);
  void clear();
  void publishWhetherShown();

  DriveLimitOptions drivable_;
  RepeatedMarkers ways_;
  ros::Publisher scenes_;
  ros::Publisher areas_;
  ros::Publisher is_shown_;
  std::mutex mutex_;
  std::optional<ShownRollout> shown_;
  ros::WallTime begin_;     ///< of this pass
  ros::Time clock_;         ///< of the replay, at the last look
  ros::WallTime moved_;     ///< when the replay's clock was last seen to move
  bool was_still_ = false;  ///< the replay, since the test is shown
  ros::WallTimer timer_;
  ros::WallTimer repeat_timer_;
};

}  // namespace forge
