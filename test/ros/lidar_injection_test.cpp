#include "collision_forge/ros/injection/lidar_injection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <string>

#include "collision_forge/io/lidar/simulated_sweep.h"
#include "collision_forge/ros/bags/bag_writer.h"
#include "collision_forge/ros/messages/cloud_message.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr char kTopic[] = "/lidar_top";

/// An ego that stands at the origin for 2 s, and a car 12 m ahead that stands, too.
NuScenesRecording recording() {
  NuScenesRecording recording;
  recording.name = "standing";
  for (int i = 0; i <= 20; ++i) {
    NuScenesEgoPose& pose = recording.ego_poses.emplace_back();
    pose.timestamp_us = 1000000 + 100000 * i;
  }
  for (int i = 0; i <= 4; ++i) {
    NuScenesFrame& frame = recording.frames.emplace_back();
    frame.timestamp_us = 1000000 + 500000 * i;
    NuScenesAnnotation& car = frame.annotations.emplace_back();
    car.instance = "car";
    car.category = "vehicle.car";
    car.size = {4.5, 1.9, 1.5};
    car.translation = {12.0, 0.0, 0.75};
  }
  return recording;
}

collision_forge::Agent carAt(double x, double y) {
  collision_forge::Agent agent;
  agent.id = "attacker";
  agent.size.x = 4.5;
  agent.size.y = 1.9;
  agent.size.z = 1.5;
  agent.pose.position.x = x;
  agent.pose.position.y = y;
  agent.pose.position.z = 0.75;
  agent.pose.orientation.w = 1.0;
  return agent;
}

class LidarInjectionTest : public testing::Test {
 protected:
  void SetUp() override {
    const NuScenesRecording scene = recording();
    const NuScenesSensorScene sensors = simulatedSensors(scene);
    writeBag(path_, scene, {}, &sensors, [](NewBag& bag) {
      sensor_msgs::PointCloud2 radar;
      radar.header.stamp = ros::Time(1.5);
      radar.header.frame_id = "radar_front";
      radar.fields.resize(1);
      radar.fields[0].name = "rcs";
      bag.write("/radar_front", radar.header.stamp, radar);
    });
    bag_.open(path_, rosbag::bagmode::Read);
    for (const auto& instance : rosbag::View(bag_, rosbag::TopicQuery("/agents"))) {
      agents_.push_back(*instance.instantiate<collision_forge::AgentArray>());
    }
    setup_.topics = {kAllClouds};
    setup_.options.sweep_time = 0.05;
    setup_.recorded = &agents_;
    setup_.placed = [](const ros::Time&) { return LidarInjection::Agents{carAt(9.0, 5.0)}; };
  }
  void TearDown() override {
    bag_.close();
    std::filesystem::remove(path_);
  }

  sensor_msgs::PointCloud2 firstCloud() {
    rosbag::View view(bag_, rosbag::TopicQuery(kTopic));
    return *view.begin()->instantiate<sensor_msgs::PointCloud2>();
  }

  /// Number of points above the ground around a place in the map frame, which is base_link's.
  static std::size_t pointsAt(sensor_msgs::PointCloud2 message, double x, double y) {
    const PointCloud cloud = takeCloud(message);
    const CloudLayout layout(cloud);
    std::size_t count = 0;
    for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
      const Eigen::Vector3d point = layout.position(cloud.pointAt(i));
      const Eigen::Vector2d place(point.y() + 0.94 - x, -point.x() - y);
      if (point.z() > -1.6 && place.norm() < 2.6) ++count;
    }
    return count;
  }

  std::string path_ = std::filesystem::temp_directory_path() /
                      ("lidar_injection_" + std::to_string(getpid()) + ".bag");
  rosbag::Bag bag_;
  std::vector<collision_forge::AgentArray> agents_;
  LidarInjection::Setup setup_;
};

TEST_F(LidarInjectionTest, TheAttackerIsInTheCloudWhereTheTransformsPutIt) {
  LidarInjection injection(bag_, setup_);
  ASSERT_TRUE(injection.has(kTopic));
  sensor_msgs::PointCloud2 cloud = firstCloud();
  const sensor_msgs::PointCloud2 before = cloud;
  ASSERT_TRUE(injection.edit(kTopic, cloud));
  EXPECT_EQ(pointsAt(before, 9.0, 5.0), 0u);
  EXPECT_GT(pointsAt(cloud, 9.0, 5.0), 15u);
  EXPECT_EQ(pointsAt(cloud, 12.0, 0.0), pointsAt(before, 12.0, 0.0));
  EXPECT_EQ(cloud.header, before.header);
  EXPECT_EQ(cloud.fields, before.fields);
  EXPECT_THAT(injection.summary(), testing::ElementsAre(testing::HasSubstr("1 of 1 clouds changed"),
                                                        testing::HasSubstr("learnt from")));
  EXPECT_TRUE(injection.warnings().empty());
}

