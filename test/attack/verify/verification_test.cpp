#include "collision_forge/attack/verify/verification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

const double kAlong = 0.5 * (kEgoSize.length + kCarSize.length);  // m between middles, end to end
constexpr double kFine = 2e-4;                                    // s; a millimetre at 5 m/s

/// One attack to verify; the attacker's trajectory is straightDrive().
struct Case {
  AttackOptions options = shippedOptions();
  std::shared_ptr<LaneMap> map = emptyMap();
  Snapshot snapshot;
  Future future;
  CollisionRequest request = requestFor();
  AttackerTrajectory trajectory;

  Case(const Pose2& ego, double ego_speed, const Pose2& attacker, double attacker_speed) {
    snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, ego, ego_speed),
                          {pastTrack("attacker", kCarSize, attacker, attacker_speed)}, map);
    future.ego = futureTrack(kEgoId, kEgoSize, ego, ego_speed);
    trajectory = straightDrive(attacker, attacker_speed, 8.0);
  }
  CollisionReport report() const {
    return verify(trajectory, {snapshot, future, request, LaneIndex(map)}, options.verification);
  }
  void addStanding(const std::string& id, const Pose2& pose) {
    future.agents.push_back(futureTrack(id, kCarSize, pose, 0.0));
  }
};

/// The attacker runs into the ego's rear at kNow + 4 s: 20 m apart, closing at 5 m/s.
Case rearEnd() { return {{20.0 + kAlong, 0.0, 0.0}, 10.0, {}, 15.0}; }

/// The middles meet at kNow + 4 s, the attacker turned by `heading` against the ego.
Case meeting(double ego_yaw, double heading) {
  const Pose2 ego{0.0, 0.0, ego_yaw};
  const Pose2 meet = compose(ego, {40.0, 0.0, heading});
  return {ego, 10.0, compose(meet, {-40.0, 0.0, 0.0}), 10.0};
}

TEST(Verify, FindsARearEndContactWhenTheGapIsClosed) {
  const CollisionReport report = rearEnd().report();
  EXPECT_TRUE(report.verified());
  EXPECT_NEAR(report.contact_time, kNow + 4.0, kFine);
  EXPECT_NEAR(report.ego_at_contact.x, 60.0 + kAlong, 10.0 * kFine);
  EXPECT_NEAR(report.attacker_at_contact.x, 60.0, 15.0 * kFine);
  EXPECT_NEAR(report.impact_speed, 5.0, 1e-9);
  EXPECT_EQ(report.ego_side, Side::kRear);
  EXPECT_EQ(report.attacker_side, Side::kFront);
  EXPECT_NEAR(report.relative_heading, 0.0, 1e-12);
  EXPECT_EQ(report.confidence, 0.0);
}

TEST(Verify, FindsAContactThatEndsBetweenSamples) {
  // Closing at 40 m/s with samples 40 m apart: at none of them do the boxes overlap.
  Case attack({}, 20.0, {60.0, 0.0, M_PI}, 20.0);
  attack.trajectory = straightDrive({60.0, 0.0, M_PI}, 20.0, 6.0, 1.0);
  attack.future.ego = straightTrack(kEgoId, kEgoSize, {}, 20.0, kNow, kNow, kNow + 6.0, 1.0);
  const CollisionReport report = attack.report();
  EXPECT_TRUE(report.contact);
  EXPECT_NEAR(report.contact_time, kNow + (60.0 - kAlong) / 40.0, kFine);
}

TEST(Verify, FollowsEveryBendOfTheEgosTrackBetweenTheAttackersSamples) {
  Case attack({}, 0.0, {}, 0.0);
  attack.trajectory = straightDrive({}, 0.0, 2.0, 1.0);
  attack.future.ego.states = {{kNow, {0.0, 20.0, 0.0}, Vector2::Zero()},
                              {kNow + 0.5, {0.0, 0.0, 0.0}, Vector2::Zero()},
                              {kNow + 1.0, {0.0, 20.0, 0.0}, Vector2::Zero()}};
  const double beside = 0.5 * (kEgoSize.width + kCarSize.width);
  EXPECT_TRUE(attack.report().contact);
  EXPECT_NEAR(attack.report().contact_time, kNow + (20.0 - beside) / 40.0, kFine);
}

