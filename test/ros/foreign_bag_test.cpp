#include "collision_forge/ros/bags/foreign_bag.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/bags/bag_reader.h"
#include "collision_forge/ros/bags/bag_writer.h"
#include "collision_forge/ros/messages/object_array.h"
#include "collision_forge/ros/messages/ros_bytes.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

/// Bytes with the definition of their type, as a program of others records them.
struct ForeignMessage {
  std::string type;
  std::string definition;
  std::string bytes;
};

constexpr char kTrackedObjects[] = "autoware_auto_perception_msgs/TrackedObjects";

/// As rosbags-convert writes it of a bag of ROS 2.
constexpr char kTrackedObjectsDefinition[] = R"(std_msgs/Header header
autoware_auto_perception_msgs/TrackedObject[] objects
================================================================================
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
================================================================================
MSG: autoware_auto_perception_msgs/TrackedObject
unique_identifier_msgs/UUID object_id
float32 existence_probability
autoware_auto_perception_msgs/ObjectClassification[] classification
autoware_auto_perception_msgs/TrackedObjectKinematics kinematics
autoware_auto_perception_msgs/Shape shape
================================================================================
MSG: unique_identifier_msgs/UUID
uint8[16] uuid
================================================================================
MSG: autoware_auto_perception_msgs/ObjectClassification
uint8 UNKNOWN=0
uint8 CAR=1
uint8 label
float32 probability
================================================================================
MSG: autoware_auto_perception_msgs/TrackedObjectKinematics
uint8 UNAVAILABLE=0
geometry_msgs/PoseWithCovariance pose_with_covariance
uint8 orientation_availability
geometry_msgs/TwistWithCovariance twist_with_covariance
geometry_msgs/AccelWithCovariance acceleration_with_covariance
bool is_stationary
================================================================================
MSG: geometry_msgs/PoseWithCovariance
geometry_msgs/Pose pose
float64[36] covariance
================================================================================
MSG: geometry_msgs/Pose
geometry_msgs/Point position
geometry_msgs/Quaternion orientation
================================================================================
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
================================================================================
MSG: geometry_msgs/TwistWithCovariance
geometry_msgs/Twist twist
float64[36] covariance
================================================================================
MSG: geometry_msgs/Twist
geometry_msgs/Vector3 linear
geometry_msgs/Vector3 angular
================================================================================
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/AccelWithCovariance
geometry_msgs/Accel accel
float64[36] covariance
================================================================================
MSG: geometry_msgs/Accel
geometry_msgs/Vector3 linear
geometry_msgs/Vector3 angular
================================================================================
MSG: autoware_auto_perception_msgs/Shape
uint8 BOUNDING_BOX=0
uint8 type
geometry_msgs/Polygon footprint
geometry_msgs/Vector3 dimensions
================================================================================
MSG: geometry_msgs/Polygon
geometry_msgs/Point32[] points
================================================================================
MSG: geometry_msgs/Point32
float32 x
float32 y
float32 z
)";

}  // namespace
}  // namespace forge

