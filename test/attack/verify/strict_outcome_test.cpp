#include "collision_forge/attack/verify/strict_outcome.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// A recorded attack without a map.
struct Case {
  AttackOptions options = shippedOptions();
  std::shared_ptr<LaneMap> map = emptyMap();
  Snapshot snapshot;
  Future recorded;
  CollisionRequest request = requestFor();
  AttackerTrajectory trajectory;

  StrictOutcome outcome() const {
    return strictOutcome(trajectory, {snapshot, recorded, request, LaneIndex(map)},
                         options.verification);
  }
};

/// Both at 10 m/s, the middles meet at now + 4 s, the attacker turned by `heading`.
Case meeting(CollisionType type, double heading) {
  Case c;
  const Pose2 meet = compose(Pose2{}, {40.0, 0.0, heading});
  const Pose2 attacker = compose(meet, {-40.0, 0.0, 0.0});
  c.snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                          {pastTrack("attacker", kCarSize, attacker, 10.0)}, c.map);
  c.recorded.ego = futureTrack(kEgoId, kEgoSize, {}, 10.0);
  c.trajectory = straightDrive(attacker, 10.0, 8.0);
  c.request.type = type;
  c.request.tta = 4.0;
  return c;
}

TEST(Strict, CrossingFromTheSideMeetsEverything) {
  const StrictOutcome outcome = meeting(CollisionType::kJunctionCrossing, M_PI_2).outcome();
  EXPECT_TRUE(outcome.report.contact);
  EXPECT_TRUE(outcome.report.type_kept);
  EXPECT_TRUE(outcome.report.on_time);
  EXPECT_TRUE(outcome.report.limits_kept);
  EXPECT_TRUE(outcome.report.first_other_id.empty());
  EXPECT_TRUE(outcome.meetsAngleBands());
  EXPECT_TRUE(outcome.meetsFullDefinitions());
}

TEST(Strict, ApproachCountsInTheFullDefinitionsOnly) {
  // A left turn across path comes from the opposite direction; this one from the side.
  const StrictOutcome outcome = meeting(CollisionType::kLtap, M_PI_2).outcome();
  EXPECT_TRUE(outcome.meetsAngleBands());
  EXPECT_TRUE(outcome.report.type_kept);
  EXPECT_FALSE(outcome.full_type_kept);
  EXPECT_FALSE(outcome.meetsFullDefinitions());
}

TEST(Strict, AContactMoreThanHalfASecondOffIsNotOnTime) {
  Case c = meeting(CollisionType::kJunctionCrossing, M_PI_2);
  const double contact = c.outcome().report.contact_time - kNow;
  for (const auto& [tta, on_time] : {std::pair(contact + 0.49, true),
                                     {contact + 0.51, false},
                                     {contact - 0.49, true},
                                     {contact - 0.51, false}}) {
    c.request.tta = tta;
    EXPECT_EQ(c.outcome().report.on_time, on_time) << tta;
    EXPECT_EQ(c.outcome().meetsAngleBands(), on_time) << tta;
  }
}

TEST(Strict, AnEarlierContactWithAnotherAgentFails) {
  Case c = meeting(CollisionType::kJunctionCrossing, M_PI_2);
  c.recorded.agents.push_back(futureTrack("wall", kCarSize, {40.0, -20.0, 0.0}, 0.0));
  const StrictOutcome outcome = c.outcome();
  EXPECT_TRUE(outcome.report.contact);
  EXPECT_EQ(outcome.report.first_other_id, "wall");
  EXPECT_FALSE(outcome.meetsAngleBands());
}

TEST(Strict, AViolatedLimitFails) {
  Case c = meeting(CollisionType::kJunctionCrossing, M_PI_2);
  c.trajectory.points[10].curvature = 0.21;
  const StrictOutcome outcome = c.outcome();
  EXPECT_FALSE(outcome.report.limits_kept);
  EXPECT_FALSE(outcome.meetsAngleBands());
  EXPECT_FALSE(outcome.meetsFullDefinitions());
}

TEST(Strict, UsesTheLimitsOfTheRequest) {
  // Faster than any row of the strict limits, and slower than cars may drive.
  Case c = meeting(CollisionType::kJunctionCrossing, M_PI_2);
  const double speed = 0.5 * (c.options.verification.limits.max_speed +
                              c.options.verification.drivable.rows[0].max_speed);
  const Pose2 attacker = compose(Pose2{40.0, 0.0, M_PI_2}, {-4.0 * speed, 0.0, 0.0});
  c.snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                          {pastTrack("attacker", kCarSize, attacker, speed)}, c.map);
  c.trajectory = straightDrive(attacker, speed, 8.0);
  EXPECT_FALSE(c.outcome().report.limits_kept);
  c.request.crash.limits = LimitSet::kDrivable;
  const StrictOutcome outcome = c.outcome();
  EXPECT_TRUE(outcome.report.limits_kept) << outcome.report.broken_limit;
}

TEST(Strict, BelievabilityCountsIfTheRequestRequiresIt) {
  Case c = meeting(CollisionType::kJunctionCrossing, M_PI_2);
  c.map = twoLaneRoad();  // along x, without a crossing lane
  StrictOutcome outcome = c.outcome();
  ASSERT_FALSE(outcome.report.believable());
  EXPECT_TRUE(outcome.meetsFullDefinitions());
  c.request.crash.believable = true;
  outcome = c.outcome();
  EXPECT_FALSE(outcome.meetsAngleBands());
  EXPECT_FALSE(outcome.meetsFullDefinitions());
}

TEST(Strict, AngleRulesChangeOnlyTheRules) {
  const CrashDefinition angle = rulesOfClips(shippedCrash());
  EXPECT_EQ(angle.rules, TypeRules::kAngle);
  EXPECT_EQ(angle.time_tolerance, shippedCrash().time_tolerance);
  EXPECT_EQ(shippedCrash().rules, TypeRules::kFull);
}

}  // namespace
}  // namespace forge
