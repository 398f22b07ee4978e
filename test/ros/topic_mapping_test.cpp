#include "collision_forge/ros/bags/topic_mapping.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "collision_forge/base/config/config_error.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string shipped(const std::string& name) {
  return COLLISION_FORGE_SOURCE_DIR "/config/topics_" + name + ".yaml";
}

/// A shipped mapping with another text in one place.
TopicMapping spoilt(const std::string& from, const std::string& to) {
  std::stringstream content;
  content << std::ifstream(shipped("derived_object")).rdbuf();
  std::string text = content.str();
  replaceIn(text, from, to);
  const TemporaryFolder folder;
  return readTopicMapping(folder.write("mapping.yaml", text));
}

std::string complaintOf(const std::string& from, const std::string& to) {
  try {
    spoilt(from, to);
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("mapping.yaml"));
    return error.what();
  }
  return "";
}

/// Fields of a pose in the plane.
constexpr char kPlane[] =
    "  position: {x: east, y: north, z: -1.5}\n  orientation: {yaw: heading}\n";

std::string pathOf(const NumberSource& source) { return std::get<std::string>(source); }

TEST(ReadTopicMapping, ReadsTheMappingOfDerivedObjects) {
  const TopicMapping mapping = readTopicMapping(shipped("derived_object"));
  EXPECT_EQ(mapping.ego.fields.topic, "/odom");
  EXPECT_EQ(mapping.ego.fields.type, "nav_msgs/Odometry");
  EXPECT_EQ(mapping.ego.fields.stamp, "header.stamp");
  EXPECT_EQ(mapping.ego.fields.frame_id, "map");
  EXPECT_EQ(mapping.ego.fields.frame_id_path, "header.frame_id");
  EXPECT_EQ(mapping.ego.reference, EgoReference::kBaseLink);
  EXPECT_EQ(mapping.map_frame, "map");
  EXPECT_EQ(mapping.ego.child_frame_id, "base_link");
  EXPECT_FALSE(mapping.ego.in_transforms);
  EXPECT_EQ(pathOf(mapping.ego.pose.position[2]), "pose.pose.position.z");
  EXPECT_EQ(pathOf(std::get<0>(mapping.ego.pose.orientation)[3]), "pose.pose.orientation.w");
  const AgentsMapping& agents = mapping.agents;
  EXPECT_EQ(agents.fields.type, "derived_object_msgs/ObjectArray");
  EXPECT_EQ(agents.fields.stamp, "header.stamp");
  EXPECT_EQ(agents.id, "objects[].id");
  EXPECT_EQ(agents.classification, "objects[].classification");
  EXPECT_EQ(agents.probability, "");
  EXPECT_EQ(agents.classes.size(), 6U);
  EXPECT_EQ(agents.classes.at("7"), AgentClass::kTruck);
  EXPECT_EQ(agents.default_class, AgentClass::kStaticObject);
  EXPECT_EQ(pathOf(agents.pose.position[1]), "objects[].pose.position.y");
  EXPECT_EQ(pathOf(agents.size[2]), "objects[].shape.dimensions[2]");
  ASSERT_TRUE(agents.velocity);
  EXPECT_EQ(agents.velocity->frame, VelocityFrame::kMap);
  EXPECT_EQ(pathOf(agents.velocity->velocity[0]), "objects[].twist.linear.x");
}

TEST(ReadTopicMapping, TransformsNeedNoFieldsButTheFrameOfTheEgo) {
  const TemporaryFolder folder;
  std::stringstream content;
  content << std::ifstream(shipped("derived_object")).rdbuf();
  const std::string text = content.str();
  const std::string agents = text.substr(text.find("\nagents:"));
  const auto read = [&](const std::string& ego) {
    return readTopicMapping(
        folder.write("mapping.yaml",
                     "map_frame: world\nego: {type: tf2_msgs/TFMessage, reference: box_middle, " +
                         ego + "}" + agents));
  };
  const TopicMapping mapping = read("topic: /car/tf, frame_id: world, child_frame_id: car");
  EXPECT_TRUE(mapping.ego.in_transforms);
  EXPECT_EQ(mapping.transformTopic(), "/car/tf");
  EXPECT_EQ(mapping.map_frame, "world");
  EXPECT_EQ(mapping.ego.child_frame_id, "car");
  EXPECT_EQ(mapping.ego.reference, EgoReference::kBoxMiddle);
  EXPECT_THROW(read("topic: /tf"), ConfigError) << "child_frame_id is missing";
  EXPECT_THROW(read("topic: /tf, frame_id: odom, child_frame_id: car"), ConfigError);
}

