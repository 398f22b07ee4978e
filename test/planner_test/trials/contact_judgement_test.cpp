#include "collision_forge/planner_test/trials/contact_judgement.h"

#include <gtest/gtest.h>

#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

const FaultOptions& options() { return shippedConfig().planners.rollout.fault; }

constexpr double kAxleBehind = 1.385;  // m, from the middle of the ego's box

ContactSide side(const Pose2& pose, double speed) {
  return {{pose, kEgoSize}, speed * pose.heading()};
}

ContactCause causeOf(const ContactSide& ego, const ContactSide& other) {
  return forge::causeOf(ego, kAxleBehind, other, options());
}

TEST(ContactJudgement, ClassifiesCauses) {
  const double length = kEgoSize.length;
  const ContactSide ego = side({0.0, 0.0, 0.0}, 8.0);
  EXPECT_EQ(causeOf(side({0.0, 0.0, 0.0}, 0.0), side({length, 0.0, M_PI}, 8.0)),
            ContactCause::kStoppedEgo);
  EXPECT_EQ(causeOf(ego, side({length, 0.0, 0.0}, 0.0)), ContactCause::kStoppedOther);
  EXPECT_EQ(causeOf(ego, side({-length, 0.0, 0.0}, 12.0)), ContactCause::kRear);
  EXPECT_EQ(causeOf(ego, side({length, 0.0, 0.0}, 4.0)), ContactCause::kFront);
  EXPECT_EQ(causeOf(ego, side({-1.0, kEgoSize.width, 0.0}, 8.0)), ContactCause::kLateral);
}

std::shared_ptr<LaneMap> outlinedRoad() {
  auto map = twoLaneRoad();
  map->lanes[0].polygon = rectangle(-200.0, -1.75, 200.0, 1.75).exterior;
  map->lanes[1].polygon = rectangle(-200.0, 1.75, 200.0, 5.25).exterior;
  return map;
}

TEST(ContactJudgement, BlamesALateralContactInSeveralLanesOrOffTheRoad) {
  const LaneIndex lanes(outlinedRoad());
  const auto blamed = [&](double y) {
    return isAtFault(ContactCause::kLateral, {{0.0, y, 0.0}, kEgoSize}, lanes, options());
  };
  EXPECT_FALSE(blamed(0.0));
  EXPECT_TRUE(blamed(1.75));  // between the lanes
  EXPECT_FALSE(blamed(3.5));
  EXPECT_TRUE(blamed(-1.2));  // a fifth off the road
}

TEST(ContactJudgement, ALaneAndItsSuccessorCountAsOne) {
  auto map = outlinedRoad();
  map->lanes[0].polygon = rectangle(-200.0, -1.75, 0.0, 1.75).exterior;
  map->lanes.push_back(straightLane("on", {0.0, 0.0}, {200.0, 0.0}));
  map->lanes.back().polygon = rectangle(0.0, -1.75, 200.0, 1.75).exterior;
  const OrientedBox across{{0.0, 0.0, 0.0}, kEgoSize};
  EXPECT_TRUE(isInSeveralLanes(across, LaneIndex(map), 15.0));
  map->lanes[0].outgoing = {"on"};
  map->lanes.back().incoming = {map->lanes[0].id};
  EXPECT_FALSE(isInSeveralLanes(across, LaneIndex(map), 15.0));
  EXPECT_TRUE(isInSeveralLanes({{0.0, 1.75, 0.0}, kEgoSize}, LaneIndex(map), 15.0));
}

TEST(ContactJudgement, LanesWithoutOutlinesAreIgnored) {
  EXPECT_FALSE(isInSeveralLanes({{0.0, 1.75, 0.0}, kEgoSize}, LaneIndex(twoLaneRoad()), 15.0));
}

TEST(ContactJudgement, ReturnsTheTypeThatApplies) {
  const CrashDefinition crash = shippedCrash();
  Turning turning = Turning::kAttacker;
  Pose2 ego_now;
  const auto type = [&](const Pose2& other_now, const Pose2& other, CollisionType asked) {
    return typeOf({ego_now, other_now, {{}, kEgoSize}, {other, kEgoSize}}, asked, turning, crash,
                  DrivingSide::kRight);
  };
  const Pose2 behind{-4.0, 0.0, 0.0};
  EXPECT_EQ(type(behind, behind, CollisionType::kLtap), CollisionType::kRearEnd);
  const Pose2 oncoming{4.0, 0.0, M_PI};
  EXPECT_EQ(type(oncoming, oncoming, CollisionType::kOppositeDirection),
            CollisionType::kOppositeDirection);
  const Pose2 askew{4.0, 0.0, 2.5};
  EXPECT_EQ(type(oncoming, askew, CollisionType::kLtap), std::nullopt);
  turning = Turning::kEgo;
  EXPECT_EQ(type(oncoming, askew, CollisionType::kLtap), std::nullopt) << "the ego goes straight";
  ego_now.yaw = -0.6;
  EXPECT_EQ(type(askew, askew, CollisionType::kLtap), CollisionType::kLtap);
  ego_now.yaw = 0.0;
  turning = Turning::kAttacker;
  // Side to side at the same heading: neither from behind nor oncoming.
  EXPECT_EQ(type({0.0, 1.8, 0.0}, {0.0, 1.73, 0.0}, CollisionType::kRearEnd), std::nullopt);
}

TEST(ContactJudgement, DistinguishesLanesJunctionsAndElsewhere) {
  auto map = outlinedRoad();
  map->lanes[0].polygon = rectangle(-200.0, -1.75, 0.0, 1.75).exterior;
  map->lanes.push_back(straightLane("through", {0.0, 0.0}, {20.0, 0.0}));
  map->lanes.back().is_connector = true;
  const LaneIndex lanes(map);
  EXPECT_EQ(placeOf({-1.0, 0.0}, lanes, 15.0), ContactPlace::kLane) << "and near the junction";
  EXPECT_EQ(placeOf({10.0, 0.0}, lanes, 15.0), ContactPlace::kJunction);
  EXPECT_EQ(placeOf({10.0, 90.0}, lanes, 15.0), ContactPlace::kElsewhere);
  EXPECT_EQ(contactPlaceFromString("junction"), ContactPlace::kJunction);
  EXPECT_EQ(contactPlaceFromString("field"), std::nullopt);
}

}  // namespace
}  // namespace forge
