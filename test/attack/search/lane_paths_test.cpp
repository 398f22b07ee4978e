#include "collision_forge/attack/search/lane_paths.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// "straight" and "bend" lead to "on", 100 m from x = 0 east; "far" leads to "straight".
LaneIndex forkBackwards() {
  auto map = emptyMap();
  Lane bend = straightLane("bend", {-20.0, -20.0}, {-20.0, -10.0}, {"on"});
  bend.centerline.push_back({-15.0, -3.0, 0.8});
  bend.centerline.push_back({0.0, 0.0, 0.0});
  map->lanes = {bend, straightLane("far", {-300.0, 0.0}, {-50.0, 0.0}, {"straight"}),
                straightLane("straight", {-50.0, 0.0}, {0.0, 0.0}, {"on"}),
                straightLane("on", {0.0, 0.0}, {100.0, 0.0})};
  return LaneIndex(map);
}

TEST(LanePaths, FollowTheStraightestPredecessorsFirst) {
  const LaneIndex lanes = forkBackwards();
  const std::vector<Polyline> ways = LanePaths(lanes).to(3, 30.0, 120.0, 20.0, 4);
  ASSERT_EQ(ways.size(), 2u);
  EXPECT_NEAR(ways[0].length(), 140.0, 1e-6);
  EXPECT_NEAR(ways[0].points().front().x(), -90.0, 1e-6);
  EXPECT_NEAR(ways[0].points().back().x(), 50.0, 1e-6);
  EXPECT_NEAR(ways[1].points().front().y(), -20.0, 1e-6) << "no farther than the lanes go";
  EXPECT_NEAR(ways[1].points().back().x(), 50.0, 1e-6);
}

TEST(LanePaths, AreAtMostTheRequestedNumber) {
  const LaneIndex lanes = forkBackwards();
  EXPECT_EQ(LanePaths(lanes).to(3, 30.0, 120.0, 20.0, 1).size(), 1u);
  EXPECT_EQ(LanePaths(lanes).to(3, 30.0, 20.0, 20.0, 4).size(), 1u) << "the fork is farther back";
}

}  // namespace
}  // namespace forge
