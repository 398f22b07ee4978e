#include "collision_forge/attack/search/walker_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

TEST(WalkerPath, GoesAlongTheKerbAndThenStraightToTheMeeting) {
  const auto path = walkerPath({-6.0, -5.0, 0.0}, {2.0, 0.0, M_PI / 2});
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->length(), 8.0 + 5.0 + kBeyondMeeting, 1e-9);
  EXPECT_NEAR((path->poseAt(8.0).position() - Vector2(2.0, -5.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((path->poseAt(13.0).position() - Vector2(2.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(path->poseAt(20.0).yaw, M_PI / 2, 1e-9);
}

TEST(WalkerPath, OppositeTheMeetingIsStraight) {
  const auto path = walkerPath({2.1, -5.0, 1.0}, {2.0, 0.0, M_PI / 2});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points().size(), 3u);
}

TEST(WalkerPath, IsEmptyIfTheMeetingIsBehind) {
  EXPECT_FALSE(walkerPath({2.0, 3.0, 0.0}, {2.0, 0.0, M_PI / 2}));
}

}  // namespace
}  // namespace forge
