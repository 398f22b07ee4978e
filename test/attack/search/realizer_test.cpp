#include "collision_forge/attack/search/realizer.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "attack/search/test_scenes.h"

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/attack/verify/limits.h"

namespace forge {
namespace {

/// A car behind the ego on a two-lane road, 4 s before it is to hit. The ego is known.
struct Case {
  AttackOptions options = shippedOptions();
  std::shared_ptr<LaneMap> map = twoLaneRoad();
  Snapshot snapshot;
  Future future;
  CollisionRequest request = requestFor();
  CollisionPattern pattern;
  bool exact = false;

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
  /// Makes the ego's future uncertain: one sample for each speed.
  void sampleEgo(const std::vector<double>& speeds) {
    for (const double speed : speeds) {
      future.ego_samples.push_back(futureTrack(kEgoId, kEgoSize, {}, speed));
    }
  }
  Realization result() const {
    return realize({{pattern}, {snapshot, future, request, LaneIndex(map)}, exact}, options);
  }
  void expectRefusal(StatusCode code, const std::string& reason) const {
    const Status status = result().status;
    EXPECT_STREQ(toString(status.code), toString(code));
    EXPECT_NE(status.message.find(reason), std::string::npos) << status.message;
  }
};

TEST(Realize, ReturnsAVerifiedAttackThatHoldsWhenVerifiedAgain) {
  const Case attack;
  const Realization result = attack.result();
  ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
  EXPECT_EQ(result.status.message, "");
  EXPECT_EQ(result.trajectory.attacker_id, "attacker");
  EXPECT_EQ(result.trajectory.size.length, kCarSize.length);
  const CollisionReport again = verify(
      result.trajectory, {attack.snapshot, attack.future, attack.request, LaneIndex(attack.map)},
      attack.options.verification);
  EXPECT_TRUE(again.verified());
  EXPECT_EQ(again.contact_time, result.report.contact_time);
  EXPECT_EQ(again.off_road_share, result.report.off_road_share);
}

TEST(Realize, ReportsThePatternAndTheMissOfTheContact) {
  const Case attack;
  const Realization result = attack.result();
  ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
  EXPECT_EQ(result.aim.attacker_id, "attacker");
  EXPECT_EQ(result.aim.time, attack.pattern.time);
  EXPECT_EQ(result.aim.attacker_offset.x, attack.pattern.attacker_offset.x);
  const Pose2 met = relativeTo(result.report.ego_at_contact, result.report.attacker_at_contact);
  EXPECT_NEAR(result.miss.distance, std::hypot(met.x - result.aim.attacker_offset.x, met.y), 1e-9);
  EXPECT_NEAR(result.miss.heading, std::abs(met.yaw), 1e-9);
}

TEST(Realize, HitsTheEgoAtThePattern) {
  Case attack;
  for (const double slide : {-0.8, 0.0, 0.8}) {
    attack.pattern.attacker_offset =
        attackerOffset(kEgoSize, kCarSize, Side::kRear, 0.0, slide, 0.0);
    const Realization result = attack.result();
    ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
    EXPECT_LT(result.miss.distance, 0.2) << slide;
    EXPECT_EQ(result.report.ego_side, Side::kRear);
  }
}

TEST(Realize, ExactModeHitsTheRequestedPattern) {
  Case attack;
  attack.exact = true;
  attack.pattern.attacker_offset = attackerOffset(kEgoSize, kCarSize, Side::kRear, 0.1, 0.5, 0.0);
  const Realization result = attack.result();
  ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
  EXPECT_LE(result.miss.distance, kExactDistance);
  EXPECT_LE(result.miss.heading, kExactHeading);
}

TEST(Realize, ExactModeRejectsAnUnreachablePattern) {
  // From behind, no vehicle reaches the ego's front in time.
  Case attack;
  attack.pattern.attacker_offset = attackerOffset(kEgoSize, kCarSize, Side::kRear, 0.0, 0.0, 0.0);
  attack.pattern.attacker_offset.y += 30.0;
  EXPECT_EQ(attack.result().status.code, StatusCode::kOk) << "an attack there is";
  attack.exact = true;
  attack.expectRefusal(StatusCode::kNoAttackWithinLimits, "missed the pattern");
  EXPECT_TRUE(attack.result().trajectory.points.empty());
}

TEST(Realize, ConfidenceIsOneForAKnownEgo) {
  const Realization result = Case().result();
  ASSERT_EQ(result.status.code, StatusCode::kOk);
  EXPECT_EQ(result.report.confidence, 1.0);
}

TEST(Realize, ConfidenceIsTheShareOfHeldOutSamplesHit) {
  // The even samples are searched, the odd ones are held out.
  Case attack;
  attack.options.search.confidence_curve = {0.0, 1.0};
  attack.sampleEgo({10.0, 10.0, 10.0, 10.0, 10.0, 30.0, 10.0, 30.0});
  const Realization half = attack.result();
  ASSERT_EQ(half.status.code, StatusCode::kOk) << half.status.message;
  EXPECT_EQ(half.report.confidence, 0.5);
  attack.future.ego_samples.clear();
  attack.sampleEgo({10.0, 10.0, 30.0, 10.0, 30.0, 10.0, 30.0, 10.0});
  const Realization whole = attack.result();
  ASSERT_EQ(whole.status.code, StatusCode::kOk) << whole.status.message;
  EXPECT_EQ(whole.report.confidence, 1.0);
}

TEST(Realize, RejectsAnAttackOfTooLowConfidence) {
  Case attack;
  attack.options.search.confidence_curve = {0.0, 1.0};
  attack.sampleEgo({10.0, 10.0, 10.0, 30.0, 10.0, 30.0, 10.0, 30.0});
  attack.request.crash.min_confidence = 0.25;
  EXPECT_EQ(attack.result().status.code, StatusCode::kOk);
  attack.request.crash.min_confidence = 0.26;
  attack.expectRefusal(StatusCode::kLowConfidence, "min_confidence");
  EXPECT_TRUE(attack.result().trajectory.points.empty());
}

TEST(Realize, PrefersAnAttackOfHigherConfidence) {
  Case attack;
  attack.options.search.confidence_curve = {0.0, 1.0};
  attack.snapshot.agents.push_back(pastTrack("faster", kCarSize, {-14.0, 0.5, 0.0}, 16.0));
  CollisionPattern other = attack.pattern;
  other.attacker_id = "faster";
  other.ego.center.x = 56.0;
  other.attacker_speed = 18.0;
  attack.sampleEgo({10.0, 14.0, 14.0, 14.0, 10.0, 14.0, 14.0, 14.0});
  attack.request.crash.min_confidence = 0.5;
  const LaneIndex lanes(attack.map);
  const Realization result =
      realize({{attack.pattern, other}, {attack.snapshot, attack.future, attack.request, lanes}},
              attack.options);
  ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
  EXPECT_GE(result.report.confidence, 0.5);
}

TEST(Realize, ReportsTheFutureUsedForVerification) {
  Case attack;
  attack.future.ego = futureTrack(kEgoId, kEgoSize, {}, 30.0);
  attack.sampleEgo({8.0, 8.0, 8.0, 8.0});
  const Realization result = attack.result();
  ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
  EXPECT_NEAR(result.report.ego_at_contact.x, 8.0 * (result.report.contact_time - kNow), 1e-6);
}

TEST(Realize, UsesAnotherAttackerIfTheFirstCannotReach) {
  Case attack;
  attack.snapshot.agents.push_back(pastTrack("far", kCarSize, {-190.0, 0.0, 0.0}, 5.0));
  CollisionPattern hopeless = attack.pattern;
  hopeless.attacker_id = "far";
  const LaneIndex lanes(attack.map);
  const Realization result =
      realize({{hopeless, attack.pattern}, {attack.snapshot, attack.future, attack.request, lanes}},
              attack.options);
  ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
  EXPECT_EQ(result.trajectory.attacker_id, "attacker");
}

TEST(Realize, RejectsAPatternOutOfReach) {
  Case attack(190.0);
  attack.expectRefusal(StatusCode::kNoAttackWithinLimits,
                       "tried 1 candidate (1 vehicle): none hits the ego at 4 +- 0.5 s within its "
                       "limits");
}

TEST(Realize, RejectsWhenAnotherAgentBlocksThePath) {
  Case attack;
  attack.future.agents = {futureTrack("wall", {4.0, 80.0}, {-5.0, 0.0, 0.0}, 0.0)};
  attack.expectRefusal(StatusCode::kNoAttackWithinLimits, "(1 vehicle): ");
}

TEST(Realize, CountsWhyTheBestAttacksDoNotVerify) {
  // The wall is there between two steps of the search only, where verification alone looks.
  Case attack;
  const Pose2 somewhere{20.0, 0.0, 0.0};
  attack.future.agents = {
      {"wall",
       AgentClass::kStaticObject,
       {100.0, 20.0},
       {{kNow + 2.02, somewhere, Vector2::Zero()}, {kNow + 2.08, somewhere, Vector2::Zero()}}}};
  attack.expectRefusal(StatusCode::kNoAttackWithinLimits, "touched another agent first");
}

TEST(Realize, RejectsInvalidPatterns) {
  Case stranger;
  stranger.pattern.attacker_id = "nobody";
  EXPECT_THROW(stranger.result(), InputError);
  Case past;
  past.pattern.time = kNow;
  EXPECT_THROW(past.result(), InputError);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double CollisionPattern::*number :
       {&CollisionPattern::attacker_speed, &CollisionPattern::tolerance}) {
    Case broken;
    broken.pattern.*number = nan;
    EXPECT_THROW(broken.result(), InputError);
  }
  Case aside;
  aside.pattern.attacker_offset.y = nan;
  EXPECT_THROW(aside.result(), InputError);
  Case nowhere;
  nowhere.pattern.ego.center.yaw = nan;
  EXPECT_THROW(nowhere.result(), InputError);
  Case negative;
  negative.pattern.tolerance = -0.5;
  EXPECT_THROW(negative.result(), InputError);
}

TEST(ConfidenceOf, IsLinearBetweenThePointsOfTheCurve) {
  const std::vector<double> curve = {0.0, 0.2, 0.9};
  EXPECT_EQ(confidenceOf(0.0, curve), 0.0);
  EXPECT_NEAR(confidenceOf(0.25, curve), 0.1, 1e-12);
  EXPECT_NEAR(confidenceOf(0.5, curve), 0.2, 1e-12);
  EXPECT_NEAR(confidenceOf(0.75, curve), 0.55, 1e-12);
  EXPECT_NEAR(confidenceOf(1.0, curve), 0.9, 1e-12);
}

}  // namespace
}  // namespace forge
