#include "collision_forge/attack/search/baselines.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {
namespace {

/// The ego at 10 m/s; one car closes in from behind by 5 m/s and touches it in `tta`, one stands.
Moment closingIn(double tta) {
  const double gap = 5.0 * tta + 0.5 * (kEgoSize.length + kCarSize.length);
  const auto map = twoLaneRoad();
  return {snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                     {pastTrack("standing", kCarSize, {-30.0, 5.0, 0.0}, 0.0),
                      pastTrack("closing", kCarSize, {-gap, 0.0, 0.0}, 15.0)},
                     map),
          std::nullopt, std::make_shared<const LaneIndex>(map)};
}

TEST(Baselines, ConstantVelocityTakesTheCandidateThatTouches) {
  const Realization answer =
      ConstantVelocityMethod(shippedOptions()).answer(closingIn(4.0), requestFor());
  ASSERT_EQ(answer.status.code, StatusCode::kOk);
  EXPECT_EQ(answer.trajectory.attacker_id, "closing");
  EXPECT_TRUE(answer.report.verified());
  EXPECT_NEAR(answer.report.contact_time, kNow + 4.0, 1e-2);
}

TEST(Baselines, ReportsUseTheStrictLimitsWhateverTheRequestSays) {
  // The car behind changes only its speed, by a quintic, which slips.
  const auto drivable = believableRequestFor(CollisionType::kLaneChange);
  const auto strict = requestFor(CollisionType::kLaneChange);
  const Moment moment = closingIn(4.0);
  const Realization answer = NominalMethod(shippedOptions()).answer(moment, drivable);
  ASSERT_EQ(answer.status.code, StatusCode::kOk);
  const CollisionReport same = NominalMethod(shippedOptions()).answer(moment, strict).report;
  EXPECT_EQ(answer.report.limits_kept, same.limits_kept);
  EXPECT_EQ(answer.report.broken_limit, same.broken_limit);
  const Future expected =
      predictFuture(moment.snapshot, *moment.lanes, 6.0, shippedOptions().prediction);
  const CollisionReport by_class =
      verifyDrive(answer.trajectory, {moment.snapshot, expected, drivable, *moment.lanes},
                  shippedOptions().verification);
  EXPECT_NE(by_class.broken_limit, answer.report.broken_limit);
}

TEST(Baselines, UseTheRequestedAttacker) {
  CollisionRequest request = requestFor();
  request.attacker = "standing";
  for (const Realization& answer :
       {ConstantVelocityMethod(shippedOptions()).answer(closingIn(4.0), request),
        NominalMethod(shippedOptions()).answer(closingIn(4.0), request)}) {
    EXPECT_EQ(answer.trajectory.attacker_id, "standing");
  }
}

TEST(Baselines, ConsiderOnlyVehiclesOfTheRequestedClass) {
  Moment moment = closingIn(4.0);
  CollisionRequest request = requestFor();
  request.attacker_class = AgentClass::kTruck;
  EXPECT_EQ(ConstantVelocityMethod(shippedOptions()).answer(moment, request).status.code,
            StatusCode::kNoCandidate);
  moment.snapshot.agents[0].agent_class = AgentClass::kTruck;
  EXPECT_EQ(ConstantVelocityMethod(shippedOptions()).answer(moment, request).trajectory.attacker_id,
            "standing");
}

TEST(Baselines, RejectARequestWithoutCandidates) {
  Moment alone = closingIn(4.0);
  alone.snapshot.agents.clear();
  EXPECT_EQ(NominalMethod(shippedOptions()).answer(alone, requestFor()).status.code,
            StatusCode::kNoCandidate);
}

TEST(Baselines, OneQuinticEndsAtTheLikeliestPattern) {
  const AttackOptions options = shippedOptions();
  const auto predictor = std::make_shared<KinematicPatternPredictor>(kinematicPredictor(options));
  const Moment moment = closingIn(4.0);
  const CollisionRequest request = requestFor();
  const Realization answer = PatternQuinticMethod(options, predictor).answer(moment, request);
  const CollisionPattern pattern =
      predictor->predict(moment.snapshot, *moment.lanes, request, nullptr).patterns.front();
  const Pose2 wanted = compose(pattern.ego.center, pattern.attacker_offset);
  const Pose2 reached = poseAt(answer.trajectory, kNow + request.tta);
  EXPECT_NEAR((wanted.position() - reached.position()).norm(), 0.0, 1e-6);
}

}  // namespace
}  // namespace forge
