#include "collision_forge/ros/injection/injection.h"

#include <collision_forge/AgentArray.h>
#include <collision_forge/LaneMap.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>
#include <visualization_msgs/ImageMarker.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/bag_reader.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/object_array.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr double kEgoSpeed = 4.0;  // m/s along x from x = -40 at 0 s, as is everybody else
constexpr double kNow = 10.0;      // s
constexpr double kContact = 10.77;

double egoAt(double time) { return -40.0 + kEgoSpeed * time; }

collision_forge::AgentArray frame(double time) {
  collision_forge::AgentArray message;
  message.header.stamp = ros::Time(time);
  message.agents.emplace_back();
  collision_forge::Agent& agent = message.agents.back();
  agent.id = "other";
  agent.size.x = 5.0;
  agent.size.y = 2.0;
  agent.pose.position.x = egoAt(time);
  agent.pose.position.y = 30.0;
  agent.pose.orientation.w = 1.0;
  return message;
}

tf2_msgs::TFMessage transformAt(double time) {
  tf2_msgs::TFMessage message;
  message.transforms.emplace_back();
  auto& transform = message.transforms.back();
  transform.header.stamp = ros::Time(time);
  transform.header.frame_id = names::kMapFrame;
  transform.child_frame_id = names::kBaseFrame;
  transform.transform.translation.x = egoAt(time);
  transform.transform.translation.z = 0.1 * time;  // uphill
  transform.transform.rotation.w = 1.0;
  return message;
}

nav_msgs::Odometry odometryAt(double time) {
  nav_msgs::Odometry message;
  message.header.stamp = ros::Time(time);
  message.pose.pose.position.x = egoAt(time);
  message.pose.pose.orientation.w = 1.0;
  message.twist.twist.linear.x = kEgoSpeed;
  message.twist.twist.angular.z = 0.25;
  return message;
}

/// A camera that looks along y, to the left of the ego.
sensor_msgs::CameraInfo cameraAt(double time) {
  sensor_msgs::CameraInfo info;
  info.header.stamp = ros::Time(time);
  info.header.frame_id = "cam_left";
  info.width = 1600;
  info.height = 900;
  info.K = {800.0, 0.0, 800.0, 0.0, 800.0, 450.0, 0.0, 0.0, 1.0};
  return info;
}

tf2_msgs::TFMessage cameraMounting() {
  tf2_msgs::TFMessage message;
  auto& transform = message.transforms.emplace_back();
  transform.header.frame_id = names::kBaseFrame;
  transform.child_frame_id = "cam_left";
  transform.transform.rotation.x = -std::sqrt(0.5);
  transform.transform.rotation.w = std::sqrt(0.5);
  return message;
}

/// A car that comes down from y = 8, straight at the ego, as long as `end`.
collision_forge::AttackerTrajectory trajectoryUntil(double end, bool added) {
  collision_forge::AttackerTrajectory message;
  message.header.stamp = ros::Time(kNow);
  message.attacker_id = "attacker";
  message.size.x = 4.6;
  message.size.y = 1.9;
  message.added = added;
  for (double time = kNow; time <= end + 1e-6; time += 0.1) {
    message.points.emplace_back();
    auto& point = message.points.back();
    point.stamp = ros::Time(time);
    point.pose.position.x = 3.0;
    point.pose.position.y = 8.0 - 8.0 * (time - kNow);
    point.pose.orientation.z = -std::sqrt(0.5);
    point.pose.orientation.w = std::sqrt(0.5);
    point.speed = 8.0;
  }
  for (const double time : {9.0, 9.5, 10.0}) {
    if (!added) break;
    message.past.emplace_back();
    message.past.back().stamp = ros::Time(time);
    message.past.back().pose.x = 3.0;
    message.past.back().pose.y = 8.0 + 8.0 * (kNow - time);
  }
  return message;
}

class InjectIntoBagTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("collision_forge_injection_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    in_ = folder_ / "in.bag";
    out_ = folder_ / "out.bag";
    ego_ = {kEgoId, AgentClass::kCar, config_.ego_vehicle.size, {}};
    writeRecording({8.5, 9.0, 9.5, 10.0, 10.5, 11.0, 11.5, 12.0, 14.0});
    attack_.attack.trajectory = trajectoryUntil(12.0, false);
    attack_.attack.header = attack_.attack.trajectory.header;
    attack_.tested_report.contact = true;
    attack_.tested_report.contact_time = ros::Time(kContact);
    attack_.tested_report.ego_at_contact.x = egoAt(kContact);
    seconds_after_stand_ = 60.0;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// When a message with that header stamp is recorded.
  ros::Time recordedAt(double stamp) const {
    return ros::Time(record_rate_ * stamp) + ros::Duration(record_offset_);
  }

  void writeRecording(const std::vector<double>& times) {
    NewBag bag(in_);
    collision_forge::LaneMap map;
    map.header.frame_id = names::kMapFrame;
    bag.writeLatched(bagTopic(names::kLaneMap), recordedAt(times.front()), map);
    if (has_camera_)
      bag.writeLatched(names::kStaticTf, recordedAt(times.front()), cameraMounting());
    ego_.states.clear();
    for (const double time : times) {
      const ros::Time recorded = recordedAt(time);
      if (has_camera_) bag.write("/cam_left/camera_info", recorded, cameraAt(time));
      bag.write(bagTopic(names::kAgents), recorded, frame(time));
      bag.write(bagTopic(names::kAnnotationMarkers), recorded, visualization_msgs::MarkerArray());
      bag.write(names::kTf, recorded, transformAt(time));
      bag.write(bagTopic(names::kOdometry), recorded, odometryAt(time));
      ego_.states.push_back({time, {egoAt(time), 0.0, 0.0}, {kEgoSpeed, 0.0}});
    }
    bag.commit();
  }

  /// The base is the middle of the ego's box here.
  void inject() {
    AttackedBagOptions options = config_.attacked_bag;
    options.seconds_after_stand = seconds_after_stand_;
    injectIntoBag(in_, out_, attack_, {ego_, 0.0, config_.attack.verification, options});
  }

  template <typename Message>
  std::vector<Message> read(const std::string& topic) const {
    const rosbag::Bag bag(out_, rosbag::bagmode::Read);
    std::vector<Message> messages;
    for (const rosbag::MessageInstance& instance : rosbag::View(bag, rosbag::TopicQuery(topic))) {
      messages.push_back(*instance.instantiate<Message>());
    }
    return messages;
  }

  /// When the messages of a topic of topic_names.h are in the bag, s.
  std::vector<double> timesOf(const char* topic) const {
    const rosbag::Bag bag(out_, rosbag::bagmode::Read);
    std::vector<double> times;
    for (const auto& instance : rosbag::View(bag, rosbag::TopicQuery(bagTopic(topic)))) {
      times.push_back(instance.getTime().toSec());
    }
    return times;
  }

  /// One message of the new bag, without its record time.
  struct Written {
    std::string topic;
    std::string type;
    std::string bytes;
    bool operator==(const Written& other) const {
      return std::tie(topic, type, bytes) == std::tie(other.topic, other.type, other.bytes);
    }
  };

  /// All messages of the new bag, by record time in s.
  std::multimap<double, Written> written() const {
    const rosbag::Bag bag(out_, rosbag::bagmode::Read);
    std::multimap<double, Written> messages;
    for (const rosbag::MessageInstance& instance : rosbag::View(bag)) {
      std::string bytes(instance.size(), '\0');
      ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                         static_cast<std::uint32_t>(bytes.size()));
      instance.write(stream);
      messages.emplace(instance.getTime().toSec(),
                       Written{instance.getTopic(), instance.getDataType(), bytes});
    }
    return messages;
  }

  std::vector<collision_forge::AgentArray> frames() const {
    return read<collision_forge::AgentArray>(bagTopic(names::kAgents));
  }

  const Config config_ = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  std::filesystem::path folder_;
  std::string in_;
  std::string out_;
  Track ego_;
  BagAttack attack_;
  double seconds_after_stand_;  ///< longer than the recording, if no test sets it
  bool has_camera_ = false;
  double record_rate_ = 1.0;    ///< seconds of the record clock in a second of header stamps
  double record_offset_ = 0.0;  ///< s
};

const collision_forge::Agent& attackerIn(const collision_forge::AgentArray& frame) {
  return frame.agents.back();
}

