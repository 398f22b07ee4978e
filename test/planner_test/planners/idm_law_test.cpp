#include "collision_forge/planner_test/planners/idm_law.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

constexpr IdmParameters kIdm{10.0, 1.5, 1.0, 3.0, 1.0, 4.0};

TEST(IdmLaw, AStandingCarOnAFreeRoadAcceleratesFully) {
  EXPECT_DOUBLE_EQ(idmFreeAcceleration(kIdm, 0.0), 1.0);
}

TEST(IdmLaw, TheDesiredSpeedIsHeldOnAFreeRoad) {
  EXPECT_DOUBLE_EQ(idmFreeAcceleration(kIdm, 10.0), 0.0);
  EXPECT_DOUBLE_EQ(idmFreeAcceleration(kIdm, 5.0), 1.0 - 1.0 / 16.0);
}

TEST(IdmLaw, AtTheEquilibriumGapTheLeadsSpeedIsHeld) {
  // (s0 + v T)^2 / gap^2 = 1 - (v / v0)^4 at v = 5 m/s: gap = 8.5 / sqrt(15 / 16).
  EXPECT_NEAR(idmAcceleration(kIdm, 5.0, 5.0, 8.5 / std::sqrt(15.0 / 16.0)), 0.0, 1e-12);
  EXPECT_LT(idmAcceleration(kIdm, 5.0, 5.0, 8.0), 0.0);
}

TEST(IdmLaw, ClosingOnTheLeadBrakes) {
  // s* = 1 + 6 + 4 * 4 / (2 sqrt 3); a = 1 - 0.4^4 - (s*/10)^2.
  const double desired_gap = 7.0 + 16.0 / (2.0 * std::sqrt(3.0));
  EXPECT_NEAR(idmAcceleration(kIdm, 4.0, 0.0, 10.0),
              1.0 - 0.0256 - desired_gap * desired_gap / 100.0, 1e-12);
}

TEST(IdmLaw, ALeadThatGetsAwayFastBrakesNobody) {
  // s* = 1 + 3 - 2 * 28 / (2 sqrt 3) is negative.
  EXPECT_DOUBLE_EQ(idmAcceleration(kIdm, 2.0, 30.0, 5.0), idmFreeAcceleration(kIdm, 2.0));
}

TEST(IdmLaw, ThePlainLawBrakesBehindSuchALead) {
  const double desired = 4.0 - 2.0 * 28.0 / (2.0 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(plainIdmAcceleration(kIdm, 2.0, 30.0, 5.0),
                   idmFreeAcceleration(kIdm, 2.0) - desired * desired / 25.0);
}

TEST(IdmLaw, NoGapIsLessThanTheLeastOne) {
  EXPECT_EQ(nuplanIdmAcceleration(kIdm, 2.0, {-3.0, 1.0}),
            plainIdmAcceleration(kIdm, 2.0, 1.0, kIdm.min_gap));
}

TEST(IdmLaw, AStepOfEulersKeepsToTheAccelerations) {
  const IdmState braked = eulerStep(kIdm, {7.0, 5.0}, {1.0, 0.0}, 0.5);
  EXPECT_DOUBLE_EQ(braked.progress, 9.5);
  EXPECT_DOUBLE_EQ(braked.speed, 5.0 - 0.5 * kIdm.braking);
  EXPECT_LT(eulerStep(kIdm, {0.0, 1.0}, {1.0, 0.0}, 0.5).speed, 0.0);
  IdmParameters idm = kIdm;
  idm.desired_speed = 3.0;
  EXPECT_NEAR(eulerStep(idm, {0.0, 15.0}, {500.0, 0.0}, 0.1).speed, 15.0 - 0.1 * idm.braking, 1e-9);
  idm.desired_speed = 100.0;
  EXPECT_NEAR(eulerStep(idm, {0.0, 0.0}, {9000.0, 0.0}, 0.1).speed, 0.1 * idm.max_acceleration,
              1e-4);
}

}  // namespace
}  // namespace forge
