#include "collision_forge/ros/bags/copied_sensors.h"

#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <string>

namespace forge {
namespace {

class CopiedSensorsTest : public testing::Test {
 protected:
  void TearDown() override {
    for (const std::string& path : {source_, target_}) std::filesystem::remove(path);
  }

  /// A bag with a cloud, and transforms map -> car (moving), car -> roof -> lidar.
  void writeSource() const {
    NewBag bag(source_);
    tf2_msgs::TFMessage fixed;
    for (const auto& [parent, child] :
         {std::pair{"roof", "lidar"}, {"car", "roof"}, {"map", "pole"}}) {
      auto& transform = fixed.transforms.emplace_back();
      transform.header.frame_id = parent;
      transform.child_frame_id = child;
      transform.transform.translation.z = 1.0;
      transform.transform.rotation.w = 1.0;
    }
    bag.write("/tf_static", ros::Time(500.0), fixed);
    sensor_msgs::PointCloud2 cloud;
    cloud.header.stamp = ros::Time(100.0);
    cloud.header.frame_id = "lidar";
    cloud.data = {1, 2, 3};
    bag.write("/points", ros::Time(500.0), cloud);
    bag.write("/words", ros::Time(500.0), std_msgs::String());
    bag.commit();
  }

  std::string source_ = std::filesystem::temp_directory_path() /
                        ("copied_sensors_in_" + std::to_string(getpid()) + ".bag");
  std::string target_ = std::filesystem::temp_directory_path() /
                        ("copied_sensors_out_" + std::to_string(getpid()) + ".bag");
};

TEST_F(CopiedSensorsTest, CloudsAndTheirMountingAreCopiedAtTheirStamps) {
  writeSource();
  TopicMapping mapping;
  mapping.ego.child_frame_id = "car";
  mapping.ego.reference = EgoReference::kBoxMiddle;
  EgoVehicle ego;
  ego.center_offset = 1.5;
  const OpenedBag source(source_);
  NewBag target(target_);
  EXPECT_EQ(copySensors(source.bag(), mapping, ego, target), 1u);
  target.commit();

  rosbag::Bag bag(target_);
  std::map<std::string, std::string> parents;
  for (const auto& instance : rosbag::View(bag)) {
    EXPECT_EQ(instance.getTime(), ros::Time(100.0));
    EXPECT_NE(instance.getTopic(), "/words");
    if (const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>()) {
      EXPECT_EQ(cloud->data, (std::vector<std::uint8_t>{1, 2, 3}));
    }
    const auto fixed = instance.instantiate<tf2_msgs::TFMessage>();
    if (!fixed) continue;
    for (const auto& transform : fixed->transforms) {
      parents[transform.child_frame_id] = transform.header.frame_id;
      EXPECT_EQ(transform.transform.translation.x, transform.child_frame_id == "car" ? 1.5 : 0.0);
    }
  }
  EXPECT_EQ(parents, (std::map<std::string, std::string>{
                         {"car", "base_link"}, {"roof", "car"}, {"lidar", "roof"}}));
}

}  // namespace
}  // namespace forge