TEST(Verify, ImpactSpeedIsThatAtTheContactOfABrakingAttacker) {
  // Braking at 5 m/s2 from 20 m/s towards a standing ego 30 m ahead: contact at 10 m/s.
  Case attack({30.0 + kAlong, 0.0, 0.0}, 0.0, {}, 20.0);
  attack.trajectory = straightDrive({}, 20.0, 4.0, 0.3);
  for (TrajectoryPoint& point : attack.trajectory.points) {
    const double t = point.time - kNow;
    point.pose.x = 20.0 * t - 2.5 * t * t;
    point.speed = 20.0 - 5.0 * t;
    point.acceleration = -5.0;
  }
  const CollisionReport report = attack.report();
  EXPECT_NEAR(report.contact_time, kNow + 2.0, 0.01);
  EXPECT_NEAR(report.impact_speed, 10.0, 0.1);
}

TEST(Verify, TypeIsKeptWithinTheBandOnBothSides) {
  for (const auto& [type, band] : shippedCrash().types) {
    for (const double sign : {1.0, -1.0}) {
      for (const double edge : {band.min_heading, band.max_heading}) {
        if (edge == 0.0 || edge > 3.1) continue;
        const double inwards = edge == band.min_heading ? 1e-4 : -1e-4;
        Case inside = meeting(0.4, sign * (edge + inwards));
        Case outside = meeting(0.4, sign * (edge - inwards));
        inside.request.type = outside.request.type = type;
        for (Case* attack : {&inside, &outside}) attack->request.crash.rules = TypeRules::kAngle;
        EXPECT_TRUE(inside.report().type_kept) << toString(type) << " " << edge;
        EXPECT_FALSE(outside.report().type_kept) << toString(type) << " " << edge;
        EXPECT_FALSE(outside.report().verified());
      }
    }
  }
  Case opposite = meeting(0.4, M_PI);
  opposite.request.type = CollisionType::kOppositeDirection;
  EXPECT_TRUE(opposite.report().type_kept);
}

TEST(Verify, TypeIsKeptIfTheApproachFits) {
  for (const double sign : {1.0, -1.0}) {
    Case attack = meeting(3.0, sign * M_PI_2);
    attack.request.type = CollisionType::kJunctionCrossing;
    TypeDefinition& type = attack.request.crash.types[CollisionType::kJunctionCrossing];
    EXPECT_TRUE(attack.report().type_kept);
    for (const auto& [min, max, kept] :
         std::vector<std::tuple<double, double, bool>>{{M_PI_2 - 1e-3, M_PI, true},
                                                       {M_PI_2 + 1e-3, M_PI, false},
                                                       {0.0, M_PI_2 + 1e-3, true},
                                                       {0.0, M_PI_2 - 1e-3, false}}) {
      type.min_approach = min;
      type.max_approach = max;
      EXPECT_EQ(attack.report().type_kept, kept) << min << " to " << max;
    }
    attack.request.type = CollisionType::kLtap;
    EXPECT_FALSE(attack.report().type_kept) << "from the side";
    attack.trajectory.points.front().pose.yaw = wrapAngle(3.0 + sign * 3.0);
    attack.map->driving_side = sign < 0.0 ? DrivingSide::kRight : DrivingSide::kLeft;
    EXPECT_TRUE(attack.report().type_kept) << "headed the opposite way now";
  }
}

TEST(Verify, TheEgoOfAnLtapMustTurnIfItIsTheTurningVehicle) {
  Case attack = meeting(0.0, 2.2);
  attack.request.type = CollisionType::kLtap;
  attack.request.turning = Turning::kEgo;
  attack.map->driving_side = DrivingSide::kRight;
  TypeDefinition& band = attack.request.crash.ltap_ego_turns;
  band.min_approach = 2.0;
  EXPECT_FALSE(attack.report().type_kept) << "the ego goes straight on";
  attack.future.ego.states.front().pose.yaw = -0.3;
  EXPECT_TRUE(attack.report().type_kept);
  attack.map->driving_side = DrivingSide::kLeft;
  EXPECT_FALSE(attack.report().type_kept);
}

TEST(Verify, WithAngleRulesOnlyTheHeadingAtContactDecidesTheType) {
  Case crossing = meeting(0.0, M_PI_2);
  crossing.request.type = CollisionType::kLtap;
  EXPECT_FALSE(crossing.report().type_kept) << "it comes from the side";
  crossing.request.crash.rules = TypeRules::kAngle;
  EXPECT_TRUE(crossing.report().type_kept);
  crossing.request.type = CollisionType::kLaneChange;
  EXPECT_FALSE(crossing.report().type_kept);
}

