#include "collision_forge/planner_test/planners/rule_based_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const RuleBasedOptions& options() { return shippedConfig().planners.rule_based; }

LaneSpline straight(const Pose2& pose) {
  return LaneSpline({{0.0, {pose.position(), pose.heading()}}});
}

/// Standing, expected to keep standing.
ExpectedBox standing(const Pose2& pose) {
  return expectedBoxes({pose, 0.0, kCarSize}, {straight(pose)}, expectedSpeeds(0.0, options()))
      .front();
}

RuleBasedChoice chooseFor(double speed, bool is_on_lane, const std::vector<ExpectedBox>& others) {
  return chooseProfile({{0.0, 0.0, 0.0}, speed, kCarSize}, straight({0.0, 0.0, 0.0}), is_on_lane,
                       others, options());
}

TEST(CollisionProbability, FallsWithTheGapAndTheSteps) {
  EXPECT_EQ(collisionProbability(-0.1, 0, options()), 1.0);
  EXPECT_EQ(collisionProbability(0.0, 0, options()), 1.0);
  EXPECT_DOUBLE_EQ(collisionProbability(2.0, 0, options()), 1.0 - std::tanh(1.4));
  EXPECT_DOUBLE_EQ(collisionProbability(2.0, 10, options()), 1.0 - std::tanh(2.4));
  EXPECT_EQ(collisionProbability(std::numeric_limits<double>::infinity(), 3, options()), 0.0);
}

TEST(RuleBasedChoice, ProbabilitiesOfTheStepsAreTakenTogether) {
  const RuleBasedChoice choice = chooseFor(5.0, true, {standing({12.0, 3.0, 0.3})});
  for (const WeighedProfile& weighed : choice.profiles) {
    double missed = 1.0;
    for (std::size_t i = 0; i < weighed.gaps.size(); ++i) {
      missed *= 1.0 - collisionProbability(weighed.gaps[i], static_cast<int>(i), options());
    }
    EXPECT_NEAR(weighed.probability, 1.0 - missed, 1e-12);
  }
}

TEST(RuleBasedChoice, TheGapIsThatToTheNearestOfAllFutures) {
  // Three in turn, near and far: leaving out the far ones must change nothing.
  std::vector<ExpectedBox> others;
  for (const double y : {30.0, -4.0, 9.0, 3.2}) others.push_back(standing({15.0, y, 0.2 * y}));
  const RuleBasedChoice all = chooseFor(8.0, true, others);
  for (std::size_t k = 0; k < all.profiles.size(); ++k) {
    for (std::size_t i = 0; i < all.profiles[k].gaps.size(); ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (const ExpectedBox& other : others) {
        const RuleBasedChoice one = chooseFor(8.0, true, {other});
        least = std::min(least, one.profiles[k].gaps[i]);
      }
      ASSERT_EQ(all.profiles[k].gaps[i], least);
    }
    if (k == 4) k = 19;
  }
}

TEST(RuleBasedChoice, OnAnEmptyRoadTheFarthestIsTaken) {
  EXPECT_EQ(chooseFor(8.0, true, {}).chosen, 24U);
  EXPECT_EQ(chooseFor(8.0, false, {}).chosen, 24U);
}

TEST(RuleBasedChoice, OffTheLanesTheShortestSafeOneIsTaken) {
  EXPECT_EQ(chooseFor(8.0, false, {standing({0.0, 40.0, 0.0})}).chosen, 0U);
  EXPECT_EQ(chooseFor(8.0, true, {standing({0.0, 40.0, 0.0})}).chosen, 24U);
}

TEST(RuleBasedChoice, WhereAllCollideForSureTheFirstIsTaken) {
  const RuleBasedChoice choice = chooseFor(8.0, true, {standing({4.0, 0.0, 0.0})});
  EXPECT_EQ(choice.chosen, 0U);
  for (const WeighedProfile& weighed : choice.profiles) EXPECT_EQ(weighed.probability, 1.0);
}