namespace ros {
namespace message_traits {

template <>
struct DataType<forge::ForeignMessage> {
  static const char* value(const forge::ForeignMessage& message) { return message.type.c_str(); }
};
template <>
struct MD5Sum<forge::ForeignMessage> {
  static const char* value(const forge::ForeignMessage& /*message*/) { return "*"; }
};
template <>
struct Definition<forge::ForeignMessage> {
  static const char* value(const forge::ForeignMessage& message) {
    return message.definition.c_str();
  }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<forge::ForeignMessage> {
  template <typename Stream>
  static void write(Stream& stream, const forge::ForeignMessage& message) {
    std::copy(message.bytes.begin(), message.bytes.end(),
              stream.advance(static_cast<std::uint32_t>(message.bytes.size())));
  }
  static std::uint32_t serializedLength(const forge::ForeignMessage& message) {
    return static_cast<std::uint32_t>(message.bytes.size());
  }
};

}  // namespace serialization
}  // namespace ros

namespace forge {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const EgoVehicle kEgo{{4.0, 2.0}, 1.5};
constexpr double kHalfTurn = 0.70710678118654752;  // sine of 45 degrees, half of a turn to +y

TopicMapping shipped(const std::string& name) {
  return readTopicMapping(COLLISION_FORGE_SOURCE_DIR "/config/topics_" + name + ".yaml");
}

std_msgs::Header headerAt(double time, const std::string& frame = "map") {
  std_msgs::Header header;
  header.stamp = ros::Time(time);
  header.frame_id = frame;
  return header;
}

/// At x = `time`, towards +y.
nav_msgs::Odometry odometryAt(double time) {
  nav_msgs::Odometry message;
  message.header = headerAt(time);
  message.pose.pose.position.x = time;
  message.pose.pose.position.z = 0.5;
  message.pose.pose.orientation.z = kHalfTurn;
  message.pose.pose.orientation.w = kHalfTurn;
  return message;
}

/// At x = 20 + id, y = 3 * time, towards +x.
DerivedObject objectAt(std::uint32_t id, double time) {
  DerivedObject object;
  object.id = id;
  object.pose.position.x = 20.0 + id;
  object.pose.position.y = 3.0 * time;
  object.pose.orientation.w = 1.0;
  object.velocity.y = 3.5;
  object.size.x = 4.5;
  object.size.y = 1.75;
  object.size.z = 1.5;
  object.classification = 6;
  return object;
}

ObjectArray objectsAt(double time) {
  ObjectArray array;
  array.header = headerAt(time);
  array.objects = {objectAt(7, time)};
  return array;
}

class ForeignBagTest : public testing::Test {
 protected:
  /// Of messages that are right: one of the ego and one of the agents at 1, 1.1 and 1.2 s.
  void SetUp() override {
    for (const double time : {1.0, 1.1, 1.2}) {
      ego_.push_back(odometryAt(time));
      objects_.push_back(objectsAt(time));
    }
  }

  /// Everything is recorded in this order, 10 ms apart, whatever the stamps say.
  template <typename Ego, typename Agents>
  void write(const std::string& ego_topic, const std::vector<Ego>& ego,
             const std::string& agents_topic, const std::vector<Agents>& agents) {
    NewBag bag(path_);
    for (std::size_t i = 0; i < ego.size(); ++i) {
      bag.write(ego_topic, ros::Time(1.0 + 0.01 * i), ego[i]);
    }
    for (std::size_t i = 0; i < agents.size(); ++i) {
      bag.write(agents_topic, ros::Time(1.0 + 0.01 * i), agents[i]);
    }
    bag.write("/chatter", ros::Time(1.0), std_msgs::String());
    bag.commit();
  }
  void write() { write("/odom", ego_, "/objects", objects_); }

  NuScenesRecording read() {
    warnings_.clear();
    return readForeignBag(path_, mapping_, kEgo, &warnings_);
  }

