#include "collision_forge/ros/injection/live_lidar.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

#include "collision_forge/io/lidar/simulated_sweep.h"
#include "collision_forge/ros/messages/cloud_message.h"

namespace forge {
namespace {

/// Flat ground around a sensor 1.8 m above the map's origin.
sensor_msgs::PointCloud2 groundAt(double time) {
  sensor_msgs::PointCloud2 message;
  message.header.stamp = ros::Time(time);
  putCloud(simulateSweep({}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, -1.8)), {}, 0),
           message);
  return message;
}

SensorInSweep sensor() {
  const Eigen::Isometry3d pose(Eigen::Translation3d(0.0, 0.0, 1.8));
  return {pose, pose};
}

/// A frame with one car at x, which drives along x at 10 m/s.
collision_forge::AgentArray::ConstPtr frame(double time, double x) {
  const auto message = boost::make_shared<collision_forge::AgentArray>();
  message->header.stamp = ros::Time(time);
  collision_forge::Agent& agent = message->agents.emplace_back();
  agent.id = "attacker";
  agent.size.x = 4.0;
  agent.size.y = 1.9;
  agent.size.z = 1.5;
  agent.pose.position.x = x;
  agent.pose.position.z = 0.75;
  agent.pose.orientation.w = 1.0;
  agent.velocity.x = 10.0;
  return message;
}

/// Smallest x of the points above the ground; infinity without any.
double rearOf(sensor_msgs::PointCloud2 message) {
  const PointCloud cloud = takeCloud(message);
  const CloudLayout layout(cloud);
  double rear = INFINITY;
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const Eigen::Vector3d point = layout.position(cloud.pointAt(i));
    if (point.z() > -1.5) rear = std::min(rear, point.x());
  }
  return rear;
}

TEST(LiveLidar, ShowsTheAttackerWhereItIsAtTheStamp) {
  LiveLidar lidar({0.0, 0.05, true}, false);
  sensor_msgs::PointCloud2 cloud = groundAt(10.0);
  EXPECT_FALSE(lidar.edit(sensor(), cloud));
  lidar.addInjected(frame(9.8, 8.0));
  EXPECT_FALSE(lidar.edit(sensor(), cloud)) << "no attack yet";
  lidar.setAttacker("attacker");
  ASSERT_TRUE(lidar.edit(sensor(), cloud));
  const double extrapolated = rearOf(cloud);
  EXPECT_NEAR(extrapolated, 8.0 + 0.2 * 10.0 - 2.0, 0.4);
  lidar.addInjected(frame(10.2, 12.0));
  sensor_msgs::PointCloud2 again = groundAt(10.0);
  ASSERT_TRUE(lidar.edit(sensor(), again));
  EXPECT_NEAR(rearOf(again), extrapolated, 0.05);
}

/// Number of points above the ground whose x is in a range; the sensor is at x = 0.
std::size_t pointsBetween(sensor_msgs::PointCloud2 message, double from, double to) {
  const PointCloud cloud = takeCloud(message);
  const CloudLayout layout(cloud);
  std::size_t count = 0;
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const Eigen::Vector3d point = layout.position(cloud.pointAt(i));
    if (point.z() > -1.55 && point.x() > from && point.x() < to && std::abs(point.y()) < 1.5) {
      ++count;
    }
  }
  return count;
}

TEST(LiveLidar, NoPointOfTheRecordedCarStays) {
  // The sensor sees the moving car up to half a metre behind its place at the stamp.
  LiveLidar drawing({0.02, 0.05, true}, false);
  drawing.setAttacker("attacker");
  drawing.addInjected(frame(10.0, 8.0));
  sensor_msgs::PointCloud2 cloud = groundAt(10.0);
  ASSERT_TRUE(drawing.edit(sensor(), cloud));
  ASSERT_GT(pointsBetween(cloud, 5.0, 11.0), 50u);
  LiveLidar lidar({0.02, 0.05, true}, false);
  lidar.setAttacker("attacker");
  lidar.addRecorded(frame(10.0, 8.0));
  lidar.addInjected(frame(10.0, 20.0));
  ASSERT_TRUE(lidar.edit(sensor(), cloud));
  EXPECT_EQ(pointsBetween(cloud, 5.0, 11.0), 0u);
  EXPECT_GT(pointsBetween(cloud, 16.0, 23.0), 3u);
}

TEST(LiveLidar, FramesThatAreTooOldAreNotShown) {
  LiveLidar lidar({0.0, 0.05, true}, true);
  lidar.addInjected(frame(9.0, 8.0));
  sensor_msgs::PointCloud2 cloud = groundAt(9.0 + LiveLidar::kReach + 0.1);
  const sensor_msgs::PointCloud2 before = cloud;
  EXPECT_FALSE(lidar.edit(sensor(), cloud));
  EXPECT_EQ(cloud, before);
}

TEST(LiveLidar, ShowsAllObjectsIfAsked) {
  LiveLidar lidar({0.0, 0.05, true}, true);
  lidar.addInjected(frame(10.0, 8.0));
  sensor_msgs::PointCloud2 cloud = groundAt(10.0);
  EXPECT_TRUE(lidar.edit(sensor(), cloud));
}

}  // namespace
}  // namespace forge
