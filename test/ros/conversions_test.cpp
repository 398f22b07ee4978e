#include "ros/conversions.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace forge
