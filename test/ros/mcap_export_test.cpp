#include "collision_forge/ros/bags/mcap_export.h"

#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>
#include <collision_forge/LaneMap.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "base/scene/shipped_limits.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/markers/scene_update.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "ros/mcap_contents.h"
#include "ros/ros_decoder.h"

namespace forge {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using testing::UnorderedElementsAre;

constexpr double kEgoSpeed = 4.0;  // m/s along x, from x = 0 at 0 s
const EgoVehicle kEgo{{4.0, 2.0}, 1.5};

DataOptions optionsOfTest() {
  DataOptions options;
  options.ego_vehicle = kEgo;
  options.input_limits = shippedLimits();
  return options;
}

tf2_msgs::TFMessage transformAt(double time) {
  tf2_msgs::TFMessage message;
  message.transforms.emplace_back();
  auto& transform = message.transforms.back();
  transform.header.stamp = ros::Time(time);
  transform.header.frame_id = names::kMapFrame;
  transform.child_frame_id = names::kBaseFrame;
  transform.transform.translation.x = kEgoSpeed * time;
  transform.transform.rotation.w = 1.0;
  return message;
}

collision_forge::AgentArray frameAt(double time) {
  collision_forge::AgentArray message;
  message.header.stamp = ros::Time(time);
  message.header.frame_id = names::kMapFrame;
  message.agents.emplace_back();
  collision_forge::Agent& agent = message.agents.back();
  agent.id = "attacker";
  agent.size.x = 4.6;
  agent.size.y = 1.9;
  agent.pose.position.y = 30.0;
  agent.pose.orientation.w = 1.0;
  agent.velocity.x = 3.0;
  agent.velocity.y = 4.0;
  return message;
}

collision_forge::Attack attackAt(double now) {
  collision_forge::Attack attack;
  attack.header.stamp = ros::Time(now);
  attack.trajectory.attacker_id = "attacker";
  attack.trajectory.size.x = 4.6;
  attack.trajectory.size.y = 1.9;
  attack.trajectory.points.resize(2);
  attack.trajectory.points[0].stamp = ros::Time(now);
  attack.trajectory.points[1].stamp = ros::Time(now + 1.0);
  return attack;
}

class ExportToMcapTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Frames every half second, transforms 0.2 s apart that are never at the same times.
  void writeRecording(const char* agents = names::kAgents, double attack_at = 2.0) {
    NewBag bag(in_);
    bag.writeLatched(bagTopic(names::kLaneMap), ros::Time(0.95), collision_forge::LaneMap());
    for (double time = 0.95; time < 3.2; time += 0.2) {
      bag.write(names::kTf, ros::Time(time), transformAt(time));
    }
    for (double time = 1.0; time < 3.2; time += 0.5) {
      bag.write(bagTopic(agents), ros::Time(time), frameAt(time));
    }
    const ros::Time now(attack_at);
    bag.writeLatched(bagTopic(names::kAttack), now, attackAt(attack_at));
    bag.commit();
  }

  McapContents exported(McapProfile profile = McapProfile::kRos1) const {
    exportToMcap(in_, out_, optionsOfTest(), profile);
    return McapContents(bytesOf(out_));
  }

  std::string complaint() const {
    try {
      exportToMcap(in_, out_, optionsOfTest());
    } catch (const BagError& error) {
      return error.what();
    }
    return "";
  }

  static std::string bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  static void writeBytes(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("collision_forge_mcap_" + std::to_string(getpid()));
  const std::string in_ = folder_ / "in.bag";
  const std::string out_ = folder_ / "out.mcap";
};

TEST_F(ExportToMcapTest, EveryMessageKeepsItsBytesTopicAndTime) {
  writeRecording();
  const McapContents contents = exported();
  std::multimap<std::pair<std::string, std::uint64_t>, std::string> left;
  for (const McapMessage& message : contents.messages()) {
    EXPECT_EQ(message.encoding, "ros1");
    EXPECT_EQ(message.schema_encoding, "ros1msg");
    EXPECT_EQ(message.publish_time, message.log_time);
    left.emplace(std::pair(message.topic, message.log_time), message.bytes);
  }
  const rosbag::Bag bag(in_);
  for (const rosbag::MessageInstance& instance : rosbag::View(bag)) {
    std::string bytes(instance.size(), '\0');
    ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                       instance.size());
    instance.write(stream);
    const auto found = left.find({instance.getTopic(), instance.getTime().toNSec()});
    ASSERT_NE(found, left.end()) << instance.getTopic();
    EXPECT_EQ(found->second, bytes);
    left.erase(found);
  }
  for (const auto& [key, _] : left) EXPECT_THAT(key.first, StartsWith("/collision_forge/"));
}

