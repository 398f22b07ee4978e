#include "collision_forge/attack/verify/options.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

const VehicleLimits kLimits = shippedOptions().verification.limits;

TEST(VehicleLimits, AreRealisticForACar) {
  EXPECT_NEAR(kLimits.max_forward_acceleration, 100.0 / 3.6 / 5.6, 0.05);  // 0-100 km/h in 5.6 s
  EXPECT_GT(kLimits.max_braking, 6.43);  // m/s2 that ECE R13-H requires
  EXPECT_LT(kLimits.max_braking, 9.0);   // m/s2, the best cars
  EXPECT_NEAR(kLimits.max_total_acceleration, 0.8 * 9.81, 0.2);
  EXPECT_NEAR(1.0 / kLimits.max_curvature, 5.0, 1e-9);
  EXPECT_NEAR(kLimits.max_speed, 90.0 / 3.6, 1e-9);
  EXPECT_NEAR(kLimits.heading_slack, 10.0 * M_PI / 180.0, 1e-4);
}

TEST(VehicleLimits, GripAllowsFullAccelerationAndBraking) {
  EXPECT_GE(kLimits.max_total_acceleration, kLimits.max_forward_acceleration);
  EXPECT_GE(kLimits.max_total_acceleration, kLimits.max_braking);
}

TEST(VerificationOptions, OverlapToleranceIsBelowTheSearchMargin) {
  EXPECT_LT(shippedOptions().verification.overlap_tolerance,
            shippedOptions().search.overlap_margin);
}

const BelievabilityOptions kBelievability = shippedBelievability();

TEST(BelievabilityOptions, AChangeOfLaneStaysOnALane) {
  const double lane_gap = 3.5;  // m, between the middles of neighbouring lanes
  EXPECT_GE(2.0 * kBelievability.lane_distance, lane_gap);
  const double parking_gap = 3.5;  // m, from a lane's middle to that of a parking place beside it
  EXPECT_LT(kBelievability.lane_distance, parking_gap);
}

TEST(BelievabilityOptions, AnOncomingLaneBesideTheEgosIsInReach) {
  const double lane_gap = 3.5;  // m
  const double ego_width = 1.73;
  EXPECT_GT(kBelievability.road_distance, lane_gap - 0.5 * ego_width);
}

TEST(BelievabilityOptions, AnglesAreRoundDegrees) {
  EXPECT_NEAR(kBelievability.lane_heading, 25.0 * M_PI / 180.0, 1e-4);
  EXPECT_NEAR(kBelievability.road_heading, 20.0 * M_PI / 180.0, 1e-4);
}

}  // namespace
}  // namespace forge
