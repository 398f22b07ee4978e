#include "collision_forge/planner_test/trials/crash_scenario.h"

#include <gtest/gtest.h>

#include <functional>

#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

CrashScenario sound() { return roadScenario(8.0, straightDrive({30.0, 0.0, M_PI}, 5.0, 4.0)); }

/// Returns the error of checkScenario() after a change; empty if there is none.
std::string complaint(const std::function<void(CrashScenario&)>& spoil) {
  CrashScenario scenario = sound();
  spoil(scenario);
  try {
    checkScenario(scenario);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CrashScenario, AValidScenarioIsAccepted) {
  EXPECT_EQ(complaint([](CrashScenario&) {}), "");
}

TEST(CrashScenario, InvalidScenariosAreRejectedWithTheReason) {
  EXPECT_NE(complaint([](auto& s) { s.lanes = nullptr; }).find("map"), std::string::npos);
  EXPECT_NE(complaint([](auto& s) { s.attacker.points.resize(1); }).find("two points"),
            std::string::npos);
  EXPECT_NE(complaint([](auto& s) { s.attacker.points.front().time += 0.05; }).find("start at t0"),
            std::string::npos);
  EXPECT_NE(complaint([](auto& s) {
              s.attacker.points[3].time = s.attacker.points[2].time;
            }).find("increase"),
            std::string::npos);
  EXPECT_NE(complaint([](auto& s) { s.recorded.ego.states.clear(); }).find("ego"),
            std::string::npos);
  EXPECT_NE(complaint([](auto& s) { s.attacker.points.front().pose.x = 4.0; }).find("touches"),
            std::string::npos);
}

TEST(CrashScenario, TheSnapshotContainsThePastOfAnAddedAttacker) {
  CrashScenario scenario = sound();
  const std::size_t seen = scenario.snapshot.agents.size();
  addAttackerPast(scenario);
  EXPECT_EQ(scenario.snapshot.agents.size(), seen);
  scenario.attacker.attacker_id = "added";
  scenario.attacker.agent_class = AgentClass::kBus;
  const Pose2 before{35.0, 0.0, M_PI};
  scenario.attacker.past = {
      {scenario.snapshot.now - 1.0, before, 5.0 * before.heading()},
      {scenario.snapshot.now, scenario.attacker.points.front().pose, 5.0 * before.heading()}};
  addAttackerPast(scenario);
  ASSERT_EQ(scenario.snapshot.agents.size(), seen + 1);
  const Track& added = scenario.snapshot.agents.back();
  EXPECT_EQ(added.id, "added");
  EXPECT_EQ(added.agent_class, AgentClass::kBus);
  EXPECT_EQ(added.states.size(), 2u);
  EXPECT_TRUE(endsAt(added, scenario.snapshot.now));
  EXPECT_EQ(attackerTrack(scenario).agent_class, AgentClass::kBus);
}

TEST(CrashScenario, TheAttackerReplacesItsRecordedTrack) {
  CrashScenario scenario = sound();
  scenario.snapshot.agents.front().agent_class = AgentClass::kTruck;
  scenario.recorded.agents = {futureTrack("attacker", kCarSize, {0.0, 50.0, 0.0}, 1.0),
                              futureTrack("other", kCarSize, {0.0, 60.0, 0.0}, 1.0)};
  const auto others = agentsFromT0(scenario);
  ASSERT_EQ(others.size(), 2u);
  EXPECT_EQ(others[0].id, "attacker");
  EXPECT_EQ(others[0].agent_class, AgentClass::kTruck);
  EXPECT_EQ(others[0].states.size(), scenario.attacker.points.size());
  EXPECT_NEAR(others[0].states[10].pose.x, 25.0, 1e-9);
  EXPECT_NEAR(others[0].states[10].velocity.x(), -5.0, 1e-9);
  EXPECT_EQ(others[1].id, "other");
}

}  // namespace
}  // namespace forge
