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

/// Keeps the scenes of the last LiveOptions::kept_for seconds (of their stamps) for requests.
/// Thread-safe.
class SceneMemory {
 public:
  /// A scene; its header stamp is its t0. Not null.
  using Scene = boost::shared_ptr<const collision_forge::SceneSnapshot>;

  explicit SceneMemory(const LiveOptions& options) : options_(options) {}

  /// Adds a scene received at `clock` (s, ROS time). A stamp before the newest one means that the
  /// replay restarted: all kept scenes are dropped first.
  void add(const Scene& scene, double clock);

  /// Returns the newest scene; kNoScene before the first, kStaleScene if the newest was received
  /// more than LiveOptions::max_scene_age seconds before `clock` (s, ROS time).
  std::variant<Scene, Status> newest(double clock) const;

  /// Returns the newest scene whose stamp is at or before `asked`, rounded by stampOf() like the
  /// scenes' stamps. Unless a scene with this or a later stamp is kept, blocks up to
  /// LiveOptions::wait_for wall-clock seconds until one arrives; returns kStaleScene if none does,
  /// kNoScene if there is no scene at all. Returns kNoScene for a stamp before the oldest kept
  /// scene.
  std::variant<Scene, Status> at(const ros::Time& asked) const;

 private:
  LiveOptions options_;
  mutable std::mutex mutex_;  // guards all members below
  mutable std::condition_variable scene_added_;
  std::deque<Scene> scenes_;  // oldest first
  double came_ = 0.0;         // s, clock at which the newest scene was received
};

}  // namespace forge