  std::string complaint() {
    try {
      read();
    } catch (const BagError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path_));
      return error.what();
    }
    return "";
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.path() + "/drive.bag";
  TopicMapping mapping_ = shipped("derived_object");
  std::vector<nav_msgs::Odometry> ego_;
  std::vector<ObjectArray> objects_;
  std::vector<std::string> warnings_;
};

TEST_F(ForeignBagTest, DerivedObjectsBecomeARecording) {
  objects_[1].objects.push_back(objectAt(9, 1.1));
  objects_[1].objects.back().classification = 4;
  objects_[2].objects.clear();
  write();
  const NuScenesRecording recording = read();
  EXPECT_THAT(warnings_, IsEmpty());
  EXPECT_EQ(recording.name, "drive");
  EXPECT_EQ(recording.location, "");
  ASSERT_EQ(recording.ego_poses.size(), 3U);
  EXPECT_EQ(recording.ego_poses[1].timestamp_us, 1100000);
  EXPECT_EQ(recording.ego_poses[1].translation, Eigen::Vector3d(1.1, 0.0, 0.5));
  EXPECT_NEAR(yawOf(recording.ego_poses[1].rotation), M_PI / 2.0, 1e-12);
  ASSERT_EQ(recording.frames.size(), 3U);
  EXPECT_EQ(recording.frames[1].timestamp_us, 1100000);
  EXPECT_THAT(recording.frames[2].annotations, IsEmpty());
  ASSERT_EQ(recording.frames[1].annotations.size(), 2U);
  const NuScenesAnnotation& car = recording.frames[1].annotations[0];
  EXPECT_EQ(car.instance, "7");
  EXPECT_EQ(car.category, "vehicle.car");
  EXPECT_EQ(car.translation, Eigen::Vector3d(27.0, 3.0 * 1.1, 0.0));
  EXPECT_EQ(car.size, Eigen::Vector3d(4.5, 1.75, 1.5));
  EXPECT_EQ(car.velocity, Eigen::Vector3d(0.0, 3.5, 0.0));
  EXPECT_EQ(yawOf(car.rotation), 0.0);
  EXPECT_EQ(recording.frames[1].annotations[1].category, "human.pedestrian");
}

/// A bag of ours, by what it holds for other tools.
TEST_F(ForeignBagTest, BagsOfThisPackageAreReadBack) {
  write();
  const NuScenesRecording recording = read();
  LaneMap map;
  map.lanes.resize(1);
  map.lanes[0].id = "lane";
  const std::string own = folder_.path() + "/own.bag";
  writeBag(own, recording, map);
  mapping_.agents.fields.topic = "/agent_objects";
  const NuScenesRecording again = readForeignBag(own, mapping_, kEgo);
  ASSERT_EQ(again.ego_poses.size(), 3U);
  ASSERT_EQ(again.frames.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.ego_poses[i].timestamp_us, recording.ego_poses[i].timestamp_us);
    EXPECT_EQ(again.ego_poses[i].translation, recording.ego_poses[i].translation);
    const NuScenesAnnotation& one = recording.frames[i].annotations.at(0);
    const NuScenesAnnotation& other = again.frames[i].annotations.at(0);
    EXPECT_EQ(other.instance, one.instance);
    EXPECT_EQ(other.category, one.category);
    EXPECT_EQ(other.translation, one.translation);
    EXPECT_EQ(other.size, one.size);
    EXPECT_EQ(other.velocity, one.velocity);
  }
  const InputLimits limits = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").input_limits;
  ASSERT_NE(readLaneMap(own, limits), nullptr);
  EXPECT_EQ(readLaneMap(own, limits)->lanes.at(0).id, "lane");
  EXPECT_EQ(readLaneMap(path_, limits), nullptr);
}

