#include "collision_forge/planner_test/planners/rule_based_futures.h"

#include <gtest/gtest.h>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const RuleBasedOptions& options() { return shippedConfig().planners.rule_based; }

/// In, then straight on or off to the left.
LaneGraph fork() { return forkedGraph(0.0, {70.0, 70.0}); }

DrivenBox carAt(const Pose2& pose, double speed) { return {pose, speed, kCarSize}; }

TEST(RuleBasedFutures, SpeedsAreSharesTakenOnBySharesOfTheAcceleration) {
  RuleBasedOptions more = options();
  more.acceleration_shares = {0.5, 1.0};
  const std::vector<SpeedPlan> plans = expectedSpeeds(8.0, more);
  ASSERT_EQ(plans.size(), 4U);
  // Half of 3 m/s2 for 0.2 s, then all of it; the last two keep their speed.
  EXPECT_NEAR(plans[0].speeds[1], 7.7, 1e-12);
  EXPECT_NEAR(plans[1].speeds[1], 7.4, 1e-12);
  EXPECT_NEAR(plans[0].speeds.back(), 4.0, 1e-12);
  EXPECT_EQ(plans[2].speeds.back(), 8.0);
}

TEST(RuleBasedFutures, ReachIsHowFarPlansLead) {
  const Reach reach = reachOf({{{}, {0.0, 2.0, 1.0}}, {{}, {0.0, -3.0}}});
  EXPECT_EQ(reach.ahead, 2.0);
  EXPECT_EQ(reach.behind, 3.0);
}

TEST(RuleBasedFutures, EveryWayIsTakenAtEverySpeed) {
  const auto boxes = expectedBoxes(carAt({-10.0, 0.5, 0.0}, 8.0), fork(), options());
  ASSERT_EQ(boxes.size(), 4U);
  for (const ExpectedBox& box : boxes) ASSERT_EQ(box.places.size(), 26U);
  EXPECT_NEAR(boxes[1].places.back().middle.x(), 30.0, 0.05);
  EXPECT_NEAR(boxes[1].places.back().middle.y(), 0.0, 1e-3);
  EXPECT_NEAR(boxes[3].places.back().middle.y(), 30.0 * std::sqrt(0.5), 0.5);
  // Down to half in 13 steps of 0.3 m/s and one of 0.1 m/s, a step counted at its end's speed.
  double distance = 0.0;
  for (int i = 1; i <= 25; ++i) distance += 0.2 * std::max(8.0 - 0.3 * i, 4.0);
  EXPECT_NEAR(boxes[0].places.back().middle.x(), -10.0 + distance, 0.05);
}

TEST(RuleBasedFutures, WhoStandsKeepsStanding) {
  const auto boxes = expectedBoxes(carAt({-40.0, 0.3, 0.1}, 0.0), fork(), options());
  for (const ExpectedBox& box : boxes) {
    EXPECT_EQ(box.places.back().middle, Vector2(-40.0, 0.3));
    EXPECT_EQ(box.places.back().corners, box.places.front().corners);
  }
}

TEST(RuleBasedFutures, WhoReversesIsFollowedBack) {
  const auto boxes = expectedBoxes(carAt({20.0, 0.0, 0.0}, -2.0), fork(), options());
  EXPECT_NEAR(boxes.back().places.back().middle.x(), 10.0, 1e-6);
}

}  // namespace
}  // namespace forge
