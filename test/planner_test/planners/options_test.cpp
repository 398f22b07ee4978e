#include "collision_forge/planner_test/planners/options.h"

#include <gtest/gtest.h>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const TrialOptions& planners() { return shippedConfig().planners; }

TEST(PlannerOptions, TheCarKeepsTheVehicleLimits) {
  const VehicleLimits& limits = shippedConfig().attack.verification.limits;
  EXPECT_EQ(planners().car.max_acceleration, limits.max_forward_acceleration);
  EXPECT_EQ(planners().car.max_braking, limits.max_braking);
  EXPECT_NEAR(planners().car.max_steering, M_PI / 3.0, 1e-4);  // nuPlan's
}

TEST(PlannerOptions, PdmPlansAsFarAheadAsPublished) {
  const PdmOptions& pdm = planners().pdm;
  EXPECT_EQ(pdm.step, planners().lqr.step);
  EXPECT_NEAR(pdm.step * pdm.proposal_steps, 4.0, 1e-9);
  EXPECT_NEAR(pdm.step * pdm.output_steps, 8.0, 1e-9);
  EXPECT_EQ(pdm.lateral_offsets.size() * pdm.speed_shares.size(), 15U);
}

TEST(PlannerOptions, PdmBrakesInAnEmergencyAsHardAsComfortAllows) {
  EXPECT_EQ(planners().pdm.emergency_brake.braking, planners().pdm.scoring.comfort.max_braking);
}

TEST(PlannerOptions, RuleBasedPlansFiveSecondsAhead) {
  EXPECT_NEAR(planners().rule_based.step * planners().rule_based.steps, 5.0, 1e-9);
}

TEST(PlannerOptions, RuleBasedMatchesLanesWithinTwentyDegrees) {
  EXPECT_NEAR(planners().rule_based.on_lane_heading, 20.0 * M_PI / 180.0, 1e-6);
}

TEST(PlannerOptions, TunedRuleBasedDiffersInItsFourParametersAlone) {
  RuleBasedOptions published = planners().rule_based;
  const RuleBasedOptions& tuned = planners().tuned_rule_based;
  EXPECT_GT(tuned.max_speed, published.max_speed);
  EXPECT_GT(tuned.max_acceleration, published.max_acceleration);
  EXPECT_LT(tuned.distance_weight, published.distance_weight);
  EXPECT_LT(tuned.distance_weight_rate, published.distance_weight_rate);
  EXPECT_EQ(tuned.step, published.step);
  EXPECT_EQ(tuned.length_buffer, published.length_buffer);
  EXPECT_EQ(tuned.speed_shares, published.speed_shares);
}

}  // namespace
}  // namespace forge
