#include "collision_forge/ros/rviz/following_view.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

constexpr double kFrame = 1.0 / 30.0;  // s

/// The view that comes to rest.
TopView settled(FollowingView& following, TopView shown, const TopView& goal) {
  for (int i = 0; i < 300; ++i) shown = following.next(shown, goal, kFrame);
  return shown;
}

TEST(FollowingView, StartsAtTheGoalAndMovesSmoothlyToTheNextOne) {
  FollowingView following;
  const TopView first = following.next({}, {10.0, 0.0, 12.0}, kFrame);
  EXPECT_DOUBLE_EQ(first.x, 10.0);
  const TopView goal{60.0, 0.0, 6.0};
  const TopView second = following.next(first, goal, kFrame);
  EXPECT_GT(second.x, 10.0);
  EXPECT_LT(second.x, 20.0);
  EXPECT_LT(second.scale, 12.0);
  const TopView last = settled(following, second, goal);
  EXPECT_NEAR(last.x, 60.0, 0.01);
  EXPECT_NEAR(last.scale, 6.0, 0.01);
}

TEST(FollowingView, KeepsTheZoomAndTheOffsetOfTheUser) {
  FollowingView following;
  TopView shown = following.next({}, {10.0, 5.0, 12.0}, kFrame);
  shown.scale *= 2.0;
  shown.y += 7.0;
  const TopView later = settled(following, shown, {40.0, 5.0, 6.0});
  EXPECT_NEAR(later.x, 40.0, 0.01);
  EXPECT_NEAR(later.y, 12.0, 0.01);
  EXPECT_NEAR(later.scale, 12.0, 0.01);
  following.reset();
  EXPECT_DOUBLE_EQ(following.next(later, {40.0, 5.0, 6.0}, kFrame).scale, 6.0);
}

TEST(FollowingView, JumpsToAnotherPartOfTheMap) {
  FollowingView following;
  const TopView first = following.next({}, {0.0, 0.0, 12.0}, kFrame);
  EXPECT_DOUBLE_EQ(following.next(first, {1000.0, 0.0, 12.0}, kFrame).x, 1000.0);
}

}  // namespace
}  // namespace forge
