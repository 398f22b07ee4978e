#include "collision_forge/planners/idm.h"

#include <gtest/gtest.h>

#include "trials/rollout_scenes.h"

namespace forge {
namespace {

DrivingTask straightTask() {
  return {std::make_shared<const LaneIndex>(twoLaneRoad()),
          {{-50.0, 0.0}, {150.0, 0.0}},
          {kEgoSize, 1.385},
          2.588};
}

TrajectoryPoint egoAt(double speed) { return {kNow, {0.0, 0.0, 0.0}, speed, 0.0, 0.0}; }

const IdmOptions& standard() { return shippedConfig().planners.idm; }
const PublishedIdmOptions& published() { return shippedConfig().planners.published_idm; }

std::vector<TrajectoryPoint> planStandard(double speed, const std::vector<Track>& agents) {
  IdmPlanner planner(standard());
  planner.initialize(straightTask());
  return planner.plan({egoAt(speed), agents});
}

TEST(IdmPlanner, StartsAtTheEgoAndLastsTheHorizon) {
  const auto plan = planStandard(5.0, {});
  ASSERT_EQ(plan.size(), 81u);
  EXPECT_EQ(plan.front().time, kNow);
  EXPECT_NEAR(plan.back().time, kNow + standard().horizon, 1e-9);
}

TEST(IdmPlanner, AcceleratesOnAFreeRoadAsTheLawSays) {
  // a (1 - (v/v0)^4) at 5 m/s of 10: 15/16 m/s2.
  const auto plan = planStandard(5.0, {});
  EXPECT_NEAR(plan[1].speed, 5.0 + 0.1 * 15.0 / 16.0, 1e-9);
  EXPECT_NEAR(plan[1].pose.x, 0.5 + 0.5 * 0.01 * 15.0 / 16.0, 1e-9);
  EXPECT_NEAR(planStandard(10.0, {}).back().speed, 10.0, 1e-9);
}

TEST(IdmPlanner, KeepsTheEquilibriumGap) {
  // (s0 + v T) / sqrt(1 - (v/v0)^4) = 8.5 / sqrt(15/16) at 5 m/s.
  const double gap = 8.5 / std::sqrt(15.0 / 16.0);
  const double x = gap + 0.5 * (kEgoSize.length + kCarSize.length);
  const auto plan = planStandard(5.0, {pastTrack("lead", kCarSize, {x, 0.0, 0.0}, 5.0)});
  EXPECT_NEAR(plan.back().speed, 5.0, 1e-6);
  EXPECT_NEAR(plan.back().pose.x, 5.0 * standard().horizon, 1e-5);
}

TEST(IdmPlanner, StopsBehindAStandingLead) {
  const auto plan = planStandard(5.0, {pastTrack("lead", kCarSize, {25.0, 0.0, 0.0}, 0.0)});
  const double bumper = 25.0 - 0.5 * (kEgoSize.length + kCarSize.length);
  EXPECT_LT(plan.back().speed, 0.5);
  EXPECT_LT(plan.back().pose.x, bumper);
  EXPECT_GT(plan.back().pose.x, bumper - 5.0);
}

TEST(IdmPlanner, NeverDrivesBackwards) {
  const auto plan = planStandard(1.0, {pastTrack("lead", kCarSize, {4.5, 0.0, 0.0}, 0.0)});
  for (const TrajectoryPoint& point : plan) EXPECT_GE(point.speed, 0.0);
  for (std::size_t i = 1; i < plan.size(); ++i) EXPECT_GE(plan[i].pose.x, plan[i - 1].pose.x);
}

TrajectoryPoint planPublished(double speed, const std::vector<Track>& agents) {
  PublishedIdmPlanner planner(published(), "attacker");
  planner.initialize(straightTask());
  return planner.plan({egoAt(speed), agents}).back();
}

TEST(PublishedIdmPlanner, TakesTheAttackerAtCentreDistanceWhereverItIs) {
  // v = 4, lead 3 m/s, 10 m behind: s* = 2 + 6 + 4 / (2 sqrt 10), a = 5 (1 - 0.8^4 - (s*/10)^2).
  const double desired = 8.0 + 4.0 / (2.0 * std::sqrt(10.0));
  const double expected = 5.0 * (1.0 - std::pow(0.8, 4.0) - desired * desired / 100.0);
  for (const double x : {10.0, -10.0}) {
    const auto point = planPublished(4.0, {pastTrack("attacker", kCarSize, {x, 0.0, 0.0}, 3.0)});
    EXPECT_NEAR(point.acceleration, expected, 1e-9) << x;
    EXPECT_NEAR(point.speed, 4.0 + 0.1 * expected, 1e-9) << x;
  }
}

TEST(PublishedIdmPlanner, LooksAtNobodyElse) {
  const auto free = planPublished(4.0, {});
  EXPECT_NEAR(free.acceleration, 5.0 * (1.0 - std::pow(0.8, 4.0)), 1e-9);
  const auto other = planPublished(4.0, {pastTrack("other", kCarSize, {10.0, 0.0, 0.0}, 0.0)});
  EXPECT_EQ(other.acceleration, free.acceleration);
}

}  // namespace
}  // namespace forge
