#include "collision_forge/ros/injection/camera_boxes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr char kTopic[] = "/cam_front/camera_info";
constexpr double kFocal = 1000.0;  // pixels
using visualization_msgs::ImageMarker;

sensor_msgs::CameraInfo infoAt(double time) {
  sensor_msgs::CameraInfo info;
  info.header.frame_id = "cam_front";
  info.header.stamp = ros::Time(time);
  info.width = 1600;
  info.height = 900;
  info.K = {kFocal, 0.0, 800.0, 0.0, kFocal, 450.0, 0.0, 0.0, 1.0};
  return info;
}

/// A car of 4 x 2 x 1.5 m, its middle at the height of the camera.
collision_forge::Agent carAt(const std::string& id, double x, double y) {
  collision_forge::Agent agent;
  agent.id = id;
  agent.size.x = 4.0;
  agent.size.y = 2.0;
  agent.size.z = 1.5;
  agent.pose.position.x = x;
  agent.pose.position.y = y;
  agent.pose.position.z = 1.6;
  agent.pose.orientation.w = 1.0;
  return agent;
}

/// The optical frame of a camera that looks along x of its parent: z forward, x right, y down.
Eigen::Isometry3d opticalFrame() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  pose.translation().z() = 1.6;
  return pose;
}

/// Corners of the smallest rectangle around the lines.
Eigen::AlignedBox2d boundsOf(const std::vector<PictureLine>& lines) {
  Eigen::AlignedBox2d box;
  for (const PictureLine& line : lines) box.extend(line.begin).extend(line.end);
  return box;
}

TEST(BoxEdges, AreWhereAPinholeSeesTheCorners) {
  const auto lines = boxEdges(carAt("car", 12.0, 3.0), opticalFrame(), infoAt(0.0));
  EXPECT_EQ(lines.size(), 12u);
  const Eigen::AlignedBox2d box = boundsOf(lines);
  // The car is left of the axis: its faces are 10 m and 14 m ahead, its sides 2 m and 4 m left.
  EXPECT_NEAR(box.min().x(), 800.0 - kFocal * 4.0 / 10.0, 1e-6);
  EXPECT_NEAR(box.max().x(), 800.0 - kFocal * 2.0 / 14.0, 1e-6);
  EXPECT_NEAR(box.min().y(), 450.0 - kFocal * 0.75 / 10.0, 1e-6);
  EXPECT_NEAR(box.max().y(), 450.0 + kFocal * 0.75 / 10.0, 1e-6);
}

TEST(BoxEdges, OfUnknownHeightHaveTheTypicalOne) {
  collision_forge::Agent car = carAt("car", 12.0, 3.0);
  const Eigen::AlignedBox2d known = boundsOf(boxEdges(car, opticalFrame(), infoAt(0.0)));
  car.pose.position.z -= 0.5 * car.size.z;
  car.size.z = 0.0;
  const Eigen::AlignedBox2d box = boundsOf(boxEdges(car, opticalFrame(), infoAt(0.0)));
  EXPECT_NEAR(box.min().y(), known.min().y(), 1e-6) << "a typical car has 1.5 m";
  EXPECT_NEAR(box.max().y(), known.max().y(), 1e-6);
}

TEST(BoxEdges, FollowTheProjectionMatrixOfRectifiedPictures) {
  sensor_msgs::CameraInfo info = infoAt(0.0);
  info.P = {500.0, 0.0, 700.0, 0.0, 0.0, 500.0, 400.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  const Eigen::AlignedBox2d box = boundsOf(boxEdges(carAt("car", 12.0, 0.0), opticalFrame(), info));
  EXPECT_NEAR(box.center().x(), 700.0, 1e-6);
  EXPECT_NEAR(box.sizes().x(), 500.0 * 2.0 / 10.0, 1e-6);
}

TEST(BoxEdges, AreCutOffAtThePictureAndInFrontOfTheCamera) {
  EXPECT_TRUE(boxEdges(carAt("behind", -12.0, 0.0), opticalFrame(), infoAt(0.0)).empty());
  EXPECT_TRUE(boxEdges(carAt("beside", 10.0, 40.0), opticalFrame(), infoAt(0.0)).empty());
  const auto passing = boxEdges(carAt("passing", 1.0, 3.0), opticalFrame(), infoAt(0.0));
  ASSERT_FALSE(passing.empty());
  const Eigen::AlignedBox2d picture(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1600.0, 900.0));
  for (const PictureLine& line : passing) {
    for (const Eigen::Vector2d& pixel : {line.begin, line.end}) {
      EXPECT_LT(picture.exteriorDistance(pixel), 1e-6) << pixel.transpose();
    }
  }
}

