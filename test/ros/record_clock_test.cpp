#include "collision_forge/ros/injection/record_clock.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(RecordClockTest, WithoutMessagesBothClocksAreEqual) {
  const RecordClock clock;
  EXPECT_EQ(clock.recordedAt(ros::Time(7, 3)), ros::Time(7, 3));
  EXPECT_EQ(clock.stampAt(ros::Time(7, 3)), ros::Time(7, 3));
}

TEST(RecordClockTest, EqualTimesAreKeptToTheNanosecond) {
  RecordClock clock;
  for (const unsigned second : {1533151603u, 1533151604u, 1533151606u}) {
    clock.add(ros::Time(second, 547590123), ros::Time(second, 547590123));
  }
  const ros::Time between(1533151605, 123456789);
  EXPECT_EQ(clock.recordedAt(between), between);
  EXPECT_EQ(clock.stampAt(between), between);
}

TEST(RecordClockTest, OffsetIsInterpolatedBetweenMessagesAndConstantBeyondThem) {
  RecordClock clock;
  clock.add(ros::Time(10), ros::Time(110));
  clock.add(ros::Time(20), ros::Time(130));
  const double pairs[][2] = {{5, 105}, {10, 110}, {15, 120}, {20, 130}, {25, 135}};
  for (const auto& [stamp, recorded] : pairs) {
    EXPECT_EQ(clock.recordedAt(ros::Time(stamp)), ros::Time(recorded)) << stamp;
    EXPECT_EQ(clock.stampAt(ros::Time(recorded)), ros::Time(stamp)) << recorded;
  }
}

TEST(RecordClockTest, MessagesOutOfOrderAreIgnored) {
  RecordClock clock;
  clock.add(ros::Time(10), ros::Time(110));
  clock.add(ros::Time(9), ros::Time(120));   // an earlier stamp
  clock.add(ros::Time(12), ros::Time(110));  // recorded at the same time
  EXPECT_EQ(clock.recordedAt(ros::Time(12)), ros::Time(112));
}

TEST(RecordClockTest, TimesBeyondTheRangeOfTheClockAreItsBounds) {
  RecordClock clock;
  clock.add(ros::Time(1000), ros::Time(10));
  EXPECT_EQ(clock.recordedAt(ros::Time(500)), ros::TIME_MIN);
  EXPECT_EQ(clock.stampAt(ros::TIME_MAX), ros::TIME_MAX);
}

}  // namespace
}  // namespace forge
