#include "collision_forge/ros/bags/bag_reader.h"

#include <collision_forge/AgentArray.h>
#include <collision_forge/LaneMap.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>

#include <string>
#include <vector>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/bag_writer.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

constexpr double kSpeed = 8.0;  // m/s of the ego along x, from x = 0 at 100 s

/// The ego's pose, `aside` metres from its way.
tf2_msgs::TFMessage poseAt(const ros::Time& stamp, double aside = 0.0) {
  tf2_msgs::TFMessage message;
  message.transforms.emplace_back();
  auto& transform = message.transforms.back();
  transform.header.stamp = stamp;
  transform.header.frame_id = names::kMapFrame;
  transform.child_frame_id = names::kBaseFrame;
  transform.transform.translation.x = kSpeed * (stamp.toSec() - 100.0);
  transform.transform.translation.y = aside;
  transform.transform.rotation.w = 1.0;
  return message;
}

class BagReaderTest : public testing::Test {
 protected:
  /// A pose of the ego every 0.1 s, frames of agents every 0.5 s; `more`: poses and frames too.
  void write(const std::vector<tf2_msgs::TFMessage>& more, const ros::Time& more_agents) {
    NewBag bag(path_);
    bag.write(bagTopic(names::kLaneMap), ros::Time(100), collision_forge::LaneMap());
    for (unsigned i = 0; i <= 20; ++i) {
      const ros::Time time(100 + i / 10, i % 10 * 100000000);
      bag.write(names::kTf, time, poseAt(time));
      if (i % 5 == 0) writeAgents(bag, time);
      for (const auto& message : more) {
        const ros::Time& extra = message.transforms.front().header.stamp;
        if (i == 10) bag.write(names::kTf, extra, message);
      }
    }
    if (!more_agents.isZero()) writeAgents(bag, more_agents);
    bag.commit();
  }

  static void writeAgents(NewBag& bag, const ros::Time& time) {
    collision_forge::AgentArray agents;
    agents.header.stamp = time;
    bag.write(bagTopic(names::kAgents), time, agents);
  }

  /// One frame without agents, and three poses of the ego.
  static NuScenesRecording shortDrive() {
    NuScenesRecording recording;
    recording.name = "drive";
    recording.frames.push_back({"", 1000000, {}});
    for (std::int64_t i = 0; i < 3; ++i) {
      recording.ego_poses.push_back({1000000 + i * 100000,
                                     {static_cast<double>(i), 0.0, 0.0},
                                     Eigen::Quaterniond::Identity()});
    }
    return recording;
  }

  const Config config_ = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  const TemporaryFolder folder_;
  const std::string path_ = folder_.path() + "/drive.bag";
};

TEST_F(BagReaderTest, KeepsTheFirstOfPosesAndFramesAtOneTime) {
  // Half a metre in a microsecond would be more than any vehicle drives.
  const ros::Time twin(101, 400);
  write({poseAt(twin, 0.4), poseAt(ros::Time(101, 1000), 0.4)}, twin);
  for (const auto& read : {readBag, readBagAsWritten}) {
    const Scene scene = read(path_, config_, nullptr);
    EXPECT_EQ(scene.ego.states.size(), 21u);
    EXPECT_EQ(scene.frame_times.size(), 5u);
    for (const AgentState& state : scene.ego.states) EXPECT_EQ(state.pose.y, 0.0);
  }
}

TEST_F(BagReaderTest, TheBoxOfTheRecordedEgoIsTheEgosBox) {
  NuScenesRecording recording = shortDrive();
  writeBag(path_, recording, LaneMap());
  EXPECT_EQ(readBag(path_, config_).ego.size.length, config_.ego_vehicle.size.length);
  recording.ego_size = BoxSize{5.286, 2.332};
  writeBag(path_, recording, LaneMap());
  for (const auto& read : {readBag, readBagAsWritten}) {
    EXPECT_EQ(read(path_, config_, nullptr).ego.size.length, 5.286);
    EXPECT_EQ(read(path_, config_, nullptr).ego.size.width, 2.332);
  }
}

TEST_F(BagReaderTest, AMapOfAnotherVersionOfTheMessageIsRead) {
  collision_forge::LaneMap map;
  map.location = "town";
  map.driving_side = collision_forge::LaneMap::DRIVE_LEFT;
  map.lanes.emplace_back();
  map.lanes[0].id = "a";
  map.lanes[0].outgoing = {"b"};
  map.lanes[0].speed_limit = 10.0;
  std::string definition = ros::message_traits::definition<collision_forge::LaneMap>();
  const auto rename = [&](const std::string& from, const std::string& to) {
    const std::size_t place = definition.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    definition.replace(place, from.size(), to);
  };
  rename("uint8 driving_side", "uint8 side");
  rename("float64 speed_limit", "float64 most");
  const auto header = boost::make_shared<ros::M_string>();
  (*header)["type"] = "collision_forge/LaneMap";
  (*header)["md5sum"] = std::string(32, '0');
  (*header)["message_definition"] = definition;
  NewBag bag(path_);
  bag.write(bagTopic(names::kLaneMap), ros::Time(100), map, header);
  bag.commit();
  const auto read = readLaneMap(path_, config_.input_limits);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->location, "town");
  EXPECT_EQ(read->driving_side, DrivingSide::kRight) << "has no field of this name";
  ASSERT_EQ(read->lanes.size(), 1U);
  EXPECT_EQ(read->lanes[0].outgoing, std::vector<std::string>{"b"});
  EXPECT_FALSE(read->lanes[0].speed_limit);
}

TEST_F(BagReaderTest, TrafficLightsAreReadBack) {
  NuScenesRecording recording = shortDrive();
  recording.lights = {{"7", {3.0, 4.0}, {{1.0, LightColor::kRed}, {1.25, LightColor::kGreen}}},
                      {"8", {5.0, 6.0}, {{1.0, LightColor::kYellow}}}};
  writeBag(path_, recording, LaneMap());
  const Scene scene = readBag(path_, config_);
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].lane, "7");
  EXPECT_EQ(scene.lights[0].stop_point, Vector2(3.0, 4.0));
  ASSERT_EQ(scene.lights[0].states.size(), 2U);
  EXPECT_NEAR(scene.lights[0].states[1].time, 1.25, 1e-9);
  EXPECT_EQ(scene.lights[0].states[1].color, LightColor::kGreen);
  EXPECT_EQ(scene.lights[1].states.size(), 1U);
}

TEST_F(BagReaderTest, PosesOfOneInstantThatContradictEachOtherNameTopicAndTime) {
  write({poseAt(ros::Time(101, 400), 3.0)}, {});
  EXPECT_THAT(errorOf<BagError>([&] { readBag(path_, config_); }),
              testing::HasSubstr("drive.bag: /tf: two poses of the ego at 101.000000 s are"));
}

}  // namespace
}  // namespace forge
