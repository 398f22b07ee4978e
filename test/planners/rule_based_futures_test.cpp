#include "collision_forge/planners/rule_based_futures.h"

#include <gtest/gtest.h>

#include "planners/planner_scenes.h"

namespace forge {
namespace {

const RuleBasedOptions& options() { return shippedConfig().planners.rule_based; }

/// In, then straight on or off to the left.
std::shared_ptr<const LaneIndex> fork() {
  auto map = std::make_shared<LaneMap>();
  map->lanes = {outlinedLane("in", {-50.0, 0.0}, {0.0, 0.0}, {"straight", "left"}),
                outlinedLane("straight", {0.0, 0.0}, {100.0, 0.0}),
                outlinedLane("left", {0.0, 0.0}, {70.0, 70.0})};
  return std::make_shared<const LaneIndex>(map);
}

TEST(RuleBasedFutures, EveryWayIsTakenAtEveryShareOfTheSpeed) {
  const auto lanes = fork();
  const ExpectedAgent agent =
      expectedAgent(agentAt("a", {-10.0, 0.5, 0.0}, 8.0), *lanes, options());
  ASSERT_EQ(agent.futures.size(), 4U);
  for (const auto& future : agent.futures) ASSERT_EQ(future.size(), 26U);
  // Down to half by half of 3 m/s2, then on: 4 / 1.5 s at 6 m/s, the rest of 5 s at 4 m/s.
  const double braking = 4.0 / 1.5;
  EXPECT_NEAR(agent.futures[0].back().middle.x(), -10.0 + 6.0 * braking + 4.0 * (5.0 - braking),
              0.05);
  EXPECT_NEAR(agent.futures[1].back().middle.x(), 30.0, 0.05);
  EXPECT_NEAR(agent.futures[1].back().middle.y(), 0.0, 1e-3);
  EXPECT_NEAR(agent.futures[3].back().middle.y(), 30.0 * std::sqrt(0.5), 0.5);
}

TEST(RuleBasedFutures, WaysAreBentThroughTheAgent) {
  const ExpectedAgent agent =
      expectedAgent(agentAt("a", {-40.0, 1.5, 0.1}, 5.0), *fork(), options());
  EXPECT_NEAR(agent.futures[0].front().middle.y(), 1.5, 1e-9);
  EXPECT_NEAR(agent.futures[0].front().middle.x(), -40.0, 1e-9);
  EXPECT_NEAR(agent.futures[1].back().middle.y(), 0.0, 0.01);
}

TEST(RuleBasedFutures, WhoIsOnNoLaneGoesStraightOn) {
  for (const Pose2& pose : {Pose2{-40.0, 2.2, 0.2}, Pose2{-40.0, 0.0, 0.4}}) {
    const ExpectedAgent agent = expectedAgent(agentAt("a", pose, 5.0), *fork(), options());
    ASSERT_EQ(agent.futures.size(), 2U);
    const Vector2 end = compose(pose, {25.0, 0.0, 0.0}).position();
    EXPECT_NEAR((agent.futures[1].back().middle - end).norm(), 0.0, 1e-6);
  }
}

TEST(RuleBasedFutures, WhoStandsKeepsStanding) {
  const ExpectedAgent agent =
      expectedAgent(agentAt("a", {-40.0, 0.3, 0.1}, 0.0), *fork(), options());
  ASSERT_EQ(agent.futures.size(), 1U);
  EXPECT_EQ(agent.futures[0].back().middle, Vector2(-40.0, 0.3));
  EXPECT_EQ(agent.futures[0].back().centers, agent.futures[0].front().centers);
}

TEST(RuleBasedFutures, OfLanesThatFollowEachOtherTheNearestCounts) {
  const auto lanes = fork();
  EXPECT_EQ(drivenLanes(*lanes, {-0.1, 0.2, 0.0}, options()).size(), 1U);
  EXPECT_EQ(drivenLanes(*lanes, {-0.1, 0.2, 0.0}, options())[0].lane, 0U);
  // Two that do not follow each other are both driven.
  auto map = std::make_shared<LaneMap>();
  map->lanes = {straightLane("a", {0.0, 0.0}, {50.0, 0.0}),
                straightLane("b", {0.0, 1.0}, {50.0, 1.0})};
  EXPECT_EQ(drivenLanes(LaneIndex(map), {20.0, 0.6, 0.0}, options()).size(), 2U);
}

}  // namespace
}  // namespace forge
