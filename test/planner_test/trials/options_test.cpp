#include "collision_forge/planner_test/trials/options.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_forge/planner_test/planners/planner_factory.h"
#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const TrialOptions& trials() { return shippedConfig().planners; }

TEST(TrialOptions, PlannersAreCalledEveryFewStepsOfTheRollout) {
  for (const std::string& name : plannerNames()) {
    const double steps = makePlanner(name, trials(), "").driving.interval / trials().rollout.step;
    EXPECT_NEAR(steps, std::round(steps), 1e-9) << name;
    EXPECT_GE(std::round(steps), 1.0) << name;
  }
}

TEST(TrialOptions, AvoidanceTriesKeepingBrakingAcceleratingAndSteering) {
  const AvoidabilityOptions& options = trials().avoidability;
  const auto& accelerations = options.accelerations;
  EXPECT_EQ(accelerations.front(), 0.0);
  EXPECT_EQ(options.offsets.front(), 0.0);
  EXPECT_EQ(*std::max_element(accelerations.begin(), accelerations.end()),
            shippedConfig().attack.verification.limits.max_forward_acceleration);
  EXPECT_LT(*std::min_element(accelerations.begin(), accelerations.end()), -7.0);
  for (const double offset : options.offsets) {
    EXPECT_EQ(std::count(options.offsets.begin(), options.offsets.end(), -offset), 1) << offset;
  }
}

}  // namespace
}  // namespace forge
