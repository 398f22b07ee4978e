#pragma once

#include <ros/ros.h>

#include <mutex>
#include <optional>
#include <string>

#include "collision_forge/ros/markers/planner_markers.h"
#include "collision_forge/ros/markers/repeated_markers.h"

namespace forge {

/// Animates the rollout of a planner test in a loop, in wall-clock time, on `planner_markers`,
/// `planner_scene_markers` and `shown_area`. Publishes `planner_test_shown` = true meanwhile, so
/// that other nodes do not draw the scene. The animation ends with stop(), or when a paused replay
/// (`/clock`) resumes; if the replay is running all the time, it plays once. Thread-safe.
class PlannerPlayback {
 public:
  /// `drivable` limits the post-crash deceleration of vehicles.
  PlannerPlayback(ros::NodeHandle node, const DriveLimitOptions& drivable);

  /// Starts the animation of `trial`, replacing the previous one.
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
  ros::WallTime begin_;     ///< start of this loop
  ros::Time clock_;         ///< replay time at the last timer event
  ros::WallTime moved_;     ///< wall time of the last change of clock_
  bool was_still_ = false;  ///< the replay paused since play()
  ros::WallTimer timer_;
  ros::WallTimer repeat_timer_;
};

}  // namespace forge
