#include "ros/node_support.h"

#include <ros/package.h>

#include "ros/conversions.h"
#include "ros/topic_names.h"

namespace forge {

Config loadNodeConfig(const ros::NodeHandle& private_node) {
  const std::string directory = private_node.param<std::string>(
      "config_dir", ros::package::getPath("collision_forge") + "/config");
  try {
    return loadConfig(directory);
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM("no configuration: " << error.what());  // the nodelet loader does not tell why
    throw;
  }
}

LaneMapSubscriber::LaneMapSubscriber(ros::NodeHandle& node)
    : subscriber_(node.subscribe(names::kLaneMap, 1, &LaneMapSubscriber::receive, this)) {}

std::shared_ptr<const LaneIndex> LaneMapSubscriber::lanes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return lanes_;
}

void LaneMapSubscriber::receive(const collision_forge::LaneMap& message) {
  try {
    auto lanes =
        std::make_shared<const LaneIndex>(std::make_shared<const LaneMap>(fromMessage(message)));
    const std::lock_guard<std::mutex> lock(mutex_);
    lanes_ = std::move(lanes);
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("lane_map of " << message.location << " is not usable: " << error.what());
  }
}

}  // namespace forge
