#include "collision_forge/planner_test/planners/lane_matches.h"

#include <gtest/gtest.h>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const RuleBasedOptions& options() { return shippedConfig().planners.rule_based; }

/// In along x to 0, then straight on or gently left, 0.1 m to the left a metre.
LaneGraph fork() { return forkedGraph(0.0, {50.0, 5.0}); }

TEST(LaneMatches, TheNearestEdgeOfALaneIsTaken) {
  const std::vector<EdgeMatch> matches = matchedEdges(fork(), {-20.3, 0.5, 0.1}, options());
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_NEAR(matches[0].distance, 0.5, 1e-12);
  EXPECT_NEAR(matches[0].closest.x(), -20.3, 1e-12);
  EXPECT_NEAR(matches[0].closest.y(), 0.0, 1e-12);
}

TEST(LaneMatches, LanesThatPartAreBothTakenNearestFirst) {
  const std::vector<EdgeMatch> matches = matchedEdges(fork(), {10.2, 0.8, 0.1}, options());
  ASSERT_EQ(matches.size(), 2U);
  EXPECT_GT(matches[0].closest.y(), 0.9);
  EXPECT_NEAR(matches[1].distance, 0.8, 1e-12);
}

TEST(LaneMatches, BeforeTheForkThereIsOneLane) {
  EXPECT_EQ(matchedEdges(fork(), {-0.4, 0.3, 0.0}, options()).size(), 1U);
}

TEST(LaneMatches, WhoIsTooFarOrHeadsElsewhereIsOnNone) {
  EXPECT_EQ(matchedEdges(fork(), {-20.0, 1.99, 0.34}, options()).size(), 1U);
  EXPECT_TRUE(matchedEdges(fork(), {-20.0, 2.01, 0.0}, options()).empty());
  EXPECT_TRUE(matchedEdges(fork(), {-20.0, 0.0, 0.36}, options()).empty());
  EXPECT_TRUE(matchedEdges(fork(), {-20.0, 0.0, M_PI}, options()).empty());
}

TEST(LaneMatches, ClosestPointsStayBetweenTheEnds) {
  EXPECT_EQ(closestBetween({0.0, 0.0}, {2.0, 0.0}, {0.5, 3.0}), Vector2(0.5, 0.0));
  EXPECT_EQ(closestBetween({0.0, 0.0}, {2.0, 0.0}, {-1.0, 3.0}), Vector2(0.0, 0.0));
  EXPECT_EQ(closestBetween({0.0, 0.0}, {2.0, 0.0}, {4.0, 3.0}), Vector2(2.0, 0.0));
}

}  // namespace
}  // namespace forge
