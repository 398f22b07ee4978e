#include "collision_forge/planner_test/planners/planner_factory.h"

#include <gtest/gtest.h>

#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

TEST(PlannerFactory, CreatesEveryNamedPlanner) {
  for (const std::string& name : plannerNames()) {
    const PlannerUnderTest made = makePlanner(name, shippedConfig().planners, "attacker");
    EXPECT_NE(made.planner, nullptr) << name;
    EXPECT_GT(made.driving.interval, 0.0) << name;
  }
  EXPECT_TRUE(makePlanner("idm_published", shippedConfig().planners, "a").driving.is_exact);
  EXPECT_FALSE(makePlanner("idm", shippedConfig().planners, "a").driving.is_exact);
}

TEST(PlannerFactory, RejectsAnUnknownNameAndListsTheKnownOnes) {
  try {
    makePlanner("idn", shippedConfig().planners, "attacker");
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("\"idn\""), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("idm_published"), std::string::npos);
  }
}

}  // namespace
}  // namespace forge