TEST_F(InjectIntoBagTest, FramesAreWrittenAtTenHertzFromT0OnAndAtTheContact) {
  inject();
  std::vector<double> expected = {8.5, 9.0, 9.5, 10.0};
  for (int i = 1; i <= 20; ++i) expected.push_back(kNow + 0.1 * i);
  expected.push_back(kContact);
  expected.push_back(14.0);  // nobody knows what was in a gap that long
  std::sort(expected.begin(), expected.end());
  std::vector<double> times;
  for (const auto& frame : frames()) times.push_back(frame.header.stamp.toSec());
  ASSERT_EQ(times.size(), expected.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], expected[i], 1e-6);
}

TEST_F(InjectIntoBagTest, AgentsMoveLinearlyAndTheAttackerAlongItsTrajectory) {
  attack_.after_contact = AfterContact::kDriveOn;
  inject();
  for (const auto& frame : frames()) {
    const double time = frame.header.stamp.toSec();
    EXPECT_NEAR(frame.agents.front().pose.position.x, egoAt(time), 1e-6);
    if (time <= kNow || time > 12.0) continue;
    EXPECT_NEAR(attackerIn(frame).pose.position.y, 8.0 - 8.0 * (time - kNow), 1e-5) << time;
  }
}

TEST_F(InjectIntoBagTest, SupportsAreAgentsFromTheirFirstFrameToTheEndOfTheBag) {
  attack_.attack.supports.emplace_back();
  attack_.attack.supports.back().role = "parked_vehicle";
  auto& parked = attack_.attack.supports.back().motion;
  parked = trajectoryUntil(12.0, true);
  parked.attacker_id = "parked-1";
  for (auto& point : parked.points) {
    point.pose.position.y = -6.0;
    point.speed = 0.0;
  }
  for (auto& state : parked.past) state.pose.y = -6.0;
  inject();
  for (const auto& frame : frames()) {
    const auto found = std::find_if(frame.agents.begin(), frame.agents.end(),
                                    [](const auto& agent) { return agent.id == "parked-1"; });
    const bool is_there = frame.header.stamp >= parked.past.front().stamp;
    ASSERT_EQ(found != frame.agents.end(), is_there) << frame.header.stamp;
    if (is_there) {
      EXPECT_NEAR(found->pose.position.y, -6.0, 1e-9);
    }
  }
}

TEST_F(InjectIntoBagTest, CamerasShowTheBoxOfTheAttackerUntilTheContact) {
  has_camera_ = true;
  record_offset_ = 100.0;
  writeRecording({9.0, 10.0, 10.5, 10.6, 11.0, 11.5, 12.0});
  inject();
  std::map<double, int> actions;
  for (const auto& marker : read<visualization_msgs::ImageMarker>("/cam_left/attack_box")) {
    actions[marker.header.stamp.toSec()] = marker.action;
  }
  constexpr int kAdd = visualization_msgs::ImageMarker::ADD;
  EXPECT_EQ(actions.count(9.0), 0u);
  EXPECT_EQ(actions.at(10.5), kAdd);
  EXPECT_EQ(actions.at(10.6), kAdd);
  EXPECT_EQ(actions.rbegin()->first, 11.0) << "the first picture after the contact";
  EXPECT_EQ(actions.rbegin()->second, visualization_msgs::ImageMarker::REMOVE);
  EXPECT_EQ(read<sensor_msgs::CameraInfo>("/cam_left/camera_info").front(), cameraAt(9.0));
}

TEST_F(InjectIntoBagTest, EgoAndAttackerMoveByTheImpactAfterTheContact) {
  inject();
  const auto crash = motionAfterContact(kContact, fromMessage(attack_.attack.trajectory), ego_,
                                        config_.attack.verification.severity);
  const auto last = attackerIn(frames().back());
  const auto transform = read<tf2_msgs::TFMessage>(names::kTf).back().transforms.front().transform;
  const auto odometry = read<nav_msgs::Odometry>(bagTopic(names::kOdometry)).back();
  const Pose2 ego = crash->egoAt(100.0).pose;
  const Pose2 attacker = crash->attackerAt(100.0).pose;
  EXPECT_NEAR(last.pose.position.x, attacker.x, 1e-4);
  EXPECT_NEAR(last.pose.position.y, attacker.y, 1e-4);
  EXPECT_NEAR(transform.translation.x, ego.x, 1e-4);
  EXPECT_NEAR(transform.translation.y, ego.y, 1e-4);
  EXPECT_LT(transform.translation.y, -0.1);
  EXPECT_LT(transform.translation.x, egoAt(14.0) - 5.0);
  EXPECT_NEAR(last.velocity.y, 0.0, 1e-9);
  EXPECT_NEAR(transform.translation.z, 1.05, 1e-9) << "that of the last one before the contact";
  EXPECT_NEAR(odometry.pose.pose.position.x, transform.translation.x, 1e-9);
  EXPECT_EQ(odometry.twist.twist, geometry_msgs::Twist());
}

