#include "collision_forge/ros/bags/copied_sensors.h"

#include <rosbag/view.h>
#include <std_msgs/Header.h>
#include <tf2_msgs/TFMessage.h>

#include <set>
#include <string>
#include <vector>

#include "collision_forge/ros/bags/bag_frames.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

bool isSensor(const rosbag::ConnectionInfo* connection) {
  return connection->datatype.rfind("sensor_msgs/", 0) == 0;
}

/// Returns the stamp of a message that begins with a header, as all of sensor_msgs with a time do.
ros::Time stampOf(const rosbag::MessageInstance& instance) {
  std::vector<std::uint8_t> bytes(instance.size());
  ros::serialization::OStream written(bytes.data(), instance.size());
  instance.write(written);
  ros::serialization::IStream stream(bytes.data(), instance.size());
  std_msgs::Header header;
  ros::serialization::deserialize(stream, header);
  return header.stamp;
}

/// Returns the transforms below the frame `root`, and from base_link to it if it has another name.
tf2_msgs::TFMessage mountingBelow(const std::string& root, const TopicMapping& mapping,
                                  const EgoVehicle& ego, const rosbag::Bag& source) {
  std::vector<geometry_msgs::TransformStamped> fixed;
  const rosbag::TopicQuery topic(mapping.transformTopic() + "_static");
  for (const rosbag::MessageInstance& instance : rosbag::View(source, topic)) {
    const auto message = instance.instantiate<tf2_msgs::TFMessage>();
    if (!message) continue;
    for (const auto& transform : usableTransforms(*message)) fixed.push_back(transform);
  }
  tf2_msgs::TFMessage mounting;
  std::set<std::string> frames = {root};
  if (root != names::kBaseFrame) {
    geometry_msgs::TransformStamped& transform = mounting.transforms.emplace_back();
    transform.header.frame_id = names::kBaseFrame;
    transform.child_frame_id = root;
    transform.transform.rotation.w = 1.0;
    const bool is_middle = mapping.ego.reference == EgoReference::kBoxMiddle;
    transform.transform.translation.x = is_middle ? ego.center_offset : 0.0;
  }
  for (std::size_t found = 0; found != frames.size();) {
    found = frames.size();
    for (const auto& transform : fixed) {
      if (frames.count(transform.header.frame_id) == 0) continue;
      if (frames.insert(transform.child_frame_id).second) mounting.transforms.push_back(transform);
    }
  }
  return mounting;
}

}  // namespace

std::size_t copySensors(const rosbag::Bag& source, const TopicMapping& mapping,
                        const EgoVehicle& ego, NewBag& target) {
  std::size_t count = 0;
  try {
    rosbag::View view(source, isSensor);
    if (view.size() == 0) return 0;
    const std::string frame = frameName(mapping.ego.child_frame_id);
    tf2_msgs::TFMessage mounting =
        mountingBelow(frame.empty() ? names::kBaseFrame : frame, mapping, ego, source);
    for (const rosbag::MessageInstance& instance : view) {
      const ros::Time stamp = stampOf(instance);
      if (stamp.isZero()) continue;
      if (count++ == 0 && !mounting.transforms.empty()) {
        for (auto& transform : mounting.transforms) transform.header.stamp = stamp;
        target.writeLatched(names::kStaticTf, stamp, mounting);
      }
      target.write(instance.getTopic(), stamp, instance, instance.getConnectionHeader());
    }
  } catch (const rosbag::BagException& error) {
    throw BagError(std::string("its sensors cannot be copied: ") + error.what());
  } catch (const ros::serialization::StreamOverrunException& error) {
    throw BagError(std::string("a message of sensor_msgs has no header: ") + error.what());
  }
  return count;
}

}  // namespace forge
