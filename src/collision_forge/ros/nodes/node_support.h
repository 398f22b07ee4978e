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

/// Queue length of input topics: a bag may be played as fast as it can be read.
inline constexpr int kTopicQueue = 10000;

/// Returns the package's config/ folder, overlaid with the folder `overlay` unless it is empty.
ConfigFolder packageConfig(const std::string& overlay);

/// Reads the configuration of a node. Its private parameter `config_dir` names the overlay. Throws
/// ConfigError.
Config loadNodeConfig(const ros::NodeHandle& private_node);

/// Returns load(). Logs an exception as "no WHAT: MESSAGE" and rethrows it, because the nodelet
/// loader drops the message of an exception in onInit().
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
  /// Calls `on_map` for each usable map, in the thread of the subscriber callback.
  LaneMapSubscriber(
      ros::NodeHandle& node, const InputLimits& limits, std::function<void()> on_map = [] {});

  /// Returns the newest usable map; null before the first.
  std::shared_ptr<const LaneIndex> lanes() const;
  /// As lanes(), but waits up to kMapDelay for the first map if the topic has a publisher: a scene
  /// can arrive before its map. Must not be called in the thread of the subscriber callback.
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

/// A scene and a request, converted from messages and checked.
struct CheckedRequest {
  std::shared_ptr<const LaneIndex> lanes;
  Snapshot snapshot;
  CollisionRequest request;
};

/// Converts the messages and applies checkSnapshot() and checkRequest(). Returns the status of a
/// failed check, kNoScene if there is no lane map. Throws MessageError and InputError.
std::variant<CheckedRequest, Status> checkedRequest(
    const LaneMapSubscriber& map, const collision_forge::SceneSnapshot& scene,
    const collision_forge::CollisionRequest& request, const Config& config);

/// Maps an exception to a service status: INVALID_INPUT for InputError and MessageError;
/// INTERNAL_ERROR, which is also logged, for any other.
Status statusOf(const std::exception& error);

/// Fills `response` with the Status returned by `work`, or with statusOf() the exception it throws.
/// Returns true, the result of a roscpp service callback.
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

/// Serves a ROS service in its own thread. Calls are served one at a time. The callback may block
/// or call other services without delaying the topic callbacks of the node.
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

/// Returns the private parameter `after_contact` of a node; default kStop. Throws
/// std::invalid_argument, which names the parameter, for a value that liveAfterContact() rejects.
AfterContact nodeAfterContact(const ros::NodeHandle& private_node);

}  // namespace forge