TEST_F(InjectIntoBagTest, TheEgoIsAsRecordedUpToTheContact) {
  inject();
  for (const auto& message : read<tf2_msgs::TFMessage>(names::kTf)) {
    const double time = message.transforms.front().header.stamp.toSec();
    // At the contact the height is that of the message before.
    EXPECT_EQ(message == transformAt(time), time < kContact - 1e-6) << time;
  }
  for (const auto& message : read<nav_msgs::Odometry>(bagTopic(names::kOdometry))) {
    const double time = message.header.stamp.toSec();
    EXPECT_EQ(message == odometryAt(time), time < kContact + 1e-6) << time;
  }
}

TEST_F(InjectIntoBagTest, TheEgoHasAPoseAtTheContact) {
  inject();
  const rosbag::Bag bag(out_, rosbag::bagmode::Read);
  for (const std::string& topic : {std::string(names::kTf), bagTopic(names::kOdometry)}) {
    std::vector<double> times;
    for (const auto& instance : rosbag::View(bag, rosbag::TopicQuery(topic))) {
      times.push_back(instance.getTime().toSec());
    }
    ASSERT_EQ(times.size(), 10u) << topic;
    EXPECT_NEAR(times[5], kContact, 1e-6) << topic;
  }
  const auto transform = read<tf2_msgs::TFMessage>(names::kTf)[5].transforms.front();
  EXPECT_NEAR(transform.header.stamp.toSec(), kContact, 1e-6);
  EXPECT_NEAR(transform.transform.translation.x, egoAt(kContact), 1e-6);
  const auto odometry = read<nav_msgs::Odometry>(bagTopic(names::kOdometry))[5];
  EXPECT_NEAR(odometry.pose.pose.position.x, egoAt(kContact), 1e-6);
  EXPECT_NEAR(odometry.twist.twist.linear.x, kEgoSpeed, 1e-9);
}

TEST_F(InjectIntoBagTest, TheBagEndsSomeSecondsAfterBothStand) {
  writeRecording({8.5, 9.0, 9.5, 10.0, 10.5, 11.0, 11.5, 12.0, 12.5, 13.0, 13.5, 14.0, 14.5, 15.0});
  const double stand = motionAfterContact(kContact, fromMessage(attack_.attack.trajectory), ego_,
                                          config_.attack.verification.severity)
                           ->standTime();
  for (const double seconds : {0.0, 1.0}) {
    seconds_after_stand_ = seconds;
    inject();
    for (const double last :
         {frames().back().header.stamp.toSec(),
          read<tf2_msgs::TFMessage>(names::kTf).back().transforms.front().header.stamp.toSec()}) {
      EXPECT_LE(last, stand + seconds);
      EXPECT_GT(last, stand + seconds - 0.5) << "tf comes twice a second here";
      EXPECT_LT(last, 15.0 - 0.5);
    }
  }
}

TEST_F(InjectIntoBagTest, TheBagMayEndShortlyAfterTheContact) {
  attack_.after_contact = AfterContact::kEnd;
  inject();
  const double end = kContact + config_.attacked_bag.end_time;
  const double last = frames().back().header.stamp.toSec();
  EXPECT_LE(last, end);
  EXPECT_GT(last, end - 0.1 - 1e-6);
  for (const auto& message : read<tf2_msgs::TFMessage>(names::kTf)) {
    const double time = message.transforms.front().header.stamp.toSec();
    EXPECT_LE(time, end);
    EXPECT_EQ(message, transformAt(time));
  }
}