TEST(CameraBoxes, CamerasOfOneNamespaceHaveTopicsOfTheirOwn) {
  EXPECT_EQ(CameraBoxes::boxTopic("/camera_info"), "/attack_box");
  EXPECT_EQ(CameraBoxes::boxTopic("/car/cam_front/camera_info"), "/car/cam_front/attack_box");
  EXPECT_EQ(CameraBoxes::boxTopic("/stereo/left_info"), "/stereo/left_info_attack_box");
  EXPECT_EQ(CameraBoxes::boxTopic("/stereo/right_info"), "/stereo/right_info_attack_box");
}

TEST(CameraBoxes, MarksAgentsAndDeletesWhoLeftThePicture) {
  const std::string path = std::filesystem::temp_directory_path() /
                           ("camera_boxes_" + std::to_string(getpid()) + ".bag");
  {
    NewBag bag(path);
    bag.write(kTopic, ros::Time(1.0), infoAt(1.0));
    tf2_msgs::TFMessage message;
    geometry_msgs::TransformStamped& transform = message.transforms.emplace_back();
    transform.header.frame_id = names::kMapFrame;
    transform.header.stamp = ros::Time(1.0);
    transform.child_frame_id = "cam_front";
    const Eigen::Quaterniond rotation(opticalFrame().linear());
    transform.transform.translation.z = 1.6;
    transform.transform.rotation.x = rotation.x();
    transform.transform.rotation.y = rotation.y();
    transform.transform.rotation.z = rotation.z();
    transform.transform.rotation.w = rotation.w();
    bag.writeLatched(names::kStaticTf, ros::Time(1.0), message);
    bag.commit();
  }
  const rosbag::Bag bag(path);
  CameraBoxes boxes(bag, "attacker");
  EXPECT_TRUE(boxes.has(kTopic));
  EXPECT_FALSE(boxes.has("/cam_back/camera_info"));
  EXPECT_EQ(CameraBoxes::boxTopic(kTopic), "/cam_front/attack_box");
  EXPECT_TRUE(boxes.mark(kTopic, infoAt(1.0), {}).empty());
  const auto both =
      boxes.mark(kTopic, infoAt(2.0), {carAt("parked", 20.0, 5.0), carAt("attacker", 12.0, 0.0)});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].ns, "support");
  EXPECT_EQ(both[1].ns, "attacker");
  EXPECT_NE(both[0].id, both[1].id);
  EXPECT_EQ(both[1].header, infoAt(2.0).header);
  EXPECT_EQ(both[1].action, ImageMarker::ADD);
  EXPECT_EQ(both[1].points.size(), 24u);
  EXPECT_GT(both[1].outline_color.r, 2.0F * both[1].outline_color.g) << "the attacker is red";
  const auto left = boxes.mark(kTopic, infoAt(3.0), {carAt("parked", 20.0, 5.0)});
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(left[0].action, ImageMarker::ADD);
  EXPECT_EQ(left[1].action, ImageMarker::REMOVE);
  EXPECT_EQ(left[1].id, both[1].id);
  sensor_msgs::CameraInfo nowhere = infoAt(4.0);
  nowhere.header.frame_id = "cam_loose";
  EXPECT_TRUE(boxes.mark(kTopic, nowhere, {carAt("attacker", 12.0, 0.0)}).empty());
  EXPECT_THAT(boxes.summary(), testing::ElementsAre(testing::AllOf(
                                   testing::HasSubstr("/cam_front/attack_box"),
                                   testing::HasSubstr("1 of 4 pictures"),
                                   testing::HasSubstr("1 have no transform from map"))));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace forge
