#include "collision_forge/ros/bags/recorded_attack.h"

#include <collision_forge/AttackRequest.h>
#include <gtest/gtest.h>
#include <std_msgs/Empty.h>
#include <unistd.h>

#include <filesystem>

#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

class RecordedAttackTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }

  const std::string path_ = std::filesystem::temp_directory_path() /
                            ("collision_forge_recorded_" + std::to_string(getpid()) + ".bag");
};

TEST_F(RecordedAttackTest, ABagWithoutAnAttackHasNone) {
  NewBag bag(path_);
  bag.write("/other", ros::Time(1.0), std_msgs::Empty());
  bag.commit();
  EXPECT_FALSE(readRecordedAttack(path_));
}

TEST_F(RecordedAttackTest, TheReportOfABagIsReadWithTheNameOfItsRecording) {
  collision_forge::CollisionReport report;
  report.attacker_id = "added-1";
  report.impact_speed = 24.7;
  collision_forge::AttackRequest request;
  request.bag = "scene.bag";
  NewBag bag(path_);
  bag.writeLatched(bagTopic(names::kAttackRequest), ros::Time(1.0), request);
  bag.writeLatched(bagTopic(names::kTestedReport), ros::Time(5.0), report);
  bag.commit();
  const auto attack = readRecordedAttack(path_);
  ASSERT_TRUE(attack);
  EXPECT_EQ(attack->tested_report, report);
  EXPECT_EQ(attack->source, "scene.bag");
}

TEST_F(RecordedAttackTest, TheRefusalNamesBagAttackerAndRecording) {
  RecordedAttack attack;
  attack.tested_report.attacker_id = "added-1";
  attack.source = "scene.bag";
  EXPECT_EQ(refusalOf(attack, "/some/head_on.bag"),
            "head_on.bag already has an attack, by added-1: replay the recording without it, "
            "scene.bag");
}

TEST_F(RecordedAttackTest, AFileThatIsNotABagIsNamed) {
  try {
    readRecordedAttack("/nowhere.bag");
    FAIL();
  } catch (const BagError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere.bag"), std::string::npos);
  }
}

}  // namespace
}  // namespace forge
