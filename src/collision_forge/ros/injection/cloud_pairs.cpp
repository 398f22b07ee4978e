#include "collision_forge/ros/injection/cloud_pairs.h"

#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/bag_frames.h"
#include "collision_forge/ros/injection/lidar_injection.h"
#include "collision_forge/ros/messages/cloud_message.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

using CloudsByStamp = std::map<ros::Time, sensor_msgs::PointCloud2>;

CloudsByStamp cloudsOf(const rosbag::Bag& bag, const std::string& topic,
                       const CloudPeriod& period) {
  CloudsByStamp clouds;
  for (const auto& instance : rosbag::View(bag, rosbag::TopicQuery(topic))) {
    const auto message = instance.instantiate<sensor_msgs::PointCloud2>();
    if (!message) continue;
    const double stamp = message->header.stamp.toSec();
    if (stamp >= period.begin && stamp <= period.end) clouds[message->header.stamp] = *message;
  }
  return clouds;
}

std::vector<Eigen::Vector3f> pointsOf(sensor_msgs::PointCloud2 message,
                                      const Eigen::Isometry3f& pose) {
  const PointCloud cloud = takeCloud(message);
  const CloudLayout layout(cloud);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const Eigen::Vector3f point = layout.position(cloud.pointAt(i)).cast<float>();
    if (point.allFinite()) points.emplace_back(pose * point);
  }
  return points;
}

std::optional<CloudPair> pairOf(const sensor_msgs::PointCloud2& recorded,
                                const sensor_msgs::PointCloud2& attacked, const BagFrames& frames) {
  const std_msgs::Header& header = recorded.header;
  const auto base = frames.poseOf(names::kBaseFrame, header.stamp);
  const auto sensor = frames.poseOf(frameName(header.frame_id), header.stamp);
  if (!base || !sensor) return std::nullopt;
  const Eigen::Isometry3f pose = (base->inverse() * *sensor).cast<float>();
  try {
    return CloudPair{header.stamp.toSec(), pointsOf(recorded, pose), pointsOf(attacked, pose)};
  } catch (const CloudError&) {
    return std::nullopt;
  }
}

std::vector<CloudPair> pairsOf(const rosbag::Bag& recorded, const rosbag::Bag& attacked,
                               const std::string& topic, const CloudPeriod& period) {
  const CloudsByStamp before = cloudsOf(recorded, topic, period);
  const CloudsByStamp after = cloudsOf(attacked, topic, period);
  const bool is_changed = std::any_of(after.begin(), after.end(), [&](const auto& cloud) {
    const auto same = before.find(cloud.first);
    return same != before.end() && same->second.data != cloud.second.data;
  });
  if (!is_changed) return {};
  BagFrames frames(names::kMapFrame, names::kBaseFrame, kLongestBag);
  addTransforms(recorded, frames);
  std::vector<CloudPair> pairs;
  const std::size_t stride = (after.size() + period.most - 1) / period.most;
  std::size_t number = 0;
  for (const auto& [stamp, cloud] : after) {
    if (number++ % stride != 0) continue;
    const auto same = before.find(stamp);
    if (same == before.end()) continue;
    if (auto pair = pairOf(same->second, cloud, frames)) pairs.push_back(std::move(*pair));
  }
  return pairs;
}

}  // namespace

std::vector<CloudPair> readCloudPairs(const std::string& recorded, const std::string& attacked,
                                      const std::vector<std::string>& topics,
                                      const CloudPeriod& period) {
  const OpenedBag before(recorded);
  const OpenedBag after(attacked);
  std::vector<std::string> candidates;
  for (const std::string& topic : topics) {
    if (topic != kAllClouds) {
      candidates.push_back(topic);
      continue;
    }
    std::set<std::string> all;
    for (const auto* connection : rosbag::View(after.bag()).getConnections()) {
      if (connection->datatype == ros::message_traits::datatype<sensor_msgs::PointCloud2>()) {
        all.insert(connection->topic);
      }
    }
    candidates.insert(candidates.end(), all.begin(), all.end());
  }
  for (const std::string& topic : candidates) {
    auto pairs = pairsOf(before.bag(), after.bag(), topic, period);
    if (!pairs.empty()) return pairs;
  }
  return {};
}

}  // namespace forge