TEST(ReadTopicMapping, OptionalKeysMayBeOmittedOrOverridden) {
  EXPECT_FALSE(spoilt("  velocity: {frame: map, vector: twist.linear}\n", "").agents.velocity);
  EXPECT_EQ(spoilt("  frame_id: map\n", "").ego.fields.frame_id, "");
  const TopicFields headless = spoilt("  frame_id: map\n", "  stamp: time\n").ego.fields;
  EXPECT_EQ(headless.stamp, "time");
  EXPECT_EQ(headless.frame_id_path, "") << "such a message may have no header";
}

TEST(ReadTopicMapping, EachNumberOfAPoseOrVelocityMayHaveItsOwnField) {
  const TopicMapping plane = spoilt("  pose: pose\n", kPlane);
  EXPECT_EQ(pathOf(plane.agents.pose.position[0]), "objects[].east");
  EXPECT_EQ(std::get<double>(plane.agents.pose.position[2]), -1.5);
  EXPECT_EQ(pathOf(std::get<NumberSource>(plane.agents.pose.orientation)), "objects[].heading");
  const TopicMapping turned =
      spoilt("  pose: pose\n",
             "  position: {x: x, y: y, z: 0}\n  orientation: {x: a, y: b, z: c, w: d}\n");
  EXPECT_EQ(pathOf(std::get<0>(turned.agents.pose.orientation)[3]), "objects[].d");
  const TopicMapping moving = spoilt("vector: twist.linear", "x: vx, y: vy, z: 0");
  EXPECT_EQ(pathOf(moving.agents.velocity->velocity[1]), "objects[].vy");
}

TEST(ReadTopicMapping, EveryKeyIsChecked) {
  EXPECT_THAT(complaintOf("ego:\n", "ego:\n  stray: 7\n"),
              AllOf(HasSubstr("ego.stray"), HasSubstr("unknown")));
  EXPECT_THAT(complaintOf("agents:\n", "agents:\n  stray: 7\n"), HasSubstr("agents.stray"));
  EXPECT_THAT(complaintOf("ego:\n", "stray: 7\nego:\n"), HasSubstr("stray"));
  EXPECT_THAT(complaintOf("  id: id\n", ""), AllOf(HasSubstr("agents.id"), HasSubstr("missing")));
  EXPECT_THAT(complaintOf("id: id", "id: ''"), AllOf(HasSubstr("agents.id"), HasSubstr("empty")));
  EXPECT_THAT(complaintOf("reference: base_link", "reference: bumper"),
              AllOf(HasSubstr("ego.reference"), HasSubstr("bumper"), HasSubstr("box_middle")));
  EXPECT_THAT(complaintOf("frame: map", "frame: sun"), HasSubstr("agents.velocity.frame"));
  EXPECT_THAT(complaintOf("6: car", "6: plane"),
              AllOf(HasSubstr("agents.class.values.6"), HasSubstr("'plane'")));
  EXPECT_THAT(complaintOf("default: static_object", "default: none"),
              HasSubstr("agents.class.default"));
  EXPECT_THAT(complaintOf("{length:", "{depth: 1, length:"), HasSubstr("agents.size.depth"));
  std::string infinite = kPlane;
  replaceIn(infinite, "-1.5", "inf");
  EXPECT_THAT(complaintOf("  pose: pose\n", infinite),
              AllOf(HasSubstr("agents.position.z"), HasSubstr("finite")));
  EXPECT_THAT(complaintOf("vector: twist.linear", "vector: twist.linear, x: vx"),
              HasSubstr("agents.velocity.x"));
  EXPECT_THAT(complaintOf("  pose: pose\n", std::string("  pose: pose\n") + kPlane),
              HasSubstr("agents.orientation"));
  EXPECT_THAT(complaintOf("objects: objects", "objects: objects[]"), HasSubstr("agents.objects"));
  EXPECT_THAT(complaintOf("ego:", "{ego:"), HasSubstr("mapping.yaml"));
}

}  // namespace
}  // namespace forge
