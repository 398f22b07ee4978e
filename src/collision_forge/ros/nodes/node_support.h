#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionRequest.h>
#include <collision_forge/LaneMap.h>
#include <collision_forge/SceneSnapshot.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <variant>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/batch/printable.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/injection/injection.h"

namespace forge {

/// Messages of a topic that may wait: a bag may be played as fast as it can be read.
inline constexpr int kTopicQueue = 10000;

/// The package's own config/, over which `overlay` is laid unless it is empty.
ConfigFolder packageConfig(const std::string& overlay);

/// The configuration of a node, whose private parameter `config_dir` names the overlay. Throws
/// ConfigError.
Config loadNodeConfig(const ros::NodeHandle& private_node);

/// What `load` returns. The nodelet loader does not tell what an exception of onInit() says: it is
/// logged behind "no WHAT: " and goes on.
template <typename Load>
auto loadLogged(const char* what, Load load) {
  try {
    return load();
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM("no " << what << ": " << printable(error.what()));
    throw;
  }
}

/// Keeps the newest lane map, ready for queries. Thread-safe.
class LaneMapSubscriber {
 public:
  /// Calls `on_map` when a usable map has come, in the thread that received it.
  LaneMapSubscriber(
      ros::NodeHandle& node, const InputLimits& limits, std::function<void()> on_map = [] {});

  /// Null until a usable map has come.
  std::shared_ptr<const LaneIndex> lanes() const;
  /// As lanes(), where a scene has come already: its map may come a moment later, and is waited for
  /// up to kMapDelay if somebody publishes one. Not for the thread that receives the map.
  std::shared_ptr<const LaneIndex> lanesOfScene() const;

 private:
  static constexpr std::chrono::seconds kMapDelay{1};

  void receive(const collision_forge::LaneMap& message);

  InputLimits limits_;
  std::function<void()> on_map_;
  mutable std::mutex mutex_;
  mutable std::condition_variable came_;
  std::shared_ptr<const LaneIndex> lanes_;
  ros::Subscriber subscriber_;
};

/// What is asked of a scene, in the core's terms.
struct CheckedRequest {
  std::shared_ptr<const LaneIndex> lanes;
  Snapshot snapshot;
  CollisionRequest request;
};

/// The messages converted and passed through checkSnapshot() and checkRequest(), or why that
/// failed. Throws InputError.
std::variant<CheckedRequest, Status> checkedRequest(
    const LaneMapSubscriber& map, const collision_forge::SceneSnapshot& scene,
    const collision_forge::CollisionRequest& request, const Config& config);

/// What a service answers when its work ends with an exception: INVALID_INPUT for an InputError and
/// a MessageError, and INTERNAL_ERROR, which is logged, for any other one.
Status statusOf(const std::exception& error);

/// Answers a service with the code and message that `work` returns, or statusOf() its exception.
template <typename Response, typename Work>
bool answerWith(Response& response, Work work) {
  Status status;
  try {
    status = work();
  } catch (const std::exception& error) {
    status = statusOf(error);
  }
  response.code = static_cast<std::uint8_t>(status.code);
  response.message = status.message;
  return true;
}

/// A service with a thread of its own: callers are answered one after the other, and a callback may
/// call other services without holding up what comes by topics.
class OwnThreadService {
 public:
  template <typename Owner, typename Request, typename Response>
  OwnThreadService(ros::NodeHandle node, const std::string& name,
                   bool (Owner::*callback)(Request&, Response&), Owner* owner)
      : spinner_(1, &queue_) {
    node.setCallbackQueue(&queue_);
    server_ = node.advertiseService(name, callback, owner);
    spinner_.start();
  }
  ~OwnThreadService() {
    spinner_.stop();
    server_.shutdown();
  }

 private:
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
  ros::ServiceServer server_;
};

/// Returns the private parameter `after_contact` of a node, kStop where it is not set. Throws as
/// liveAfterContact(), naming the parameter.
AfterContact nodeAfterContact(const ros::NodeHandle& private_node);

}  // namespace forge