TEST(Verify, IsOnTimeWithinTheToleranceOnBothSides) {
  Case attack = rearEnd();
  for (const auto& [tta, on_time] : std::vector<std::pair<double, bool>>{
           {4.0, true}, {4.495, true}, {4.505, false}, {3.505, true}, {3.495, false}}) {
    attack.request.tta = tta;
    EXPECT_EQ(attack.report().on_time, on_time) << tta;
    EXPECT_EQ(attack.report().verified(), on_time) << tta;
    EXPECT_TRUE(attack.report().contact);
  }
}

TEST(Verify, NamesTheFirstAgentTouchedBeforeTheEgo) {
  Case attack = rearEnd();
  attack.addStanding("second", {40.0, 1.0, 0.0});
  attack.addStanding("first", {30.0, 1.0, 0.0});
  attack.addStanding("aside", {20.0, 5.0, 0.0});
  const CollisionReport report = attack.report();
  EXPECT_TRUE(report.contact);
  EXPECT_EQ(report.first_other_id, "first");
  EXPECT_NEAR(report.first_other_time, kNow + (30.0 - kCarSize.length) / 15.0, kFine);
  EXPECT_FALSE(report.verified());
}

TEST(Verify, NamesTheSmallestIdOfAgentsTouchedAtOnce) {
  Case attack = rearEnd();
  for (const char* id : {"b", "a", "c"}) attack.addStanding(id, {1.0, 0.0, 0.0});
  const CollisionReport report = attack.report();
  EXPECT_EQ(report.first_other_id, "a");
  EXPECT_NEAR(report.first_other_time, kNow, kFine);
}

TEST(Verify, IgnoresAgentsTouchedAfterTheEgo) {
  Case attack = rearEnd();
  attack.addStanding("late", {60.0 + kCarSize.length + 0.2, 1.0, 0.0});
  EXPECT_EQ(attack.report().first_other_id, "");
  EXPECT_TRUE(attack.report().verified());
  attack.future.agents.clear();
  attack.addStanding("early", {60.0 + kCarSize.length - 0.2, 1.0, 0.0});
  EXPECT_EQ(attack.report().first_other_id, "early");
}

TEST(Verify, IgnoresTheAttackersOwnTrack) {
  Case attack = rearEnd();
  attack.future.agents = {futureTrack("attacker", kCarSize, {}, 15.0)};
  EXPECT_TRUE(attack.report().verified());
}

TEST(Verify, TouchingAtNowIsNoContactAfterNow) {
  Case attack({kAlong - 0.5, 0.0, 0.0}, 10.0, {}, 10.0);
  EXPECT_FALSE(attack.report().contact);
  EXPECT_FALSE(attack.report().type_kept);
  EXPECT_FALSE(attack.report().verified());
  EXPECT_TRUE(Case({kAlong + 0.5, 0.0, 0.0}, 10.0, {}, 11.0).report().contact);
}

TEST(Verify, FindsNoContactWithinAGapOfTheEgosTrack) {
  Case attack({}, 0.0, {0.0, -40.0, M_PI_2}, 10.0);
  auto& states = attack.future.ego.states;
  EXPECT_TRUE(attack.report().contact);
  // The attacker is there from 3.7 to 4.3 s; the ego is known up to 3.5 s and from 5 s on.
  states.erase(states.begin() + 8, states.begin() + 10);
  EXPECT_FALSE(attack.report().contact);
}

TEST(Verify, FindsNoContactWithAbsentAgents) {
  Case attack = rearEnd();
  attack.addStanding("other", {30.0, 1.0, 0.0});
  Track& other = attack.future.agents[0];
  const Track whole = other;
  other.states.resize(4);  // up to 1.5 s; the attacker comes at 1.69 s and leaves at 2.31 s
  EXPECT_EQ(attack.report().first_other_id, "");
  other.states = {whole.states.begin() + 5, whole.states.end()};  // from 2.5 s on
  EXPECT_EQ(attack.report().first_other_id, "");
  other.states = {whole.states.begin() + 4, whole.states.end()};  // from 2 s on, on top of it
  EXPECT_EQ(attack.report().first_other_id, "other");
  EXPECT_NEAR(attack.report().first_other_time, kNow + 2.0, kFine);
  other.states.clear();
  EXPECT_TRUE(attack.report().verified());
}

