#include "collision_forge/attack/forecast/kinematic_prediction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// The only agent's prediction over six seconds.
Track predicted(const Track& past, const std::shared_ptr<LaneMap>& map) {
  const Track ego = pastTrack(kEgoId, kEgoSize, {-100.0, 0.0, 0.0}, 0.0);
  const Future future = predictFuture(snapshotOf(ego, {past}, map), LaneIndex(map), 6.0);
  return future.agents.at(0);
}

void expectPose(const Pose2& pose, const Pose2& expected, double tolerance) {
  EXPECT_NEAR(pose.x, expected.x, tolerance);
  EXPECT_NEAR(pose.y, expected.y, tolerance);
  EXPECT_NEAR(angleBetween(expected.yaw, pose.yaw), 0.0, tolerance);
}

TEST(PredictFuture, CoversTheHorizonFromNowInEvenSteps) {
  const Track past = pastTrack("a", kCarSize, {}, 10.0);
  const Track track = predicted(past, twoLaneRoad());
  EXPECT_EQ(track.id, "a");
  EXPECT_EQ(track.size.length, kCarSize.length);
  EXPECT_EQ(track.states.front().time, kNow);
  EXPECT_GE(track.states.back().time, kNow + 6.0 - 1e-9);
  for (std::size_t i = 1; i < track.states.size(); ++i) {
    EXPECT_NEAR(track.states[i].time - track.states[i - 1].time, kPredictionStep, 1e-9);
  }
}

TEST(PredictFuture, FollowsALaneAtConstantSpeed) {
  const Track track = predicted(pastTrack("a", kCarSize, {3.0, 3.5, M_PI}, 8.0), twoLaneRoad());
  expectPose(stateAt(track, kNow + 5.0)->pose, {-37.0, 3.5, M_PI}, 1e-6);
  EXPECT_NEAR(stateAt(track, kNow + 5.0)->velocity.x(), -8.0, 1e-6);
}

TEST(PredictFuture, FadesTheOffsetFromTheLane) {
  const Track track = predicted(pastTrack("a", kCarSize, {0.0, 1.0, 0.0}, 5.0), twoLaneRoad());
  expectPose(track.states.front().pose, {0.0, 1.0, 0.0}, 1e-6);
  EXPECT_NEAR(stateAt(track, kNow + 3.0)->pose.y, std::exp(-1.0), 1e-6) << "15 m on";
  EXPECT_NEAR(stateAt(track, kNow + 3.0)->pose.x, 15.0, 1e-6);
  Track skewed = pastTrack("a", kCarSize, {0.0, 0.0, 0.2}, 5.0);
  const double speed = 5.0;
  EXPECT_NEAR(stateAt(predicted(skewed, twoLaneRoad()), kNow + 3.0)->pose.yaw,
              0.2 * std::exp(-3.0 * speed / 15.0), 1e-6);
}

TEST(PredictFuture, FollowsLanesFromOneToTheNext) {
  auto map = emptyMap();
  map->lanes = {straightLane("a", {0.0, 0.0}, {20.0, 0.0}, {"left", "on"}),
                straightLane("left", {20.0, 0.0}, {20.0, 50.0}),
                straightLane("on", {20.0, 0.0}, {68.0, -14.0})};
  const Track track = predicted(pastTrack("a", kCarSize, {10.0, 0.0, 0.0}, 10.0), map);
  expectPose(stateAt(track, kNow + 5.0)->pose,
             {20.0 + 40.0 * 0.96, -40.0 * 0.28, std::atan2(-14.0, 48.0)}, 1e-3);
}

TEST(PredictFuture, KeepsTheVelocityOfVehiclesOnNoLane) {
  for (const Pose2& pose : {Pose2{0.0, 10.0, 0.3}, Pose2{0.0, 0.0, M_PI_2}}) {
    const Track track = predicted(pastTrack("a", kCarSize, pose, 6.0), twoLaneRoad());
    expectPose(stateAt(track, kNow + 5.0)->pose, compose(pose, {30.0, 0.0, 0.0}), 1e-6);
  }
}

TEST(PredictFuture, LeavesStandingVehiclesWhereTheyAre) {
  const Track track = predicted(pastTrack("a", kCarSize, {0.0, 1.0, 0.1}, 0.4), twoLaneRoad());
  for (const AgentState& state : track.states) {
    expectPose(state.pose, {0.0, 1.0, 0.1}, 1e-9);
    EXPECT_EQ(state.velocity, Vector2(0.0, 0.0));
  }
}

TEST(PredictFuture, PredictsOnlyAgentsSeenAtNow) {
  Track gone = pastTrack("gone", kCarSize, {20.0, 0.0, 0.0}, 5.0);
  gone.states.pop_back();
  const Track here = pastTrack("here", kCarSize, {40.0, 0.0, 0.0}, 5.0);
  const auto map = twoLaneRoad();
  const Track ego = pastTrack(kEgoId, kEgoSize, {}, 10.0);
  const Future future = predictFuture(snapshotOf(ego, {gone, here}, map), LaneIndex(map), 4.0);
  ASSERT_EQ(future.agents.size(), 1u);
  EXPECT_EQ(future.agents[0].id, "here");
  EXPECT_EQ(future.ego.id, kEgoId);
  EXPECT_NEAR(stateAt(future.ego, kNow + 4.0)->pose.x, 40.0, 1e-6);
}

TEST(PredictFuture, StartsFromTheRecordedPoseBeforeAndBesideALanesVertices) {
  auto map = emptyMap();
  map->lanes = {straightLane("a", {0.0, 0.0}, {20.0, 0.0}, {"b"}),
                straightLane("b", {20.0, 0.0}, {40.0, 10.0})};
  for (const Pose2& pose : {Pose2{-1.5, 0.3, 0.0}, Pose2{19.0, 1.5, 0.1}, Pose2{21.5, 2.0, 0.4},
                            Pose2{5.0, -1.0, 0.1}}) {
    expectPose(predicted(pastTrack("a", kCarSize, pose, 5.0), map).states.front().pose, pose, 1e-3);
  }
}

}  // namespace
}  // namespace forge
