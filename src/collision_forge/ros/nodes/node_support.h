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
#include "collision_forge/ros/injection/after_contact.h"

namespace forge {

/// Queue size of subscriptions, messages: a bag may be played as fast as it can be read.
inline constexpr int kTopicQueue = 10000;

/// Returns the package's config/ folder, overlaid with the folder at path `overlay` unless that is
/// empty; reads no file.
ConfigFolder packageConfig(const std::string& overlay);

/// Loads the configuration of a node with packageConfig(); its private parameter `config_dir`
/// (default: "") names the overlay. Throws ConfigError, after logging it.
Config loadNodeConfig(const ros::NodeHandle& private_node);

/// Returns load(). Logs an exception as "no WHAT: ..." (`what`: name of the loaded thing, as
/// "configuration") and rethrows it, because the nodelet loader drops the text of exceptions from
/// onInit().
template <typename Load>
auto loadLogged(const char* what, Load load) {
  try {
    return load();
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM("no " << what << ": " << printable(error.what()));
    throw;
  }
}

/// Subscribes to lane_map and keeps an index of the newest map. Invalid maps are logged and
/// ignored. Thread-safe.
class LaneMapSubscriber {
 public:
  /// Calls `on_map` after each valid map, in the thread that received it, when lanes() already
  /// returns the map. `limits`: for checkMap(). `node` resolves the topic; its queue receives.
  LaneMapSubscriber(
      ros::NodeHandle& node, const InputLimits& limits, std::function<void()> on_map = [] {});

  /// Returns the newest map; null before the first valid map.
  std::shared_ptr<const LaneIndex> lanes() const;
  /// Like lanes(), but waits up to kMapDelay for the first map if lane_map has a publisher; null if
  /// none arrives. For use after a scene was received. Must not be called in the thread that
  /// receives the map.
  std::shared_ptr<const LaneIndex> lanesOfScene() const;

 private:
  static constexpr std::chrono::seconds kMapDelay{1};  // wall clock

  void receive(const collision_forge::LaneMap& message);

  InputLimits limits_;
  std::function<void()> on_map_;
  mutable std::mutex mutex_;                // guards `lanes_`
  mutable std::condition_variable came_;    // notified after each valid map
  std::shared_ptr<const LaneIndex> lanes_;  // of the newest map; null: none
  ros::Subscriber subscriber_;
};

/// A scene and a request that passed checkedRequest().
struct CheckedRequest {
  std::shared_ptr<const LaneIndex> lanes;  ///< not null
  Snapshot snapshot;                       ///< with a null map
  CollisionRequest request;                ///< a short attacker id is replaced by the full one
};

/// Converts both messages and checks them with checkSnapshot() and checkRequest(). Returns the
/// status of the first failed check, in this order: of fromMessage(), kUnknownType for type "any",
/// kNoScene if `map` has no map (lanesOfScene()), or of checkRequest(). `config`: crash definition,
/// input limits and prediction options. Throws MessageError as fromMessage() and InputError as
/// checkSnapshot().
std::variant<CheckedRequest, Status> checkedRequest(
    const LaneMapSubscriber& map, const collision_forge::SceneSnapshot& scene,
    const collision_forge::CollisionRequest& request, const Config& config);

/// Returns the status for an exception in a service callback: kInvalidInput for InputError and
/// MessageError; kInternalError, which is logged, for any other exception.
Status statusOf(const std::exception& error);

/// Runs `work` in a service callback and copies the Status that it returns, or statusOf() its
/// exception, to `code` and `message` of `response`. Returns true: for ROS, the call succeeded.
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

/// A service with its own thread. Runs one call at a time; a callback may block or call other
/// services without delaying the topics of the node. The destructor waits for a running call.
class OwnThreadService {
 public:
  /// Advertises the service `name`, resolved by `node`, and starts the thread, which calls
  /// (owner->*callback)(request, response). `owner` must outlive the object.
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

/// Returns the private parameter `after_contact` of a node ("stop", the default, or "drive_on").
/// Throws std::invalid_argument like liveAfterContact(), with the parameter's name and value in the
/// message.
AfterContact nodeAfterContact(const ros::NodeHandle& private_node);

}  // namespace forge
