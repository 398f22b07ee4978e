#include "collision_forge/ros/nodes/node_support.h"

#include <ros/package.h>

#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/io/batch/printable.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {

ConfigFolder packageConfig(const std::string& overlay) {
  return {ros::package::getPath("collision_forge") + "/config", overlay};
}

Config loadNodeConfig(const ros::NodeHandle& private_node) {
  const auto overlay = private_node.param<std::string>("config_dir", "");
  return loadLogged("configuration", [&] { return loadConfig(packageConfig(overlay)); });
}

LaneMapSubscriber::LaneMapSubscriber(ros::NodeHandle& node, const InputLimits& limits,
                                     std::function<void()> on_map)
    : limits_(limits),
      on_map_(std::move(on_map)),
      subscriber_(node.subscribe(names::kLaneMap, 1, &LaneMapSubscriber::receive, this)) {}

std::shared_ptr<const LaneIndex> LaneMapSubscriber::lanes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return lanes_;
}

std::shared_ptr<const LaneIndex> LaneMapSubscriber::lanesOfScene() const {
  const bool may_come = subscriber_.getNumPublishers() > 0;
  std::unique_lock<std::mutex> lock(mutex_);
  if (may_come) came_.wait_for(lock, kMapDelay, [this] { return lanes_ != nullptr; });
  return lanes_;
}

void LaneMapSubscriber::receive(const collision_forge::LaneMap& message) {
  try {
    requireMapFrame(message.header, names::kLaneMap);
    const auto map = std::make_shared<const LaneMap>(fromMessage(message));
    checkMap(*map, limits_, names::kLaneMap);
    auto lanes = std::make_shared<const LaneIndex>(map);
    const std::lock_guard<std::mutex> lock(mutex_);
    lanes_ = std::move(lanes);
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("lane_map of " << printable(message.location)
                                    << " is not usable: " << printable(error.what()));
    return;
  }
  came_.notify_all();
  on_map_();
}

Status statusOf(const std::exception& error) {
  const bool is_input = dynamic_cast<const InputError*>(&error) != nullptr ||
                        dynamic_cast<const MessageError*>(&error) != nullptr;
  if (is_input) return {StatusCode::kInvalidInput, error.what()};
  ROS_ERROR_STREAM("internal error: " << printable(error.what()));
  return {StatusCode::kInternalError, error.what()};
}

std::variant<CheckedRequest, Status> checkedRequest(
    const LaneMapSubscriber& map, const collision_forge::SceneSnapshot& scene,
    const collision_forge::CollisionRequest& request, const Config& config) {
  const auto parsed = fromMessage(request, config.crash);
  if (const Status* refusal = std::get_if<Status>(&parsed)) return *refusal;
  CheckedRequest checked{map.lanesOfScene(), fromMessage(scene),
                         std::get<CollisionRequest>(parsed)};
  if (checked.request.type == CollisionType::kAny) {
    return Status{StatusCode::kUnknownType,
                  "collision_type = any is only for generate_collision: name one type"};
  }
  checkSnapshot(checked.snapshot, config.input_limits, "scene");
  checked.request = withFullId(checked.request, checked.snapshot);
  if (!checked.lanes) return Status{StatusCode::kNoScene, "no usable lane_map received yet"};
  const Status status = checkRequest(checked.request, checked.snapshot, config.attack.prediction);
  if (status.code != StatusCode::kOk) return status;
  return checked;
}

AfterContact nodeAfterContact(const ros::NodeHandle& private_node) {
  const auto word = private_node.param<std::string>("after_contact", "stop");
  try {
    return liveAfterContact(word);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("after_contact = \"" + word + "\" is " + error.what());
  }
}

}  // namespace forge
