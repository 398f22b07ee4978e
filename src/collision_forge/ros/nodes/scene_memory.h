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

/// The scenes that came last, for requests: of now, or of a stamp. Thread-safe.
class SceneMemory {
 public:
  using Scene = boost::shared_ptr<const collision_forge::SceneSnapshot>;

  explicit SceneMemory(const LiveOptions& options) : options_(options) {}

  /// `clock`: s, when it came. One from before the newest is of a replay that starts again: those
  /// before it are forgotten.
  void add(const Scene& scene, double clock);

  /// The newest, at a time of that clock; kNoScene before the first, kStaleScene where none has
  /// come for longer than max_scene_age.
  std::variant<Scene, Status> newest(double clock) const;

  /// The one at or before a stamp, which is taken as those of scenes are (stampOf()): agents may
  /// have finer ones. One that is still to come is waited for, up to wait_for seconds
  /// of the wall clock; then kStaleScene. kNoScene for one from before all that are kept.
  std::variant<Scene, Status> at(const ros::Time& asked) const;

 private:
  LiveOptions options_;
  mutable std::mutex mutex_;  // of all that follows
  mutable std::condition_variable came_one_;
  std::deque<Scene> scenes_;  // oldest first
  double came_ = 0.0;         // s, the clock when the newest came
};

}  // namespace forge