TEST_F(ExportToMcapTest, ChannelsHaveTheHeadersOfTheirConnections) {
  {
    NewBag bag(in_);
    auto header = boost::make_shared<ros::M_string>();
    *header = {{"type", "std_msgs/String"},
               {"md5sum", "992ce8a1687cec8c8bd883ec73ca41d1"},
               {"message_definition", "string data\n"},
               {"callerid", "/talker"},
               {"latching", "1"}};
    bag.write("/words", ros::Time(1.0), std_msgs::String(), header);
    bag.commit();
  }
  const McapContents contents = exported();
  ASSERT_EQ(contents.messages().size(), 1U);
  const McapMessage& message = contents.messages()[0];
  EXPECT_EQ(message.topic, "/words");
  EXPECT_EQ(message.schema, "std_msgs/String");
  EXPECT_EQ(message.definition, "string data\n");
  EXPECT_EQ(message.metadata,
            (std::map<std::string, std::string>{{"callerid", "/talker"},
                                                {"latching", "1"},
                                                {"md5sum", "992ce8a1687cec8c8bd883ec73ca41d1"}}));
}

TEST_F(ExportToMcapTest, FramesInterpolateTheEgoBetweenItsTransforms) {
  writeRecording();
  const std::vector<McapMessage> frames = exported().of("/collision_forge/scene");
  ASSERT_EQ(frames.size(), 5U);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double time = 1.0 + 0.5 * static_cast<double>(i);
    EXPECT_EQ(frames[i].schema, kSceneUpdateType);
    EXPECT_EQ(frames[i].log_time, ros::Time(time).toNSec());
    const RosDecoder decoded(frames[i].definition, frames[i].bytes);
    EXPECT_EQ(decoded.text("entities[0].id"), "ego");
    EXPECT_NEAR(decoded.number("entities[0].cubes[0].pose.position.x"),
                kEgoSpeed * time + kEgo.center_offset, 1e-6);
    EXPECT_EQ(decoded.text("entities[1].texts[0].text"), time < 2.0 ? "car attacker" : "attacker");
  }
}

TEST_F(ExportToMcapTest, SpeedsOfEgoAndAttackerAreWritten) {
  writeRecording();
  const McapContents contents = exported();
  const auto speed = [](const McapMessage& message) {
    return RosDecoder(message.definition, message.bytes).number("data");
  };
  EXPECT_EQ(contents.of("/collision_forge/ego_speed").size(), 11U);
  for (const auto& message : contents.of("/collision_forge/ego_speed")) {
    EXPECT_NEAR(speed(message), kEgoSpeed, 1e-6);
  }
  EXPECT_EQ(contents.of("/collision_forge/attacker_speed").size(), 3U) << "from now on";
  for (const auto& message : contents.of("/collision_forge/attacker_speed")) {
    EXPECT_EQ(speed(message), 5.0);
  }
}

TEST_F(ExportToMcapTest, InProfileRos2EveryMessageIsConverted) {
  writeRecording();
  const std::size_t count = exported().messages().size();
  const McapContents contents = exported(McapProfile::kRos2);
  EXPECT_EQ(contents.messages().size(), count);
  for (const McapMessage& message : contents.messages()) {
    EXPECT_EQ(message.encoding, "cdr");
    EXPECT_EQ(message.schema_encoding, "ros2msg");
    EXPECT_THAT(message.bytes, StartsWith(std::string("\0\1\0\0", 4)));
    const bool is_latched = message.topic == "/lane_map" || message.topic == "/attack" ||
                            message.topic == "/collision_forge/map";
    EXPECT_THAT(message.metadata.at("offered_qos_profiles"),
                HasSubstr(is_latched ? "durability: 1" : "durability: 2"))
        << message.topic;
  }
  EXPECT_EQ(contents.of("/agents").front().schema, "collision_forge_msgs/msg/AgentArray");
  EXPECT_EQ(contents.of("/tf").front().schema, "tf2_msgs/msg/TFMessage");
}

TEST_F(ExportToMcapTest, InProfileRos2TopicsThatCannotBeConvertedAreLeftOut) {
  {
    NewBag bag(in_);
    const auto write = [&](const char* topic, const char* definition) {
      const auto header = boost::make_shared<ros::M_string>();
      *header = {{"type", "std_msgs/Float64"},
                 {"md5sum", "fdb28210bfa9d7c91146260178d9a584"},
                 {"message_definition", definition}};
      bag.write(topic, ros::Time(1.0), std_msgs::Float64(), header);
    };
    write("/unknown", "Unknown data\n");
    write("/short", "float64[2] data\n");
    bag.write("/number", ros::Time(1.0), std_msgs::Float64());
    bag.commit();
  }
  const McapExport made = exportToMcap(in_, out_, optionsOfTest(), McapProfile::kRos2);
  EXPECT_THAT(made.warnings,
              UnorderedElementsAre(
                  "1 messages of /unknown left out: std_msgs/Float64: type Unknown of its field "
                  "data is not defined",
                  "1 messages of /short left out: a message is shorter than its type"));
  const McapContents contents(bytesOf(out_));
  ASSERT_EQ(contents.messages().size(), 1U);
  EXPECT_EQ(contents.messages()[0].topic, "/number");
}