TEST(Verify, FindsAContactWithAnAgentOfOneState) {
  Case attack = rearEnd();
  attack.addStanding("other", {30.0, 1.0, 0.0});
  Track& other = attack.future.agents[0];
  const Track whole = other;
  other.states = {whole.states[4]};  // at 2 s, when the attacker is on top of it
  EXPECT_EQ(attack.report().first_other_id, "other");
  EXPECT_NEAR(attack.report().first_other_time, kNow + 2.0, kFine);
  other.states = {whole.states[0], whole.states[4], whole.states[8]};  // with gaps between
  EXPECT_EQ(attack.report().first_other_id, "other");
  other.states = {whole.states[3]};  // 1.5 s: it comes later
  EXPECT_EQ(attack.report().first_other_id, "");
}

TEST(Verify, FindsAContactInTheLastInstantOfATrack) {
  // Gap and closing speed are exact, so contact is at the very end of the ego's last piece. For
  // some of these times begin + (end - begin) is after the end in floating point.
  for (const double begin : {-0.2, 0.1, 0.3, 100.3}) {
    for (double end = begin + 0.6; end < begin + 0.9; end += 0.001) {
      Case attack({10.0, 0.0, 0.0}, 0.0, {}, 0.0);
      attack.future.ego.size = attack.trajectory.size = {4.0, 2.0};
      attack.future.ego.states = {{begin, {10.0, 0.0, 0.0}, Vector2::Zero()},
                                  {end, {10.0, 0.0, 0.0}, Vector2::Zero()}};
      attack.trajectory.points = {{begin, {4.0, 0.0, 0.0}, 10.0, 0.0, 0.0},
                                  {end, {6.0, 0.0, 0.0}, 10.0, 0.0, 0.0},
                                  {end + 1.0, {14.0, 0.0, 0.0}, 10.0, 0.0, 0.0}};
      const CollisionReport report = attack.report();
      ASSERT_TRUE(report.contact) << begin << " to " << end;
      ASSERT_LE(report.contact_time, end) << "the ego's track has no state after its end";
      ASSERT_EQ(report.ego_at_contact.x, 10.0) << begin << " to " << end;
    }
  }
}

TEST(Verify, ChecksLimitsUpToTheContact) {
  Case attack = rearEnd();
  attack.trajectory.points[50].acceleration = 9.0;
  EXPECT_TRUE(attack.report().limits_kept);
  attack.trajectory.points[20].acceleration = 6.0;
  const CollisionReport report = attack.report();
  EXPECT_FALSE(report.limits_kept);
  EXPECT_EQ(report.broken_limit, "max_forward_acceleration 6.000 > 5.000");
  EXPECT_FALSE(report.verified());
}

TEST(Verify, ChecksTheFirstHeadingAgainstTheRecordedOne) {
  Case attack = rearEnd();
  attack.snapshot.agents[0].states.back().pose.yaw = 0.3;
  EXPECT_FALSE(attack.report().limits_kept);
  attack.snapshot.agents.clear();
  EXPECT_TRUE(attack.report().limits_kept);
}

TEST(Verify, OffRoadShareIsTheMeanFromNowToTheContact) {
  Case attack({80.0, 0.0, 0.0}, 0.0, {}, 10.0);
  attack.future.ego.size = {2.0, 2.0};
  attack.trajectory.size = {4.0, 2.0};
  // Contact at x = 77; fully on up to x = 38, off from 42 on, a quarter a metre between.
  attack.map->drivable_area = {rectangle(-100.0, -10.0, 40.0, 10.0)};
  const CollisionReport report = attack.report();
  EXPECT_NEAR(report.contact_time, kNow + 7.7, kFine);
  EXPECT_NEAR(report.off_road_share, (0.25 + 0.5 + 0.75 + 35.0) / 77.0, 0.01);
  attack.map->drivable_area = {rectangle(-100.0, -10.0, 100.0, 10.0)};
  EXPECT_EQ(attack.report().off_road_share, 0.0);
  attack.map->drivable_area.clear();
  EXPECT_EQ(attack.report().off_road_share, 0.0) << "unknown ground is no fault";
}

}  // namespace
}  // namespace forge