/// A car that turned to +y and drives 5 m/s, and something that is rather a truck than a car.
ForeignMessage trackedObjectsAt(double time) {
  constexpr std::size_t kCovariance = 36;
  const std::vector<std::vector<std::pair<std::uint8_t, float>>> classes = {{{1, 0.9F}},
                                                                            {{1, 0.4F}, {2, 0.6F}}};
  std::string bytes;
  appendRosBytes(bytes, headerAt(time));
  appendRosBytes(bytes, static_cast<std::uint32_t>(classes.size()));
  for (std::size_t i = 0; i < classes.size(); ++i) {
    for (std::uint8_t byte = 0; byte < 16; ++byte) {
      appendRosBytes(bytes, static_cast<std::uint8_t>(byte + i));
    }
    appendRosBytes(bytes, 1.0F);
    appendRosBytes(bytes, static_cast<std::uint32_t>(classes[i].size()));
    for (const auto& [label, probability] : classes[i]) {
      appendRosBytes(bytes, label);
      appendRosBytes(bytes, probability);
    }
    const auto appendDoubles = [&](const std::vector<double>& numbers) {
      for (const double number : numbers) appendRosBytes(bytes, number);
    };
    const std::vector<double> covariance(kCovariance, 0.25);
    appendDoubles({10.0, 20.0 * time, 1.0, 0.0, 0.0, kHalfTurn, kHalfTurn});
    appendDoubles(covariance);
    appendRosBytes(bytes, std::uint8_t{2});
    appendDoubles({5.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    appendDoubles(covariance);
    appendDoubles(std::vector<double>(6, 0.0));
    appendDoubles(covariance);
    appendRosBytes(bytes, std::uint8_t{0});
    appendRosBytes(bytes, std::uint8_t{0});
    appendRosBytes(bytes, std::vector<float>{});  // points of the footprint
    appendDoubles({4.25, 1.5, 1.75});
  }
  return {kTrackedObjects, kTrackedObjectsDefinition, bytes};
}

TEST_F(ForeignBagTest, AutowareObjectsBecomeARecording) {
  mapping_ = shipped("autoware");
  write("/localization/kinematic_state", ego_, "/perception/object_recognition/tracking/objects",
        std::vector<ForeignMessage>{trackedObjectsAt(1.0), trackedObjectsAt(1.1)});
  const NuScenesRecording recording = read();
  EXPECT_THAT(warnings_, IsEmpty());
  EXPECT_EQ(recording.ego_poses.size(), 3U);
  ASSERT_EQ(recording.frames.size(), 2U);
  ASSERT_EQ(recording.frames[1].annotations.size(), 2U);
  const NuScenesAnnotation& car = recording.frames[1].annotations[0];
  EXPECT_EQ(car.instance, "000102030405060708090a0b0c0d0e0f");
  EXPECT_EQ(car.category, "vehicle.car");
  EXPECT_EQ(car.translation, Eigen::Vector3d(10.0, 22.0, 1.0));
  EXPECT_EQ(car.size, Eigen::Vector3d(4.25, 1.5, 1.75));
  EXPECT_NEAR(yawOf(car.rotation), M_PI / 2.0, 1e-12);
  EXPECT_LT((car.velocity - Eigen::Vector3d(0.0, 5.0, 0.0)).norm(), 1e-9)
      << "in its own frame 5, 0";
  const NuScenesAnnotation& truck = recording.frames[1].annotations[1];
  EXPECT_EQ(truck.instance, "0102030405060708090a0b0c0d0e0f10");
  EXPECT_EQ(truck.category, "vehicle.truck") << "the likeliest";
}

geometry_msgs::TransformStamped transformAt(double time, const std::string& parent,
                                            const std::string& child, double x, double y) {
  geometry_msgs::TransformStamped transform;
  transform.header = headerAt(time, parent);
  transform.child_frame_id = child;
  transform.transform.translation.x = x;
  transform.transform.translation.y = y;
  transform.transform.rotation.w = 2.0;  // not a unit quaternion
  return transform;
}

class ForeignTransformsTest : public ForeignBagTest {
 protected:
  void SetUp() override {
    ForeignBagTest::SetUp();
    mapping_.ego.fields.topic = "/tf";
    mapping_.ego.fields.type = "tf2_msgs/TFMessage";
    mapping_.ego.in_transforms = true;
  }

  /// One message per transform; `fixed` on /tf_static, after everything else.
  void writeTransforms(const std::vector<geometry_msgs::TransformStamped>& moving,
                       const std::vector<geometry_msgs::TransformStamped>& fixed = {}) {
    NewBag bag(path_);
    tf2_msgs::TFMessage message;
    for (const auto& transform : moving) {
      message.transforms = {transform};
      bag.write("/tf", ros::Time(1.0), message);
    }
    for (const auto& objects : objects_) bag.write("/objects", ros::Time(1.1), objects);
    message.transforms = fixed;
    if (!fixed.empty()) bag.write("/tf_static", ros::Time(2.0), message);
    bag.commit();
  }
};

TEST_F(ForeignTransformsTest, ADirectTransformIsTheEgosPose) {
  mapping_.ego.child_frame_id = "car";
  writeTransforms(
      {transformAt(1.0, "odom", "car", 1.0, 0.0), transformAt(1.0, "map", "sign", 2.0, 0.0),
       transformAt(1.1, "map", "car", 6.0, 0.0), transformAt(1.2, "odom", "car", 3.0, 0.0)});
  const auto poses = read().ego_poses;
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_EQ(poses[0].timestamp_us, 1100000);
  EXPECT_EQ(poses[0].translation, Eigen::Vector3d(6.0, 0.0, 0.0));
  EXPECT_EQ(poses[0].rotation.w(), 1.0);
}

TEST_F(ForeignTransformsTest, AChainOfTransformsIsTheEgosPose) {
  writeTransforms({transformAt(1.0, "/map", "/odom", 100.0, 0.0),
                   transformAt(1.0, "/odom", "/base_footprint", 1.0, 0.0),
                   transformAt(1.1, "/odom", "/base_footprint", 2.0, 0.0),
                   transformAt(1.2, "/odom", "/base_footprint", 3.0, 0.0),
                   transformAt(1.2, "/map", "/odom", 120.0, 0.0),
                   transformAt(1.3, "/odom", "/base_footprint", 4.0, 0.0)},
                  {transformAt(0.0, "/base_footprint", "/base_link", 0.0, 0.5)});
  const auto poses = read().ego_poses;
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_EQ(poses[1].timestamp_us, 1100000);
  EXPECT_LT((poses[1].translation - Eigen::Vector3d(112.0, 0.5, 0.0)).norm(), 1e-9)
      << "map -> odom is interpolated";
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 ego poses without transforms from map to "
                                               "base_link at their stamp left out"),
                                     HasSubstr("map -> odom, odom -> base_footprint")));
}