TEST_F(InjectIntoBagTest, AnAttackerThatDrivesOnStaysAfterTheEndOfItsTrajectory) {
  attack_.after_contact = AfterContact::kDriveOn;
  attack_.attack.trajectory = trajectoryUntil(11.0, false);
  inject();
  const auto last = frames().back();
  ASSERT_EQ(last.agents.size(), 2u);
  EXPECT_LT(attackerIn(last).pose.position.y, -1.0);
  EXPECT_NEAR(attackerIn(last).velocity.y, 0.0, 1e-9);
  for (const auto& message : read<tf2_msgs::TFMessage>(names::kTf)) {
    EXPECT_EQ(message, transformAt(message.transforms.front().header.stamp.toSec()));
  }
}

/// The marker of a namespace; nothing where there is none.
const visualization_msgs::Marker* markerOf(const visualization_msgs::MarkerArray& markers,
                                           const std::string& name_space) {
  for (const auto& marker : markers.markers) {
    if (marker.ns == name_space) return &marker;
  }
  return nullptr;
}

TEST_F(InjectIntoBagTest, MarkersShowEgoAndAttackerWhereTheyAre) {
  inject();
  const auto markers = read<visualization_msgs::MarkerArray>(bagTopic(names::kAttackMarkers));
  const auto all = frames();
  ASSERT_EQ(markers.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double time = all[i].header.stamp.toSec();
    const auto* attacker = markerOf(markers[i], "attacker");
    EXPECT_EQ(attacker != nullptr, time > kNow) << time;
    if (attacker) {
      EXPECT_EQ(attacker->pose.position.y, attackerIn(all[i]).pose.position.y);
      EXPECT_TRUE(markerOf(markers[i], "attacker_path") && markerOf(markers[i], "contact"));
    }
    const auto* ego = markerOf(markers[i], "ego");
    ASSERT_TRUE(ego) << time;
    if (time < kContact) {
      EXPECT_NEAR(ego->pose.position.x, egoAt(time), 1e-6);
    }
  }
  const auto transform = read<tf2_msgs::TFMessage>(names::kTf).back().transforms.front().transform;
  EXPECT_NEAR(markerOf(markers.back(), "ego")->pose.position.x, transform.translation.x, 1e-6);
}

TEST_F(InjectIntoBagTest, TestedReportIsWrittenAtTheContact) {
  inject();
  EXPECT_EQ(timesOf(names::kTestedReport), std::vector<double>{kContact});
  EXPECT_EQ(timesOf(names::kAttack), std::vector<double>{kNow});
}

TEST_F(InjectIntoBagTest, AnotherRecordClockChangesNothingButTheRecordTimes) {
  for (const AfterContact after : {AfterContact::kStop, AfterContact::kEnd}) {
    attack_.after_contact = after;
    seconds_after_stand_ = 0.0;
    record_offset_ = 0.0;
    writeRecording({8.5, 9.0, 9.5, 10.0, 10.5, 11.0, 11.5, 12.0, 12.5, 13.0, 13.5, 14.0});
    inject();
    const auto expected = written();
    for (const double offset : {-5.0, 60.0, 1.6e9}) {
      record_offset_ = offset;
      writeRecording({8.5, 9.0, 9.5, 10.0, 10.5, 11.0, 11.5, 12.0, 12.5, 13.0, 13.5, 14.0});
      inject();
      const auto shifted = written();
      ASSERT_EQ(shifted.size(), expected.size()) << offset;
      for (auto message = shifted.begin(), like = expected.begin(); message != shifted.end();
           ++message, ++like) {
        EXPECT_NEAR(message->first - offset, like->first, 1e-6);
        EXPECT_TRUE(message->second == like->second) << message->second.topic << like->first;
      }
    }
  }
}

TEST_F(InjectIntoBagTest, ABagRecordedDuringASlowReplayHasTheAttackAtItsStamps) {
  inject();
  const auto expected = frames();
  record_rate_ = 2.0;
  record_offset_ = 1000.0;
  writeRecording({8.5, 9.0, 9.5, 10.0, 10.5, 11.0, 11.5, 12.0, 14.0});
  inject();
  EXPECT_EQ(frames(), expected);
  const std::vector<double> times = timesOf(names::kAgents);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(times[i], recordedAt(expected[i].header.stamp.toSec()).toSec(), 1e-6);
  }
  EXPECT_EQ(timesOf(names::kAttack), std::vector<double>{recordedAt(kNow).toSec()});
  EXPECT_NEAR(timesOf(names::kTestedReport).front(), recordedAt(kContact).toSec(), 1e-6);
}

