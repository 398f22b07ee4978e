#include "collision_forge/ros/bags/sensor_writer.h"

#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "collision_forge/ros/bags/bag_writer.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

class SensorWriterTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    scene_.sensors.resize(3);
    scene_.sensors[0].channel = "LIDAR_TOP";
    scene_.sensors[0].modality = "lidar";
    scene_.sensors[0].translation = {0.9, 0.0, 1.8};
    scene_.sensors[1].channel = "CAM_FRONT";
    scene_.sensors[1].modality = "camera";
    scene_.sensors[1].intrinsic = {1266.0, 0.0, 816.0, 0.0, 1267.0, 491.0, 0.0, 0.0, 1.0};
    scene_.sensors[2].modality = "radar";
    scene_.files = {{1000000, 0, fileOf("a.bin", std::string(40, 'x')), 0, 0},
                    {1010000, 1, fileOf("a.jpg", "picture"), 1600, 900},
                    {1050000, 0, fileOf("ragged.bin", std::string(39, 'x')), 0, 0},
                    {1060000, 2, fileOf("a.pcd", "radar"), 0, 0},
                    {1100000, 0, (folder_ / "missing.bin").string(), 0, 0}};
    recording_.ego_poses.resize(2);
    recording_.ego_poses[0].timestamp_us = 1000000;
    recording_.ego_poses[1].timestamp_us = 1500000;
    recording_.frames.resize(1);
    recording_.frames[0].timestamp_us = 1000000;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string fileOf(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return (folder_ / name).string();
  }

  fs::path folder_ = fs::temp_directory_path() / ("sensor_writer_" + std::to_string(getpid()));
  NuScenesSensorScene scene_;
  NuScenesRecording recording_;
};

TEST_F(SensorWriterTest, WritesWhatIsThereAndCountsTheRest) {
  const std::string path = (folder_ / "out.bag").string();
  const SensorCounts counts = writeBag(path, recording_, {}, &scene_);
  EXPECT_EQ(counts.written, 2u);
  EXPECT_EQ(counts.missing, 1u);
  EXPECT_EQ(counts.unreadable, 1u);
  EXPECT_EQ(counts.skipped, 1u);
  rosbag::Bag bag(path);
  for (const auto& instance : rosbag::View(bag, rosbag::TopicQuery("/lidar_top"))) {
    const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>();
    EXPECT_EQ(cloud->header.stamp, ros::Time(1.0));
    EXPECT_EQ(cloud->header.frame_id, "lidar_top");
    EXPECT_EQ(cloud->width, 2u);
    EXPECT_EQ(cloud->point_step, 20u);
    EXPECT_EQ(cloud->data, std::vector<std::uint8_t>(40, 'x'));
  }
  for (const auto& instance : rosbag::View(bag, rosbag::TopicQuery("/cam_front/camera_info"))) {
    const auto info = instance.instantiate<sensor_msgs::CameraInfo>();
    EXPECT_EQ(info->K[2], 816.0);
    EXPECT_EQ(info->P[5], 1267.0);
    EXPECT_EQ(info->width, 1600u);
  }
  std::set<std::string> frames;
  for (const auto& instance : rosbag::View(bag, rosbag::TopicQuery("/tf_static"))) {
    for (const auto& transform : instance.instantiate<tf2_msgs::TFMessage>()->transforms) {
      frames.insert(transform.child_frame_id);
    }
  }
  EXPECT_EQ(frames.count("lidar_top") + frames.count("cam_front"), 2u);
  EXPECT_EQ(rosbag::View(bag, rosbag::TopicQuery("/cam_front/image_rect_compressed")).size(), 1u);
}

}  // namespace
}  // namespace forge
