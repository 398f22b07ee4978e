#include <collision_forge/Attack.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/io/batch/printable.h"
#include "collision_forge/ros/injection/live_lidar.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/node_support.h"
#include "collision_forge/ros/nodes/served_nodelet.h"

namespace forge {

/// points -> points_out, with the attacker of the newest attack in the clouds (LiveLidar). A cloud
/// that cannot be changed passes as it is. Logs the latency, from a cloud's arrival to its
/// publication, every kReportInterval.
class LidarInjectorNodelet : public QueuedNodelet {
 private:
  static constexpr int kClouds = 20;               // that may wait
  static constexpr double kReportInterval = 10.0;  // s
  static constexpr double kTransformWait = 0.05;   // s that a cloud waits for its transform

  void start(ros::NodeHandle node) override {
    options_ = loadNodeConfig(getPrivateNodeHandle()).lidar;
    lidar_.emplace(options_, getPrivateNodeHandle().param("all_objects", false));
    listener_ = std::make_unique<tf2_ros::TransformListener>(buffer_);
    points_ = node.advertise<sensor_msgs::PointCloud2>(names::kPointsOut, kClouds);
    subscribers_ = {
        node.subscribe(names::kAttack, 1, &LidarInjectorNodelet::receiveAttack, this),
        node.subscribe(names::kInjectedAgents, kTopicQueue, &LidarInjectorNodelet::receiveInjected,
                       this),
        node.subscribe(names::kAgents, kTopicQueue, &LidarInjectorNodelet::receiveRecorded, this),
        node.subscribe(names::kPoints, kClouds, &LidarInjectorNodelet::receivePoints, this)};
  }

  void receiveAttack(const collision_forge::Attack& attack) {
    lidar_->setAttacker(attack.trajectory.attacker_id);
  }
  void receiveInjected(const collision_forge::AgentArray::ConstPtr& frame) {
    lidar_->addInjected(frame);
  }
  void receiveRecorded(const collision_forge::AgentArray::ConstPtr& frame) {
    lidar_->addRecorded(frame);
  }

  void receivePoints(const sensor_msgs::PointCloud2::ConstPtr& recorded) {
    const auto start = std::chrono::steady_clock::now();
    const auto changed = boost::make_shared<sensor_msgs::PointCloud2>(*recorded);
    try {
      lidar_->edit(sensorOf(recorded->header), *changed);
    } catch (const std::exception& error) {
      NODELET_WARN_STREAM_THROTTLE(1.0, "cloud passes unchanged: " << printable(error.what()));
    }
    points_.publish(changed);
    report(std::chrono::steady_clock::now() - start);
  }

  /// Throws tf2::TransformException.
  SensorInSweep sensorOf(const std_msgs::Header& header) const {
    const auto poseAt = [&](const ros::Time& stamp) -> Eigen::Isometry3d {
      const auto found = buffer_
                             .lookupTransform(names::kMapFrame, header.frame_id, stamp,
                                              ros::Duration(kTransformWait))
                             .transform;
      const auto& [x, y, z, w] = found.rotation;
      return Eigen::Translation3d(found.translation.x, found.translation.y, found.translation.z) *
             Eigen::Quaterniond(w, x, y, z);
    };
    const Eigen::Isometry3d end = poseAt(header.stamp);
    if (options_.is_motion_corrected) return {end, end};
    return {poseAt(header.stamp - ros::Duration(options_.sweep_time)), end};
  }

  void report(std::chrono::steady_clock::duration latency) {
    milliseconds_.push_back(std::chrono::duration<double, std::milli>(latency).count());
    const auto now = std::chrono::steady_clock::now();
    if (std::chrono::duration<double>(now - reported_).count() < kReportInterval) return;
    reported_ = now;
    std::sort(milliseconds_.begin(), milliseconds_.end());
    NODELET_INFO_STREAM("latency p50 " << milliseconds_[milliseconds_.size() / 2] << " ms, p99 "
                                       << milliseconds_[milliseconds_.size() * 99 / 100]
                                       << " ms of " << milliseconds_.size() << " clouds");
    milliseconds_.clear();
  }

  LidarOptions options_;
  std::optional<LiveLidar> lidar_;
  tf2_ros::Buffer buffer_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  ros::Publisher points_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<double> milliseconds_;
  std::chrono::steady_clock::time_point reported_ = std::chrono::steady_clock::now();
};

using ServedLidarInjector = Served<LidarInjectorNodelet>;

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::ServedLidarInjector, nodelet::Nodelet)
