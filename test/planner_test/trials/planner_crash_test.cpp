#include "collision_forge/planner_test/trials/planner_crash.h"

#include <gtest/gtest.h>

#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

const SeverityOptions& severity() { return shippedConfig().attack.verification.severity; }

/// A car stands in the ego's path; the attacker comes from far behind.
CrashScenario blocked() {
  return roadScenario(8.0, straightDrive({-60.0, 0.0, 0.0}, 5.0, 6.0),
                      {straightCar("parked", {10.0, 0.0, 0.0}, 0.0)});
}

/// The ego keeps 8 m/s up to its contact after 0.5 s.
RolloutOutcome outcomeWith(const std::string& id, const CrashScenario& scenario) {
  RolloutOutcome outcome;
  outcome.attacker = scenario.attacker;
  for (int i = 0; i <= 5; ++i) {
    outcome.driven.push_back({kNow + 0.1 * i, {0.8 * i, 0.0, 0.0}, 8.0});
  }
  outcome.contact = PlannerContact();
  outcome.contact->other_id = id;
  outcome.contact->is_attacker = id == scenario.attacker.attacker_id;
  outcome.contact->time = kNow + 0.5;
  return outcome;
}

TEST(PlannerCrash, PushesAnotherTouchedVehicleAndTheEgo) {
  const CrashScenario scenario = blocked();
  const auto crash = crashOf(outcomeWith("parked", scenario), scenario.ego.size,
                             scenario.recorded.agents, severity());
  ASSERT_TRUE(crash);
  EXPECT_EQ(crash->other.id, "parked");
  EXPECT_EQ(crash->motion.contactTime(), kNow + 0.5);
  const double stand = crash->motion.standTime();
  EXPECT_GT(crash->motion.attackerAt(stand).pose.x, 10.5);
  EXPECT_GT(crash->motion.attackerAt(stand).pose.x, crash->motion.egoAt(stand).pose.x + 4.0);
}

TEST(PlannerCrash, UsesTheSimulatedMotionOfAReactiveVehicle) {
  const CrashScenario scenario = blocked();
  RolloutOutcome outcome = outcomeWith("parked", scenario);
  outcome.others = {futureTrack("parked", kCarSize, {12.0, 0.0, 0.0}, 0.0)};
  EXPECT_EQ(crashOf(outcome, scenario.ego.size, scenario.recorded.agents, severity())
                ->motion.attackerAt(kNow)
                .pose.x,
            12.0);
}

TEST(PlannerCrash, UsesTheSimulatedMotionOfTheAttacker) {
  const CrashScenario scenario = blocked();
  const auto crash = crashOf(outcomeWith(scenario.attacker.attacker_id, scenario),
                             scenario.ego.size, scenario.recorded.agents, severity());
  ASSERT_TRUE(crash);
  EXPECT_NEAR(crash->motion.attackerAt(kNow + 0.5).pose.x, -57.5, 1e-6);
}

TEST(PlannerCrash, IsEmptyWithoutAContactAndForAnUnknownAgent) {
  const CrashScenario scenario = blocked();
  RolloutOutcome outcome = outcomeWith("nobody", scenario);
  EXPECT_FALSE(crashOf(outcome, scenario.ego.size, scenario.recorded.agents, severity()));
  outcome.contact.reset();
  EXPECT_FALSE(crashOf(outcome, scenario.ego.size, scenario.recorded.agents, severity()));
}

}  // namespace
}  // namespace forge
