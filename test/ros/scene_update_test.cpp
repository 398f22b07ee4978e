#include "collision_forge/ros/markers/scene_update.h"

#include <gtest/gtest.h>

#include "ros/ros_decoder.h"

namespace forge {
namespace {

geometry_msgs::Pose turnedPose(double x) {
  geometry_msgs::Pose pose;
  pose.position.x = x;
  pose.orientation.z = 0.6;
  pose.orientation.w = 0.8;
  return pose;
}

geometry_msgs::Point point(double x, double y) {
  geometry_msgs::Point point;
  point.x = x;
  point.y = y;
  return point;
}

/// One entity with everything, and one with nothing.
SceneUpdate twoEntities() {
  SceneEntity full;
  full.id = "full";
  full.metadata = {{"class", "car"}, {"speed", "3 m/s"}};
  geometry_msgs::Vector3 size;
  size.x = 4.0;
  size.z = 1.5;
  full.cubes = {{turnedPose(1.0), size, {0.25F, 0.5F, 0.75F, 1.0F}}, {turnedPose(2.0), size, {}}};
  full.spheres = {{turnedPose(3.0), size, {}}};
  full.lines = {{0.2, {point(0.0, 1.0), point(2.0, 3.0)}, {1.0F, 0.0F, 0.0F, 0.5F}}};
  full.texts = {{point(5.0, 6.0), 0.7, {}, "two\nlines"}};
  SceneEntity empty;
  empty.id = "empty";
  return {ros::Time(12, 500000000), "map", {full, empty}};
}

class SceneUpdateTest : public testing::Test {
 protected:
  const RosDecoder decoded_{sceneUpdateDefinition(), toRosBytes(twoEntities())};
};

TEST_F(SceneUpdateTest, EntitiesPersistAndMoveWithTheirFrame) {
  ASSERT_EQ(decoded_.size("entities"), 2U);
  for (const std::string entity : {"entities[0]", "entities[1]"}) {
    EXPECT_EQ(decoded_.number(entity + ".timestamp"), 12.5);
    EXPECT_EQ(decoded_.number(entity + ".lifetime"), 0.0);
    EXPECT_EQ(decoded_.number(entity + ".frame_locked"), 1.0);
    EXPECT_EQ(decoded_.text(entity + ".frame_id"), "map");
  }
  EXPECT_EQ(decoded_.text("entities[0].id"), "full");
  EXPECT_EQ(decoded_.text("entities[1].id"), "empty");
  EXPECT_EQ(decoded_.text("entities[0].metadata[1].value"), "3 m/s");
}

TEST_F(SceneUpdateTest, SolidsHavePoseSizeAndColor) {
  EXPECT_EQ(decoded_.size("entities[0].cubes"), 2U);
  EXPECT_EQ(decoded_.number("entities[0].cubes[0].pose.position.x"), 1.0);
  EXPECT_EQ(decoded_.number("entities[0].cubes[1].pose.position.x"), 2.0);
  EXPECT_EQ(decoded_.number("entities[0].cubes[0].pose.orientation.z"), 0.6);
  EXPECT_EQ(decoded_.number("entities[0].cubes[0].size.x"), 4.0);
  EXPECT_EQ(decoded_.number("entities[0].cubes[0].size.z"), 1.5);
  EXPECT_EQ(decoded_.number("entities[0].cubes[0].color.g"), 0.5);
  EXPECT_EQ(decoded_.number("entities[0].cubes[0].color.a"), 1.0);
  EXPECT_EQ(decoded_.number("entities[0].spheres[0].pose.position.x"), 3.0);
}

TEST_F(SceneUpdateTest, LinesAreALineListAndTextsFaceTheViewer) {
  EXPECT_EQ(decoded_.number("entities[0].lines[0].type"), 2.0) << "LINE_LIST";
  EXPECT_EQ(decoded_.number("entities[0].lines[0].pose.orientation.w"), 1.0);
  EXPECT_EQ(decoded_.number("entities[0].lines[0].thickness"), 0.2);
  EXPECT_EQ(decoded_.number("entities[0].lines[0].points[1].y"), 3.0);
  EXPECT_EQ(decoded_.number("entities[0].lines[0].color.a"), 0.5);
  EXPECT_EQ(decoded_.number("entities[0].texts[0].billboard"), 1.0);
  EXPECT_EQ(decoded_.number("entities[0].texts[0].font_size"), 0.7);
  EXPECT_EQ(decoded_.number("entities[0].texts[0].pose.position.y"), 6.0);
  EXPECT_EQ(decoded_.text("entities[0].texts[0].text"), "two\nlines");
}

}  // namespace
}  // namespace forge