TEST_F(ExportToMcapTest, BagsWithoutASceneAreCopied) {
  {
    NewBag bag(in_);
    bag.write("/number", ros::Time(1.0), std_msgs::Float64());
    bag.commit();
  }
  EXPECT_EQ(exported().messages().size(), 1U);
}

TEST_F(ExportToMcapTest, MessagesBeyondTheLimitsAreCopiedButNotShownWithAWarning) {
  constexpr double kFar = 1e6;  // m
  collision_forge::AgentArray frame = frameAt(1.0);
  frame.agents.resize(4, frame.agents.front());
  frame.agents[1].pose.position.x = kFar;
  frame.agents[2].size.x = std::numeric_limits<double>::quiet_NaN();
  frame.agents[3].velocity.y = kFar;
  tf2_msgs::TFMessage far_ego = transformAt(1.5);
  far_ego.transforms.front().transform.translation.x = kFar;
  collision_forge::Attack far_attack = attackAt(1.0);
  far_attack.trajectory.points.back().pose.position.x = kFar;
  collision_forge::LaneMap map;
  map.lanes.resize(1);
  map.lanes.front().centerline.resize(2);
  map.lanes.front().centerline.back().x = kFar;
  {
    NewBag bag(in_);
    bag.writeLatched(bagTopic(names::kLaneMap), ros::Time(0.5), map);
    bag.write(names::kTf, ros::Time(1.0), transformAt(1.0));
    bag.write(bagTopic(names::kAgents), ros::Time(1.0), frame);
    bag.writeLatched(bagTopic(names::kAttack), ros::Time(1.0), far_attack);
    bag.write(names::kTf, ros::Time(1.5), far_ego);
    bag.write(bagTopic(names::kAgents), ros::Time(1.5), frameAt(1.5));
    bag.commit();
  }
  const std::string entries = " beyond the input limits are not shown";
  EXPECT_THAT(
      exportToMcap(in_, out_, optionsOfTest()).warnings,
      UnorderedElementsAre("3 entries of /agents" + entries, "1 entries of /lane_map" + entries,
                           "1 entries of /attack" + entries, "1 entries of /tf" + entries));
  const McapContents contents(bytesOf(out_));
  EXPECT_EQ(contents.of("/agents").size(), 2U);
  EXPECT_EQ(contents.of("/collision_forge/map").size(), 0U);
  EXPECT_EQ(contents.of("/collision_forge/ego_speed").size(), 0U);
  EXPECT_EQ(contents.of("/collision_forge/attacker_speed").size(), 0U);
  EXPECT_EQ(contents.of("/collision_forge/scene").size(), 1U);
}

TEST_F(ExportToMcapTest, AMessageAtTimeZeroIsRejected) {
  const ros::Time marked(0x12345678U, 0x2345678U);
  {
    rosbag::Bag bag(in_, rosbag::bagmode::Write);
    bag.write("/number", marked, std_msgs::Float64());
    bag.write("/number", ros::Time(0x12345679U, 0), std_msgs::Float64());
  }
  std::string bytes = bytesOf(in_);
  std::string time(8, '\0');
  std::memcpy(time.data(), &marked.sec, 4);
  std::memcpy(time.data() + 4, &marked.nsec, 4);
  for (std::size_t at = bytes.find(time); at != std::string::npos; at = bytes.find(time)) {
    bytes.replace(at, time.size(), std::string(time.size(), '\0'));
  }
  writeBytes(in_, bytes);
  EXPECT_THAT(complaint(), StartsWith(in_ + ": has messages at time 0"));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(ExportToMcapTest, IncompleteBagsAreRejected) {
  writeRecording();
  const std::string bytes = bytesOf(in_);
  for (const std::size_t size : {bytes.size() - 1, bytes.size() / 2, std::size_t{5000}}) {
    writeBytes(in_, bytes.substr(0, size));
    EXPECT_THAT(complaint(), StartsWith(in_ + ": truncated or damaged: ")) << size;
  }
  writeBytes(in_, "no bag");
  EXPECT_THAT(complaint(), StartsWith(in_ + ": "));
  std::filesystem::remove(in_);
  EXPECT_THAT(complaint(), StartsWith(in_ + ": cannot be read"));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

}  // namespace
}  // namespace forge
