#include "attack/realizer.h"

#include <gtest/gtest.h>

#include "attack/limits.h"
#include "attack/placement.h"
#include "attack/quintic_join.h"
#include "attack/test_scenes.h"

namespace forge {
namespace {

/// A car behind the ego on a two-lane road, 4 s before it is to hit.
struct Case {
  AttackOptions options = shippedOptions();
  std::shared_ptr<LaneMap> map = twoLaneRoad();
  Snapshot snapshot;
  Future future;
  CollisionRequest request;
  CollisionPattern pattern;

  explicit Case(double distance = 20.0) {
    snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                          {pastTrack("attacker", kCarSize, {-distance, 0.5, 0.0}, 12.0)}, map);
    future.ego = futureTrack(kEgoId, kEgoSize, {}, 10.0);
    pattern.attacker_id = "attacker";
    pattern.time = kNow + request.tta;
    pattern.ego = {{40.0, 0.0, 0.0}, kEgoSize};
    pattern.attacker_offset = attackerOffset(kEgoSize, kCarSize, Side::kRear, 0.0, 0.0, 0.0);
    pattern.attacker_speed = 14.0;
  }
  Realization result() const {
    return realize({pattern}, {snapshot, future, request, LaneIndex(map)}, options);
  }
};

TEST(Realize, ReturnsAVerifiedAttackWithItsPatternAndConfidence) {
  const Realization result = Case().result();
  ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
  EXPECT_TRUE(result.report.verified());
  EXPECT_EQ(result.trajectory.attacker_id, "attacker");
  EXPECT_EQ(result.pattern.attacker_id, "attacker");
  EXPECT_EQ(result.pattern.time, kNow + 4.0);
  EXPECT_GT(result.report.confidence, 0.0);
  const TrajectoryPoint& impact = result.trajectory.points.at(40);
  const Pose2 target = compose(result.pattern.ego.center, result.pattern.attacker_offset);
  EXPECT_NEAR((impact.pose.position() - target.position()).norm(), 0.0, 1e-6);
  EXPECT_NEAR(impact.speed, result.pattern.attacker_speed, 1e-6);
}

TEST(Realize, WithOneSampleRealizesThePatternItselfAtTheDepth) {
  Case attack;
  attack.options.realization.samples = 1;
  const Realization result = attack.result();
  ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
  EXPECT_NEAR(result.pattern.attacker_offset.x, attack.pattern.attacker_offset.x + 0.15, 1e-6);
  EXPECT_EQ(result.pattern.attacker_offset.y, 0.0);
  EXPECT_EQ(result.pattern.attacker_speed, 14.0);
}

TEST(Realize, VariesThePatternWithinTheSpreads) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Case attack;
    attack.request.seed = seed;
    const Realization result = attack.result();
    ASSERT_EQ(result.status.code, StatusCode::kOk);
    EXPECT_LE(std::abs(result.pattern.attacker_offset.yaw), 0.1309);
    EXPECT_LE(std::abs(result.pattern.attacker_offset.y), 0.8 * 0.5 * kEgoSize.width);
    EXPECT_GE(result.pattern.attacker_speed, 0.1 * 14.0);
    EXPECT_LE(result.pattern.attacker_speed, 1.6 * 14.0);
  }
}

TEST(Realize, KeepsTheSideThatThePatternHits) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    Case attack;
    attack.request.type = attack.pattern.type = CollisionType::kLaneChange;
    attack.pattern.attacker_offset =
        attackerOffset(kEgoSize, kCarSize, side, signedHeading(side, 0.2618), 0.0, 0.0);
    const double lateral = side == Side::kLeft ? 3.5 : -3.5;
    attack.snapshot.agents[0] = pastTrack("attacker", kCarSize, {-8.0, lateral, 0.0}, 11.0);
    const Realization result = attack.result();
    ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
    EXPECT_GT(result.pattern.attacker_offset.y * lateral, 0.0);
    EXPECT_LT(result.report.relative_heading * lateral, 0.0) << "towards the ego";
  }
}

TEST(Realize, ComparingOneTakesTheLeastEffort) {
  Case attack;
  attack.options.realization.off_road_weight = 0.0;
  attack.options.realization.compared = 1;
  const auto effortOf = [&](const Realization& result) {
    return effort(result.trajectory, result.pattern.time, attack.options.vehicle_limits);
  };
  const Realization first = attack.result();
  ASSERT_EQ(first.status.code, StatusCode::kOk);
  attack.options.realization.compared = 96;
  EXPECT_EQ(effortOf(attack.result()), effortOf(first)) << "no better one exists";
  attack.options.realization.samples = 1;
  EXPECT_LE(effortOf(first), effortOf(attack.result()));
}

TEST(Realize, PrefersAttacksOnTheRoadAmongThoseCompared) {
  Case attack;
  attack.map->drivable_area = {rectangle(-200.0, -0.9, 200.0, 5.25)};
  attack.options.realization.compared = 96;
  attack.options.realization.off_road_weight = 0.0;
  const Realization careless = attack.result();
  attack.options.realization.off_road_weight = 100.0;
  const Realization careful = attack.result();
  ASSERT_EQ(careful.status.code, StatusCode::kOk);
  EXPECT_LT(careful.report.off_road_share, careless.report.off_road_share);
}

TEST(Realize, TakesTheBestOfSeveralPatterns) {
  Case attack;
  CollisionPattern hopeless = attack.pattern;
  hopeless.ego.center.x = 200.0;
  const VerificationInput input{attack.snapshot, attack.future, attack.request,
                                LaneIndex(attack.map)};
  const Realization result = realize({hopeless, attack.pattern}, input, attack.options);
  EXPECT_EQ(result.status.code, StatusCode::kOk);
  EXPECT_EQ(result.pattern.ego.center.x, 40.0);
}

TEST(Realize, RefusesWhatCannotBeDrivenAndCountsWhy) {
  const Realization result = Case(75.0).result();
  EXPECT_EQ(result.status.code, StatusCode::kNoAttackWithinBounds);
  EXPECT_NE(result.status.message.find("1 patterns"), std::string::npos) << result.status.message;
  EXPECT_NE(result.status.message.find("broke max_"), std::string::npos) << result.status.message;
}

TEST(Realize, RefusesWhatDoesNotVerifyAndCountsWhy) {
  const auto expect_refusal = [](const Case& attack, const std::string& reason) {
    const Realization result = attack.result();
    EXPECT_EQ(result.status.code, StatusCode::kNoAttackWithinBounds);
    EXPECT_NE(result.status.message.find(reason), std::string::npos) << result.status.message;
  };
  Case missing;
  missing.future.ego = futureTrack(kEgoId, kEgoSize, {0.0, 50.0, 0.0}, 10.0);
  expect_refusal(missing, "missed the ego");
  Case blocked;
  blocked.future.agents = {futureTrack("wall", {20.0, 20.0}, {15.0, 0.0, 0.0}, 0.0)};
  expect_refusal(blocked, "touched someone else first");
  Case late;
  late.request.tta = 6.0;
  expect_refusal(late, "made contact at the wrong time");
  Case wrong;
  wrong.request.type = CollisionType::kLtap;
  expect_refusal(wrong, "made contact at the wrong relative heading");
}

TEST(Realize, RefusesNoPatterns) {
  const Case attack;
  const VerificationInput input{attack.snapshot, attack.future, attack.request,
                                LaneIndex(attack.map)};
  EXPECT_EQ(realize({}, input, attack.options).status.code, StatusCode::kNoAttackWithinBounds);
}

}  // namespace
}  // namespace forge
