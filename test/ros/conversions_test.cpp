#include "collision_forge/ros/conversions.h"

#include <gtest/gtest.h>

#include <limits>

namespace forge {
namespace {

TEST(StampOf, GivesStampsOfWholeMicrosecondsBack) {
  const std::uint64_t first = 1532402927647951;  // us, a sample of nuScenes
  for (std::uint64_t i = 0; i < 10000; ++i) {
    const ros::Time stamp = ros::Time().fromNSec(1000 * (first + 7919 * i));
    ASSERT_EQ(stampOf(stamp.toSec()), stamp);
  }
}

TEST(StampOf, TakesOthersToTheNearestMicrosecond) {
  EXPECT_EQ(stampOf(1.0000014), ros::Time(1, 1000));
  EXPECT_EQ(stampOf(1.9999996), ros::Time(2, 0));
  EXPECT_EQ(stampOf(0.0), ros::Time(0, 0));
}

collision_forge::AttackerTrajectory drivenFor(int points) {
  collision_forge::AttackerTrajectory message;
  message.attacker_id = "a";
  message.size.x = 4.5;
  message.size.y = 2.0;
  for (int i = 0; i < points; ++i) {
    message.points.emplace_back();
    message.points.back().stamp = ros::Time(10.0 + 0.1 * i);
    message.points.back().pose.orientation.w = 1.0;
  }
  return message;
}

std::string complaintAbout(const collision_forge::AttackerTrajectory& message) {
  try {
    static_cast<void>(fromMessage(message));
  } catch (const MessageError& error) {
    return error.what();
  }
  return "";
}

TEST(AttackerTrajectoryMessage, MustBeOfNumbersWhoseTimesGrow) {
  EXPECT_EQ(fromMessage(drivenFor(4)).points.size(), 4u);
  EXPECT_TRUE(fromMessage(drivenFor(0)).points.empty());
  auto message = drivenFor(4);
  message.points[2].pose.position.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaintAbout(message), "attacker a: points[2] is not finite");
  message = drivenFor(4);
  message.points[1].speed = std::numeric_limits<double>::infinity();
  EXPECT_EQ(complaintAbout(message), "attacker a: points[1] is not finite");
  message = drivenFor(4);
  message.size.y = 0.0;
  EXPECT_EQ(complaintAbout(message), "attacker a: size is not positive");
  message = drivenFor(4);
  message.points[3].stamp = message.points[2].stamp;
  EXPECT_EQ(complaintAbout(message), "attacker a: points[3].stamp is not after the one before");
  message = drivenFor(4);
  message.agent_class = 200;
  EXPECT_NE(complaintAbout(message), "");
}

}  // namespace
}  // namespace forge
