#include "collision_forge/planner_test/planners/lane_splines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const RuleBasedOptions& options() { return shippedConfig().planners.rule_based; }

/// In along x to 0, then straight on or off to the left.
LaneGraph fork() { return forkedGraph(0.0, {70.0, 70.0}); }

std::vector<LaneSpline> splinesAt(const Pose2& pose, double speed = 5.0,
                                  const Reach& reach = {60.0, 10.0}) {
  const LaneGraph graph = fork();
  return laneSplinesOf(graph, matchedEdges(graph, pose, options()), pose, speed, reach, options());
}

TEST(LaneSpline, IsLinearBetweenKnotsAndStraightBeyond) {
  const LaneSpline spline({{-2.0, {{-2.0, 0.0}, {1.0, 0.0}}}, {2.0, {{0.0, 2.0}, {0.0, 1.0}}}});
  EXPECT_EQ(spline.at(0.0).position, Vector2(-1.0, 1.0));
  EXPECT_EQ(spline.at(0.0).heading, Vector2(0.5, 0.5));
  EXPECT_EQ(spline.at(-5.0).position, Vector2(-5.0, 0.0));
  EXPECT_EQ(spline.at(3.0).position, Vector2(0.0, 3.0));
  EXPECT_THROW(LaneSpline({}), std::invalid_argument);
}

TEST(LaneSplines, StartAtTheVehicleAndFadeIntoTheLane) {
  const LaneSpline spline = splinesAt({-40.0, 1.5, 0.1}).front();
  EXPECT_EQ(spline.at(0.0).position, Vector2(-40.0, 1.5));
  EXPECT_NEAR(spline.at(0.0).heading.y(), std::sin(0.1), 1e-12);
  // The fourth knot ahead is 4 * 0.4 m of lane on; three lengths of chords lead there.
  double length = 0.0;
  Vector2 last(-40.0, 1.5);
  for (int i = 1; i <= 4; ++i) {
    const double s = 0.4 * i;
    const Vector2 knot(-40.0 + s, 1.5 * std::exp(-s * s / 12.25));
    length += (knot - last).norm();
    last = knot;
  }
  EXPECT_NEAR((spline.at(length).position - last).norm(), 0.0, 1e-9);
  EXPECT_NEAR(spline.at(15.0).position.y(), 0.0, 1e-6);
}

TEST(LaneSplines, HeadingsAreThoseToTheNextKnotAhead) {
  const LaneSpline spline = splinesAt({-40.0, 1.5, 0.0}, -5.0).front();
  const auto offset = [](double s) { return 1.5 * std::exp(-s * s / 12.25); };
  const Vector2 first(0.4, offset(0.4) - 1.5);
  const Vector2 ahead(0.4, offset(0.8) - offset(0.4));
  EXPECT_NEAR((spline.at(first.norm()).heading - ahead.normalized()).norm(), 0.0, 1e-9);
  // Behind somebody who drives backwards at 5 m/s, 25 + 5 m by 76 pieces.
  const double piece = 30.0 / 76.0;
  const Vector2 behind(piece, 1.5 - offset(piece));
  EXPECT_NEAR((spline.at(-behind.norm()).heading - behind.normalized()).norm(), 0.0, 1e-9);
}

TEST(LaneSplines, LeadAlongEveryBranch) {
  const std::vector<LaneSpline> splines = splinesAt({-10.0, 0.0, 0.0});
  ASSERT_EQ(splines.size(), 2U);
  EXPECT_NEAR(splines[0].at(50.0).position.x(), 40.0, 1e-9);
  EXPECT_NEAR(splines[1].at(50.0).position.x(), 40.0 * std::sqrt(0.5), 0.1);
}

TEST(LaneSplines, BehindAMergeThereAreSeveralWays) {
  auto map = std::make_shared<LaneMap>();
  map->lanes = {straightLane("a", {-50.0, 0.0}, {0.0, 0.0}, {"on"}),
                straightLane("b", {-40.0, -30.0}, {0.0, 0.0}, {"on"}),
                straightLane("on", {0.0, 0.0}, {100.0, 0.0})};
  const LaneGraph graph = laneGraphOf(LaneIndex(map), 1.0);
  const Pose2 pose{3.0, 0.0, 0.0};
  const auto matches = matchedEdges(graph, pose, options());
  EXPECT_EQ(laneSplinesOf(graph, matches, pose, 5.0, {25.0, 0.0}, options()).size(), 1U);
  const auto reversing = laneSplinesOf(graph, matches, pose, -5.0, {0.0, 25.0}, options());
  ASSERT_EQ(reversing.size(), 2U);
  EXPECT_NEAR(reversing[0].at(-23.0).position.x(), -20.0, 1e-6);
  EXPECT_NEAR(reversing[1].at(-23.0).position.x(), -16.0, 0.1);
}

TEST(LaneSplines, BeyondTheEndOfTheLanesItGoesStraightOn) {
  const LaneSpline spline = splinesAt({80.0, 0.4, 0.0}).front();
  EXPECT_NEAR(spline.at(60.0).position.x(), 140.0, 0.1);
  EXPECT_NEAR(spline.at(60.0).position.y(), 0.0, 1e-9);
}

TEST(LaneSplines, WhoIsOnNoLaneGoesStraightOn) {
  const Pose2 pose{-40.0, 2.2, 0.2};
  const std::vector<LaneSpline> splines = splinesAt(pose);
  ASSERT_EQ(splines.size(), 1U);
  const Vector2 end = compose(pose, {25.0, 0.0, 0.0}).position();
  EXPECT_NEAR((splines[0].at(25.0).position - end).norm(), 0.0, 1e-12);
}

TEST(LaneSplines, AShorterReachChangesNothingNearer) {
  const Pose2 pose{-20.0, 1.0, 0.1};
  const LaneSpline far = splinesAt(pose, -2.0, {70.0, 15.0}).front();
  const LaneSpline near = splinesAt(pose, -2.0, {7.3, 3.1}).front();
  for (double length = -3.1; length <= 7.3; length += 0.1) {
    EXPECT_EQ(near.at(length).position, far.at(length).position);
    EXPECT_EQ(near.at(length).heading, far.at(length).heading);
  }
}

TEST(LaneSplines, WhereAnEdgeEndsShortOfTheVehicleTheLaneIsFollowedToItsNearestPoint) {
  // Two edges; the vehicle heads along the first and stands beside the second, which turns off.
  const LaneGraph graph({{0.0, 0.0}, {1.0, 0.0}, {1.8, 0.6}, {2.6, 1.2}}, {{0, 1}, {1, 2}, {2, 3}});
  const Pose2 pose{2.0, -0.2, 0.0};
  const auto matches = matchedEdges(graph, pose, options());
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches[0].closest, Vector2(1.0, 0.0));
  const auto spline = laneSplinesOf(graph, matches, pose, 5.0, {25.0, 0.0}, options()).front();
  // The nearest point of the lane lies at (1, 0) + 0.68 (0.8, 0.6); far on the way lies on the
  // lane.
  EXPECT_NEAR(spline.at(25.0).position.y() - 0.75 * spline.at(25.0).position.x(), -0.75, 1e-6);
  EXPECT_NEAR(spline.at(25.0).position.x(), 1.0 + 0.8 * 25.68, 0.1);
}

}  // namespace
}  // namespace forge
