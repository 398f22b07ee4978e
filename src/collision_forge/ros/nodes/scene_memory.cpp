#include "collision_forge/ros/nodes/scene_memory.h"

#include <algorithm>
#include <chrono>
#include <iterator>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

Status noScene() {
  return {StatusCode::kNoScene, "no encoded_scene yet: agents, lane_map and /tf must be published"};
}

}  // namespace

void SceneMemory::add(const Scene& scene, double clock) {
  const ros::Time& stamp = scene->header.stamp;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!scenes_.empty() && stamp < scenes_.back()->header.stamp) scenes_.clear();
    scenes_.push_back(scene);
    while (stamp - scenes_.front()->header.stamp > ros::Duration(options_.kept_for)) {
      scenes_.pop_front();
    }
    came_ = clock;
  }
  scene_added_.notify_all();
}

std::variant<SceneMemory::Scene, Status> SceneMemory::newest(double clock) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (scenes_.empty()) return noScene();
  const double age = clock - came_;
  if (age <= options_.max_scene_age) return scenes_.back();
  return Status{
      StatusCode::kStaleScene,
      formatted("the newest scene, stamp %.3f, arrived %.1f s ago, and max_scene_age is %g s: are "
                "agents and /tf still published?",
                scenes_.back()->header.stamp.toSec(), age, options_.max_scene_age)};
}

std::variant<SceneMemory::Scene, Status> SceneMemory::at(const ros::Time& asked) const {
  const ros::Time stamp = stampOf(asked.toSec());
  std::unique_lock<std::mutex> lock(mutex_);
  const bool has_come = scene_added_.wait_for(
      lock, std::chrono::duration<double>(options_.wait_for),
      [&] { return !scenes_.empty() && scenes_.back()->header.stamp >= stamp; });
  if (scenes_.empty()) return noScene();
  if (!has_come) {
    return Status{
        StatusCode::kStaleScene,
        formatted("no scene with stamp %.3f or later arrived within %g s; the newest has stamp "
                  "%.3f",
                  stamp.toSec(), options_.wait_for, scenes_.back()->header.stamp.toSec())};
  }
  const auto after = std::find_if(scenes_.begin(), scenes_.end(),
                                  [&](const Scene& scene) { return scene->header.stamp > stamp; });
  if (after != scenes_.begin()) return *std::prev(after);
  return Status{StatusCode::kNoScene,
                formatted("stamp %.3f is earlier than the oldest stored scene, "
                          "stamp %.3f",
                          stamp.toSec(), scenes_.front()->header.stamp.toSec())};
}

}  // namespace forge