TEST_F(ForeignTransformsTest, AMissingChainNamesTheTransformsThatThereAre) {
  writeTransforms({transformAt(1.0, "odom", "base_link", 1.0, 0.0)});
  EXPECT_THAT(complaint(),
              AllOf(HasSubstr("no pose of the ego on /tf; 1 ego poses without transforms from map "
                              "to base_link"),
                    HasSubstr("transforms of the bag: odom -> base_link")));
  mapping_.ego.child_frame_id = "lorry";
  EXPECT_THAT(complaint(), HasSubstr("no pose of the ego on /tf"));
}

TEST_F(ForeignTransformsTest, TwoPosesOfTheEgoAtOneTimeAreAnError) {
  writeTransforms({transformAt(1.0, "map", "base_link", 1.0, 0.0),
                   transformAt(1.0, "map", "base_link", 2.0, 0.0)});
  EXPECT_THAT(complaint(), HasSubstr("1.000000 m apart"));
}

TEST_F(ForeignBagTest, AgentsInTheEgosFrameAreTransformedAtTheirStamp) {
  mapping_.agents.fields.frame_id = "base_link";
  for (auto& objects : objects_) {
    objects.header.frame_id = "base_link";
    objects.header.stamp -= ros::Duration(0.05);
  }
  write();
  const auto frames = read().frames;
  ASSERT_EQ(frames.size(), 2U) << "the first is before every pose";
  EXPECT_EQ(frames[0].timestamp_us, 1050000);
  const NuScenesAnnotation& car = frames[0].annotations.at(0);
  EXPECT_LT((car.translation - Eigen::Vector3d(1.05 - 3.0 * 1.1, 27.0, 0.5)).norm(), 1e-9);
  EXPECT_NEAR(yawOf(car.rotation), M_PI / 2.0, 1e-12);
  EXPECT_LT((car.velocity - Eigen::Vector3d(-3.5, 0.0, 0.0)).norm(), 1e-9);
}

TEST_F(ForeignBagTest, AFrameThatNoTransformConnectsToTheMapIsAnError) {
  mapping_.agents.fields.frame_id.clear();
  for (auto& objects : objects_) objects.header.frame_id = "lidar";
  write();
  EXPECT_THAT(complaint(),
              AllOf(HasSubstr("3 frames of agents without transforms from map to lidar"),
                    HasSubstr("transforms of the bag: map -> base_link")));
}