TEST_F(LidarInjectionTest, ItsRecordedPlaceIsEmptiedAndFilled) {
  setup_.vacated = [](const ros::Time&) { return LidarInjection::Agents{carAt(12.0, 0.0)}; };
  LidarInjection injection(bag_, setup_);
  sensor_msgs::PointCloud2 cloud = firstCloud();
  ASSERT_GT(pointsAt(cloud, 12.0, 0.0), 15u);
  ASSERT_TRUE(injection.edit(kTopic, cloud));
  EXPECT_EQ(pointsAt(cloud, 12.0, 0.0), 0u);
  EXPECT_THAT(injection.summary().front(), testing::HasSubstr("of its recorded place taken out"));
}

TEST_F(LidarInjectionTest, VehiclesWithoutUsableBoxTeachNothingAndStopNothing) {
  const auto raysFrom = [this] {
    const std::string line = LidarInjection(bag_, setup_).summary().back();
    return line.substr(line.find(':'));
  };
  const std::string from_the_car = raysFrom();
  ASSERT_THAT(from_the_car, testing::HasSubstr("learnt from"));
  const auto with = [](const auto& change) {
    collision_forge::Agent agent = carAt(12.0, 0.0);
    agent.id = "unusable";
    change(agent);
    return agent;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<collision_forge::Agent> unusable = {
      with([](auto& agent) { agent.size.z = 0.0; }), with([](auto& agent) { agent.size.x = -4.5; }),
      with([](auto& agent) { agent.pose.orientation.w = 0.0; }),
      with([&](auto& agent) { agent.pose.position.x = nan; }),
      with([&](auto& agent) { agent.velocity.x = nan; })};
  const std::vector<collision_forge::AgentArray> recorded = agents_;
  for (const collision_forge::Agent& agent : unusable) {
    agents_ = recorded;
    for (auto& frame : agents_) frame.agents.push_back(agent);
    EXPECT_EQ(raysFrom(), from_the_car) << agent;
    for (auto& frame : agents_) frame.agents = {agent};
    EXPECT_THAT(raysFrom(), testing::HasSubstr("no recorded vehicle to learn from")) << agent;
  }
}

TEST_F(LidarInjectionTest, CloudsThatCannotBeChangedAreCountedByReason) {
  LidarInjection injection(bag_, setup_);
  sensor_msgs::PointCloud2 elsewhere = firstCloud();
  elsewhere.header.frame_id = "nowhere";
  EXPECT_FALSE(injection.edit(kTopic, elsewhere));
  sensor_msgs::PointCloud2 nameless = firstCloud();
  nameless.fields[2].name = "height";
  EXPECT_FALSE(injection.edit(kTopic, nameless));
  EXPECT_THAT(injection.warnings(),
              testing::UnorderedElementsAre(testing::HasSubstr("no transform from map to nowhere"),
                                            testing::HasSubstr("field z is missing")));
}

TEST_F(LidarInjectionTest, SweepsOutOfOrderAreChangedAlike) {
  LidarInjection injection(bag_, setup_);
  rosbag::View view(bag_, rosbag::TopicQuery(kTopic));
  sensor_msgs::PointCloud2 last =
      *std::next(view.begin(), 10)->instantiate<sensor_msgs::PointCloud2>();
  sensor_msgs::PointCloud2 again = last;
  EXPECT_TRUE(injection.edit(kTopic, last));
  sensor_msgs::PointCloud2 first = firstCloud();
  EXPECT_TRUE(injection.edit(kTopic, first));
  EXPECT_TRUE(injection.edit(kTopic, again));
  EXPECT_EQ(again, last);
}

TEST_F(LidarInjectionTest, TwoTopicsOfOneSensorShowTheSameAttacker) {
  const sensor_msgs::PointCloud2 recorded = firstCloud();
  const std::string path = path_ + "_twice.bag";
  const NuScenesRecording scene = recording();
  const NuScenesSensorScene sensors = simulatedSensors(scene);
  writeBag(path, scene, {}, &sensors,
           [&](NewBag& bag) { bag.write("/copy", recorded.header.stamp, recorded); });
  const rosbag::Bag bag(path);
  LidarInjection injection(bag, setup_);
  sensor_msgs::PointCloud2 cloud = recorded;
  sensor_msgs::PointCloud2 copy = recorded;
  EXPECT_TRUE(injection.edit(kTopic, cloud));
  EXPECT_TRUE(injection.edit("/copy", copy));
  EXPECT_EQ(cloud, copy);
  EXPECT_EQ(injection.summary().size(), 3u) << "one line per topic, one on returns";
  std::filesystem::remove(path);
}

TEST_F(LidarInjectionTest, RadarsAreChangedOnlyIfNamed) {
  EXPECT_FALSE(LidarInjection(bag_, setup_).has("/radar_front"));
  setup_.topics = {"/radar_front"};
  EXPECT_TRUE(LidarInjection(bag_, setup_).has("/radar_front"));
}

TEST_F(LidarInjectionTest, TopicsWithoutCloudsAreRefused) {
  setup_.topics = {"/points"};
  try {
    const LidarInjection injection(bag_, setup_);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(
        error.what(),
        "no sensor_msgs/PointCloud2 on /points; the bag has clouds on /lidar_top, /radar_front");
  }
}

}  // namespace
}  // namespace forge
