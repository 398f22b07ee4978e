#pragma once

#include <collision_forge/SceneSnapshot.h>
#include <ros/time.h>

#include <boost/shared_ptr.hpp>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <variant>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/live_options.h"

namespace forge {

/// Stores the most recent scenes; a request refers to the newest or to one with a given stamp.
/// Thread-safe.
class SceneMemory {
 public:
  using Scene = boost::shared_ptr<const collision_forge::SceneSnapshot>;

  explicit SceneMemory(const LiveOptions& options) : options_(options) {}

  /// Stores `scene`, received at ROS time `clock` (s). A scene older than the newest means that the
  /// replay restarted: all earlier scenes are dropped.
  void add(const Scene& scene, double clock);

  /// Returns the newest scene. Returns kNoScene before the first scene, kStaleScene if the newest
  /// was received more than max_scene_age before `clock` (ROS time, s).
  std::variant<Scene, Status> newest(double clock) const;

  /// Returns the newest scene at or before the stamp `asked`, rounded as by stampOf(). Blocks up to
  /// wait_for wall-clock seconds for a scene that has not arrived, then returns kStaleScene.
  /// Returns kNoScene for a stamp before the oldest stored scene.
  std::variant<Scene, Status> at(const ros::Time& asked) const;

 private:
  LiveOptions options_;
  mutable std::mutex mutex_;  // guards all below
  mutable std::condition_variable came_one_;
  std::deque<Scene> scenes_;  // oldest first
  double came_ = 0.0;         // s, ROS time at which the newest was received
};

}  // namespace forge
