#include "collision_forge/ros/bags/sensor_writer.h"

#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/NavSatFix.h>
#include <sensor_msgs/PointCloud2.h>
#include <sys/stat.h>
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
    scene_.sensors[2].channel = "RADAR_FRONT";
    scene_.sensors[2].modality = "radar";
    scene_.files = {{1000000, 0, fileOf("a.bin", std::string(40, 'x')), 0, 0},
                    {1010000, 1, fileOf("a.jpg", "picture"), 1600, 900},
                    {1050000, 0, fileOf("ragged.bin", std::string(39, 'x')), 0, 0},
                    {1060000, 2, fileOf("a.pcd", kRadarHeader + std::string(12, 'r')), 0, 0},
                    {1070000, 2, fileOf("b.pcd", "radar"), 0, 0},
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

  static constexpr char kRadarHeader[] =
      "FIELDS x y rcs\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nPOINTS 1\nDATA binary\n";

  fs::path folder_ = fs::temp_directory_path() / ("sensor_writer_" + std::to_string(getpid()));
  NuScenesSensorScene scene_;
  NuScenesRecording recording_;
};

TEST_F(SensorWriterTest, WritesWhatIsThereAndCountsTheRest) {
  const std::string path = (folder_ / "out.bag").string();
  const SensorCounts counts = writeBag(path, recording_, {}, &scene_);
  EXPECT_EQ(counts.written, 3u);
  EXPECT_EQ(counts.missing, 1u);
  EXPECT_EQ(counts.unreadable, 2u);
  EXPECT_EQ(counts.missing_can, 0u);
  rosbag::Bag bag(path);
  for (const auto& instance : rosbag::View(bag, rosbag::TopicQuery("/lidar_top"))) {
    const auto cloud = instance.instantiate<sensor_msgs::PointCloud2>();
    EXPECT_EQ(cloud->header.stamp, ros::Time(1.0));
    EXPECT_EQ(cloud->header.frame_id, "lidar_top");
    EXPECT_EQ(cloud->width, 2u);
    EXPECT_EQ(cloud->point_step, 20u);
    EXPECT_EQ(cloud->data, std::vector<std::uint8_t>(40, 'x'));
  }
  rosbag::View radar(bag, rosbag::TopicQuery("/radar_front"));
  ASSERT_EQ(radar.size(), 1u);
  const auto returns = radar.begin()->instantiate<sensor_msgs::PointCloud2>();
  EXPECT_EQ(returns->header.frame_id, "radar_front");
  EXPECT_EQ(returns->fields[2].name, "rcs");
  EXPECT_EQ(returns->data, std::vector<std::uint8_t>(12, 'r'));
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

TEST_F(SensorWriterTest, FilesThatAreNotRegularAreUnreadable) {
  fs::create_directories(folder_ / "folder");
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  scene_.files = {{1000000, 0, (folder_ / "folder").string(), 0, 0},
                  {1010000, 1, (folder_ / "pipe").string(), 1600, 900},
                  {1020000, 1, (folder_ / "missing.jpg").string(), 1600, 900},
                  {1030000, 1, fileOf("a.jpg", "picture"), 1600, 900}};
  const SensorCounts counts = writeBag((folder_ / "out.bag").string(), recording_, {}, &scene_);
  EXPECT_EQ(counts.unreadable, 2u);
  EXPECT_EQ(counts.missing, 1u);
  EXPECT_EQ(counts.written, 1u);
}

TEST_F(SensorWriterTest, TheCanBusIsWrittenWithinTheTimeOfTheEgoPoses) {
  scene_.files.clear();
  scene_.dataroot = folder_.string();
  recording_.name = "scene-0061";
  recording_.location = "singapore-onenorth";
  fs::create_directories(folder_ / "can_bus");
  fileOf("can_bus/scene-0061_pose.json",
         R"([{"utime": 1000000, "pos": [0, 0, 0]}, {"utime": 1600000, "pos": [0, 0, 0]}])");
  const std::string path = (folder_ / "out.bag").string();
  EXPECT_EQ(writeBag(path, recording_, {}, &scene_).missing_can, 1u);
  const std::string row = R"("linear_accel": [1, 2, 9.8], "q": [1, 0, 0, 0],)";
  fileOf("can_bus/scene-0061_ms_imu.json",
         R"([{"utime": 999999, "rotation_rate": [0, 0, 1], )" + row.substr(0, row.size() - 1) +
             R"(}, {"utime": 1250000, )" + row + R"("rotation_rate": [0, 0, 0.5]}])");
  EXPECT_EQ(writeBag(path, recording_, {}, &scene_).missing_can, 0u);
  rosbag::Bag bag(path);
  rosbag::View inertia(bag, rosbag::TopicQuery("/imu"));
  ASSERT_EQ(inertia.size(), 1u);
  const auto imu = inertia.begin()->instantiate<sensor_msgs::Imu>();
  EXPECT_EQ(imu->header.stamp, ros::Time(1.25));
  EXPECT_EQ(imu->header.frame_id, "base_link");
  EXPECT_EQ(imu->angular_velocity.z, 0.5);
  EXPECT_EQ(imu->linear_acceleration.z, 9.8);
  EXPECT_EQ(imu->orientation.w, 1.0);
  rosbag::View places(bag, rosbag::TopicQuery("/gps"));
  ASSERT_EQ(places.size(), 1u);
  const auto fix = places.begin()->instantiate<sensor_msgs::NavSatFix>();
  EXPECT_NEAR(fix->latitude, 1.28821, 1e-5);
  EXPECT_NEAR(fix->longitude, 103.78475, 1e-5);
}

}  // namespace
}  // namespace forge