TEST(RuleBasedChoice, WithoutASafeOneTheLeastProbabilityIsTaken) {
  // Beside a parked car there is some risk in standing, and less in leaving.
  const RuleBasedChoice choice = chooseFor(0.0, true, {standing({-1.0, 2.3, 0.0})});
  for (const WeighedProfile& weighed : choice.profiles) {
    EXPECT_GT(weighed.probability, options().max_probability);
    EXPECT_LE(choice.profiles[choice.chosen].probability, weighed.probability);
  }
  EXPECT_GT(choice.profiles[choice.chosen].profile.plan.distances.back(), 5.0);
}

TEST(PoseAfterStep, LiesOnTheChordAsFarAsTheStepTakesIt) {
  // A way that turns: after 2 m of it the place is at (1, 1), 1.41 m away.
  const LaneSpline way({{0.0, {{0.0, 0.0}, {1.0, 0.0}}},
                        {2.0, {{1.0, 1.0}, {0.0, 1.0}}},
                        {9.0, {{1.0, 8.0}, {0.0, 1.0}}}});
  const Pose2 pose = poseAfterStep({0.0, 0.0, 0.0}, way, {{10.0, 10.0}, {0.0, 2.0}});
  EXPECT_NEAR(pose.x, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(pose.y, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(pose.yaw, 0.5 * M_PI, 1e-12);
}

TEST(PoseAfterStep, GoesStraightOnWhereTheWayLeadsToTheOtherSide) {
  const LaneSpline back({{0.0, {{0.0, 0.0}, {1.0, 0.0}}}, {1.0, {{-1.0, 0.1}, {1.0, 0.0}}}});
  const Pose2 pose = poseAfterStep({0.0, 0.0, 0.0}, back, {{5.0, 5.0}, {0.0, 1.0}});
  EXPECT_NEAR(pose.x, 1.0, 1e-12);
  EXPECT_NEAR(pose.y, 0.0, 1e-12);
  const Pose2 reversed =
      poseAfterStep({0.0, 0.0, 0.5}, straight({0.0, 0.0, 0.5}), {{-5.0, -5.0}, {0.0, -1.0}});
  EXPECT_NEAR(reversed.x, -std::cos(0.5), 1e-12);
  EXPECT_NEAR(reversed.y, -std::sin(0.5), 1e-12);
}

TEST(PoseAfterStep, StandsWhereItIsNotDriven) {
  const Pose2 pose =
      poseAfterStep({3.0, 4.0, 0.5}, straight({3.0, 4.0, 0.5}), {{0.0, 0.0}, {0.0, 0.0}});
  EXPECT_EQ(pose.position(), Vector2(3.0, 4.0));
  EXPECT_NEAR(pose.yaw, 0.5, 1e-12);
}

/// Straight on or off to the left at x = 30.
LaneGraph fork() { return forkedGraph(30.0, {100.0, 70.0}); }

TEST(PlanOnLanes, DrivesTheFirstWayOrThatAlongTheRoute) {
  const DrivenBox ego{{0.0, 0.0, 0.0}, 10.0, kCarSize};
  const Polyline left({{-50.0, 0.0}, {30.0, 0.0}, {100.0, 70.0}});
  EXPECT_NEAR(planOnLanes(ego, {}, fork(), nullptr, options()).way.at(50.0).position.y(), 0.0,
              1e-6);
  EXPECT_GT(planOnLanes(ego, {}, fork(), &left, options()).way.at(50.0).position.y(), 10.0);
}

TEST(PlanOnLanes, WhoIsOutOfReachIsNotLookedAt) {
  const DrivenBox ego{{0.0, 0.0, 0.0}, 8.0, kCarSize};
  const DrivenBox near{{0.0, 69.9, 0.0}, 0.0, kCarSize};
  const DrivenBox far{{0.0, 70.1, 0.0}, 0.0, kCarSize};
  EXPECT_EQ(planOnLanes(ego, {near}, fork(), nullptr, options()).other_futures, 2U);
  EXPECT_EQ(planOnLanes(ego, {far}, fork(), nullptr, options()).other_futures, 0U);
}

}  // namespace
}  // namespace forge
