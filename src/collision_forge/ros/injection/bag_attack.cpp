#include "collision_forge/ros/injection/bag_attack.h"

#include <rosbag/view.h>

#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

/// Topics of a bag with an attack.
constexpr const char* kAttackTopics[] = {names::kAttack,        names::kTestedReport,
                                         names::kAttackRequest, names::kAttackPath,
                                         names::kAttackEgoPath, names::kAttackMarkers};

}  // namespace

void requireNoAttack(const std::string& path) {
  try {
    const OpenedBag opened(path);
    const rosbag::Bag& bag = opened.bag();
    for (const char* name : kAttackTopics) {
      const std::string topic = bagTopic(name);
      if (rosbag::View(bag, rosbag::TopicQuery(topic)).size() == 0) continue;
      throw BagError(path + ": already has an attack, on " + topic +
                     "; use the recording without it");
    }
  } catch (const rosbag::BagException& error) {
    throw BagError(path + ": cannot be read: " + error.what());
  }
}

}  // namespace forge
