#include "collision_forge/ros/injection/attacked_frames.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <set>
#include <string>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr double kNow = 10.0;   // s, t0
constexpr double kPast = 9.0;   // s, begin of the past of an added vehicle
constexpr double kEnd = 12.0;   // s
constexpr double kStep = 0.5;   // s
constexpr double kSpeed = 5.0;  // m/s, along x

/// A vehicle that drives on the line of this y from t0 on; with a past if it is added.
collision_forge::AttackerTrajectory motionOf(const std::string& id, double y, bool is_added) {
  collision_forge::AttackerTrajectory motion;
  motion.header.stamp = ros::Time(kNow);
  motion.attacker_id = id;
  motion.size.x = 4.5;
  motion.size.y = 1.9;
  motion.size.z = 1.5;
  motion.added = is_added;
  for (double time = kNow; time <= kEnd; time += kStep) {
    auto& point = motion.points.emplace_back();
    point.stamp = ros::Time(time);
    point.pose.position.x = kSpeed * time;
    point.pose.position.y = y;
    point.pose.orientation.w = 1.0;
    point.speed = kSpeed;
  }
  for (double time = kPast; is_added && time <= kNow; time += kStep) {
    auto& state = motion.past.emplace_back();
    state.stamp = ros::Time(time);
    state.pose.x = kSpeed * time;
    state.pose.y = y;
  }
  return motion;
}

class AttackedFramesTest : public testing::Test {
 protected:
  void SetUp() override {
    NewBag bag(path_);
    for (double time = 8.0; time <= kEnd; time += kStep) {
      collision_forge::AgentArray frame;
      frame.header.stamp = ros::Time(time);
      for (const char* id : {"recorded", "bystander"}) {
        collision_forge::Agent& agent = frame.agents.emplace_back();
        agent.id = id;
        agent.pose.orientation.w = 1.0;
      }
      bag.write(bagTopic(names::kAgents), frame.header.stamp, frame);
    }
    bag.commit();
    attack_.lidar.emplace();
  }
  void TearDown() override { std::filesystem::remove(path_); }

  /// Adds a support vehicle to the attack.
  void addSupport(const collision_forge::AttackerTrajectory& motion) {
    attack_.attack.supports.emplace_back().motion = motion;
  }

  AttackedFrames frames() const {
    const rosbag::Bag bag(path_, rosbag::bagmode::Read);
    const RecordingContext recording{ego_, 0.0, config_.attack.verification, config_.attacked_bag};
    return {bag, attack_, recording, std::nullopt, ros::TIME_MAX};
  }

  static std::set<std::string> idsOf(const std::vector<collision_forge::Agent>& agents) {
    std::set<std::string> ids;
    for (const collision_forge::Agent& agent : agents) ids.insert(agent.id);
    return ids;
  }

  using Ids = std::set<std::string>;
  const std::string path_ = std::filesystem::temp_directory_path() /
                            ("attacked_frames_" + std::to_string(getpid()) + ".bag");
  const Config config_ = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  const Track ego_{kEgoId, AgentClass::kCar, config_.ego_vehicle.size, {}};
  BagAttack attack_;
};

TEST_F(AttackedFramesTest, ARecordedAttackerLeavesItsPlaceAfterT0WithAnAddedSupport) {
  attack_.attack.trajectory = motionOf("recorded", 3.0, false);
  addSupport(motionOf("parked", -3.0, true));
  const AttackedFrames frames = this->frames();
  EXPECT_FALSE(frames.isChangedAt(ros::Time(8.5)));
  EXPECT_EQ(idsOf(frames.vacatedAt(ros::Time(8.5))), Ids());
  EXPECT_TRUE(frames.isChangedAt(ros::Time(9.25))) << "the support is there";
  EXPECT_EQ(idsOf(frames.vacatedAt(ros::Time(9.25))), Ids());
  EXPECT_EQ(idsOf(frames.vacatedAt(ros::Time(kNow))), Ids());
  EXPECT_EQ(idsOf(frames.vacatedAt(ros::Time(10.25))), Ids{"recorded"});
}

TEST_F(AttackedFramesTest, ARecordedSupportLeavesItsPlaceAfterT0WithAnAddedAttacker) {
  attack_.attack.trajectory = motionOf("added", 3.0, true);
  addSupport(motionOf("recorded", -3.0, false));
  const AttackedFrames frames = this->frames();
  EXPECT_TRUE(frames.isChangedAt(ros::Time(kPast)));
  EXPECT_EQ(idsOf(frames.vacatedAt(ros::Time(9.25))), Ids());
  EXPECT_EQ(idsOf(frames.vacatedAt(ros::Time(10.25))), Ids{"recorded"});
}

TEST_F(AttackedFramesTest, VehiclesArePlacedWhileTheyDriveElsewhere) {
  attack_.attack.trajectory = motionOf("recorded", 3.0, false);
  addSupport(motionOf("parked", -3.0, true));
  AttackedFrames frames = this->frames();
  EXPECT_EQ(idsOf(frames.placedAt(ros::Time(8.5))), Ids());
  EXPECT_EQ(idsOf(frames.placedAt(ros::Time(9.25))), Ids{"parked"});
  EXPECT_EQ(idsOf(frames.placedAt(ros::Time(10.25))), (Ids{"parked", "recorded"}));
}

}  // namespace
}  // namespace forge