/// Without the package that they are of: read by their size alone, see object_array_test.cpp.
TEST_F(InjectIntoBagTest, ObjectsAreWrittenWithEveryFrameOfAgents) {
  inject();
  const rosbag::Bag bag(out_, rosbag::bagmode::Read);
  const rosbag::TopicQuery topic(bagTopic(names::kAgentObjects));
  std::vector<std::pair<ros::Time, std::size_t>> objects;
  for (const rosbag::MessageInstance& instance : rosbag::View(bag, topic)) {
    objects.emplace_back(instance.getTime(), instance.size());
  }
  std::vector<std::pair<ros::Time, std::size_t>> expected;
  for (const auto& frame : frames()) {
    const auto size = ros::serialization::serializationLength(toObjects(frame));
    expected.emplace_back(frame.header.stamp, size);
  }
  EXPECT_EQ(objects, expected);
}

TEST_F(InjectIntoBagTest, ABagWithAnAttackIsRejectedNamingFileAndTopic) {
  inject();
  EXPECT_NO_THROW(requireNoAttack(in_));
  try {
    requireNoAttack(out_);
    FAIL() << "accepted";
  } catch (const BagError& error) {
    EXPECT_NE(std::string(error.what()).find(out_), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("/attack"), std::string::npos);
  }
}

TEST_F(InjectIntoBagTest, NonFiniteEntriesAreDroppedWithAWarning) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::string spoilt = folder_ / "spoilt.bag";
  {
    NewBag bag(spoilt);
    const rosbag::Bag sound(in_, rosbag::bagmode::Read);
    for (const rosbag::MessageInstance& instance : rosbag::View(sound)) {
      const double time = instance.getTime().toSec();
      const bool is_spoilt = time == 9.0 || time == 11.0;  // before and after now
      if (const auto agents = instance.instantiate<collision_forge::AgentArray>()) {
        if (is_spoilt) {
          agents->agents.push_back(agents->agents[0]);
          agents->agents.back().id = "spoilt";
          agents->agents.back().pose.position.x = kNan;
          agents->agents[0].velocity.x = kNan;
        }
        bag.write(instance.getTopic(), instance.getTime(), *agents);
      } else if (const auto odometry = instance.instantiate<nav_msgs::Odometry>()) {
        if (is_spoilt) odometry->twist.twist.linear.x = kNan;
        bag.write(instance.getTopic(), instance.getTime(), *odometry);
      } else if (const auto transform = instance.instantiate<tf2_msgs::TFMessage>()) {
        if (is_spoilt) transform->transforms[0].transform.rotation.w = kNan;
        bag.write(instance.getTopic(), instance.getTime(), *transform);
      } else {
        bag.write(instance.getTopic(), instance.getTime(), instance);
      }
    }
    bag.commit();
  }
  const auto [warnings, lidar, cameras] = injectIntoBag(
      spoilt, out_, attack_, {ego_, 0.0, config_.attack.verification, config_.attacked_bag});
  EXPECT_EQ(warnings, (std::vector<std::string>{"4 entries of /agents are not finite and left out",
                                                "2 entries of /odom are not finite and left out",
                                                "2 entries of /tf are not finite and left out"}));
  EXPECT_TRUE(lidar.empty());
  EXPECT_TRUE(cameras.empty());
  for (const auto& message : read<collision_forge::AgentArray>(bagTopic(names::kAgents))) {
    for (const auto& agent : message.agents) {
      EXPECT_NE(agent.id, "spoilt");
      EXPECT_TRUE(std::isfinite(agent.pose.position.x + agent.velocity.x)) << message.header.stamp;
    }
  }
  EXPECT_EQ(read<nav_msgs::Odometry>(bagTopic(names::kOdometry)).size(), 8u);
  EXPECT_EQ(read<tf2_msgs::TFMessage>(names::kTf).size(), 8u);
}

}  // namespace
}  // namespace forge