TEST_F(ForeignBagTest, AgentsThatCannotBeUsedAreLeftOut) {
  auto& objects = objects_[0].objects;
  objects.assign(7, objectAt(1, 1.0));
  for (std::size_t i = 0; i < objects.size(); ++i) objects[i].id = static_cast<std::uint32_t>(i);
  objects[1].pose.position.x = std::nan("");
  objects[2].pose.orientation.w = 0.0;
  objects[3].size.y = 0.0;
  objects[5].id = 0;
  write();
  const auto agents = read().frames.at(0).annotations;
  ASSERT_EQ(agents.size(), 3U);
  EXPECT_EQ(agents[2].instance, "6");
  EXPECT_THAT(
      warnings_,
      ElementsAre("3 agents that are not finite or have no size left out",
                  "1 agents without an id, or with the id of another agent or the ego left out"));
}

TEST_F(ForeignBagTest, ANonFiniteVelocityKeepsTheAgent) {
  for (auto& frame : objects_) {
    for (auto& object : frame.objects) object.velocity.x = std::nan("");
  }
  write();
  const auto agents = read().frames.at(0).annotations;
  ASSERT_FALSE(agents.empty());
  EXPECT_EQ(agents[0].velocity, Eigen::Vector3d(0.0, 0.0, 0.0));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("velocities of agents that are not finite")));
}

TEST_F(ForeignBagTest, StampsThatGoBackOrAreNotSetAreLeftOut) {
  ego_.push_back(odometryAt(1.15));
  ego_.push_back(odometryAt(1.2));
  ego_.push_back(odometryAt(0.0));
  ego_.push_back(odometryAt(1.3));
  ego_.back().pose.pose.position.y = std::nan("");
  objects_.push_back(objectsAt(1.2));
  objects_.push_back(objectsAt(0.0));
  write();
  const NuScenesRecording recording = read();
  EXPECT_EQ(recording.ego_poses.size(), 3U);
  EXPECT_EQ(recording.frames.size(), 3U);
  EXPECT_THAT(
      warnings_,
      ElementsAre("1 ego poses that are not finite left out",
                  "1 ego poses whose stamp is earlier than the previous one left out",
                  "1 ego poses whose stamp is not set left out",
                  "1 frames of agents whose stamp is not later than the previous one left out",
                  "1 frames of agents whose stamp is not set left out"));
}

TEST_F(ForeignBagTest, BagsThatContradictTheMappingAreErrors) {
  objects_[2].header.frame_id = "base_link";
  write();
  EXPECT_THAT(complaint(),
              AllOf(HasSubstr("/objects"), HasSubstr("header.frame_id is 'base_link', not 'map'")));
  mapping_.agents.fields.frame_id.clear();
  EXPECT_EQ(complaint(), "") << "the poses of the ego give the transform";

  const TopicMapping right = mapping_;
  mapping_.agents.fields.topic = "/nobody";
  EXPECT_THAT(complaint(), AllOf(HasSubstr("/nobody"), HasSubstr("/chatter, /objects, /odom")));
  mapping_ = right;
  mapping_.agents.fields.type = "derived_object_msgs/Object";
  EXPECT_THAT(complaint(), HasSubstr("/objects: is of type derived_object_msgs/ObjectArray"));
  mapping_ = right;
  mapping_.agents.size[0] = "objects[].length";
  EXPECT_THAT(complaint(), AllOf(HasSubstr("/objects"), HasSubstr("no field 'length'")));
  mapping_ = right;
  mapping_.ego.fields.stamp = "header.seq";
  EXPECT_THAT(complaint(), AllOf(HasSubstr("/odom"), HasSubstr("not a time")));
}

TEST_F(ForeignBagTest, UnreadableAndEmptyBagsAreErrors) {
  EXPECT_THAT(complaint(), HasSubstr("there is no such file"));
  folder_.write("drive.bag", "#ROSBAG V2.0\nnothing");
  EXPECT_NE(complaint(), "");
  ego_ = {odometryAt(0.0)};
  write();
  EXPECT_THAT(complaint(), HasSubstr("no pose of the ego on /odom"));
}

}  // namespace
}  // namespace forge
