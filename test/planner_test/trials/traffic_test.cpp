#include "collision_forge/planner_test/trials/traffic.h"

#include <gtest/gtest.h>

#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

/// The attacker drives far away from all agents.
CrashScenario scenarioWith(std::vector<std::pair<Track, Track>> others) {
  return roadScenario(5.0, straightDrive({0.0, 100.0, 0.0}, 5.0, 8.0), std::move(others));
}

const IdmOptions& idm() { return shippedConfig().planners.idm; }

Track egoAt(double time, double x, double speed = 0.0) {
  return {kEgoId, AgentClass::kCar, kEgoSize, {{time, {x, 0.0, 0.0}, {speed, 0.0}}}};
}

std::unique_ptr<AttackerPolicy> fixed(const CrashScenario& scenario) {
  return std::make_unique<FixedAttacker>(scenario.attacker);
}

/// A policy that turns around at its first update step.
class Hesitant : public FixedAttacker {
 public:
  using FixedAttacker::FixedAttacker;
  std::unique_ptr<AttackerPolicy> clone() const override {
    return std::make_unique<Hesitant>(*this);
  }
  void observe(const Frame& seen) override {
    ++looks_;
    changed_ = FixedAttacker::trajectory();
    for (TrajectoryPoint& point : changed_.points) point.pose.y += seen.ego.y + looks_;
  }
  const AttackerTrajectory& trajectory() const override { return changed_; }

 private:
  int looks_ = 0;
  AttackerTrajectory changed_ = FixedAttacker::trajectory();
};

const Track& find(const Traffic& traffic, const std::string& id) {
  for (const Track& agent : traffic.agents()) {
    if (agent.id == id) return agent;
  }
  throw std::out_of_range(id);
}

TEST(Traffic, ReplaysTheRecording) {
  const CrashScenario scenario = scenarioWith({straightCar("other", {20.0, 3.5, M_PI}, 4.0)});
  Traffic traffic(scenario, fixed(scenario), Background::kReplay, idm(), 2.0);
  for (int i = 1; i <= 30; ++i) traffic.advance(kNow + 0.1 * i, egoAt(kNow + 0.1 * (i - 1), 0.0));
  const AgentState& state = find(traffic, "other").states.back();
  EXPECT_NEAR(state.pose.x, 8.0, 1e-9);
  EXPECT_NEAR(state.velocity.x(), -4.0, 1e-6);
  EXPECT_NEAR(find(traffic, "attacker").states.back().pose.x, 15.0, 1e-9);
  EXPECT_NEAR(find(traffic, "other").states.front().time, kNow + 1.0, 0.11);
}

TEST(Traffic, ContainsNoFutureStates) {
  // Two recordings that differ from the frame 0.5 s after t0 on.
  auto calm = straightCar("other", {20.0, 3.5, M_PI}, 4.0);
  auto sudden = calm;
  for (AgentState& state : sudden.second.states) {
    if (state.time > kNow + 0.6) state.pose.y += 3.0;
  }
  deriveVelocities(calm.second);
  deriveVelocities(sudden.second);
  const CrashScenario one = scenarioWith({calm});
  const CrashScenario two = scenarioWith({sudden});
  Traffic first(one, fixed(one), Background::kReplay, idm(), 2.0);
  Traffic second(two, fixed(two), Background::kReplay, idm(), 2.0);
  for (int i = 1; i <= 5; ++i) {
    first.advance(kNow + 0.1 * i, egoAt(kNow + 0.1 * (i - 1), 0.0));
    second.advance(kNow + 0.1 * i, egoAt(kNow + 0.1 * (i - 1), 0.0));
    EXPECT_EQ(find(first, "other").states.back().velocity.y(),
              find(second, "other").states.back().velocity.y());
    EXPECT_EQ(find(first, "other").states.back().pose.y,
              find(second, "other").states.back().pose.y);
  }
  first.advance(kNow + 0.6, egoAt(kNow + 0.5, 0.0));
  second.advance(kNow + 0.6, egoAt(kNow + 0.5, 0.0));
  EXPECT_NE(find(first, "other").states.back().pose.y, find(second, "other").states.back().pose.y);
}

TEST(Traffic, ReplayDrivesThroughAStandingEgoButIdmDoesNot) {
  const CrashScenario scenario = scenarioWith({straightCar("behind", {-30.0, 0.0, 0.0}, 8.0)});
  Traffic replay(scenario, fixed(scenario), Background::kReplay, idm(), 2.0);
  Traffic reacting(scenario, fixed(scenario), Background::kIdm, idm(), 2.0);
  for (int i = 1; i <= 70; ++i) {
    const Track ego = egoAt(kNow + 0.1 * (i - 1), 0.0);
    replay.advance(kNow + 0.1 * i, ego);
    reacting.advance(kNow + 0.1 * i, ego);
  }
  EXPECT_GT(find(replay, "behind").states.back().pose.x, 20.0);
  const double bumper = -0.5 * (kEgoSize.length + kCarSize.length);
  EXPECT_LT(find(reacting, "behind").states.back().pose.x, bumper);
  EXPECT_GT(find(reacting, "behind").states.back().pose.x, bumper - 6.0);
}

TEST(Traffic, ADelayedVehicleNeverGetsAheadOfTheRecording) {
  const CrashScenario scenario = scenarioWith({straightCar("behind", {-30.0, 0.0, 0.0}, 8.0)});
  Traffic traffic(scenario, fixed(scenario), Background::kIdm, idm(), 2.0);
  for (int i = 1; i <= 95; ++i) {
    const double ego_x = i < 40 ? 0.0 : 500.0;
    traffic.advance(kNow + 0.1 * i, egoAt(kNow + 0.1 * (i - 1), ego_x));
    EXPECT_LE(find(traffic, "behind").states.back().pose.x, -30.0 + 0.8 * i + 1e-6);
  }
  EXPECT_GT(find(traffic, "behind").states.back().velocity.x(), 2.0);
}

TEST(Traffic, ThePolicyUpdatesBeforeEveryStepAndACopyIsIndependent) {
  const CrashScenario scenario = scenarioWith({});
  Traffic traffic(scenario, std::make_unique<Hesitant>(scenario.attacker), Background::kReplay,
                  idm(), 2.0);
  const double before = find(traffic, "attacker").states.back().pose.y;
  Traffic copy = traffic;
  for (int i = 1; i <= 3; ++i) copy.advance(kNow + 0.1 * i, egoAt(kNow + 0.1 * (i - 1), 0.0));
  EXPECT_NEAR(find(copy, "attacker").states.back().pose.y, before + 3.0, 1e-9);
  traffic.advance(kNow + 0.1, egoAt(kNow, 0.0));
  EXPECT_NEAR(find(traffic, "attacker").states.back().pose.y, before + 1.0, 1e-9);
}

}  // namespace
}  // namespace forge
