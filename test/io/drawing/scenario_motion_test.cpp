#include "collision_forge/io/drawing/scenario_motion.h"

#include <gtest/gtest.h>

#include "io/drawing/sample_view.h"

namespace forge {
namespace {

TEST(ScenarioMotion, JoinsPastAndFuture) {
  const ScenarioView view = sampleView();
  const ScenarioMotion motion(view);
  EXPECT_NEAR(motion.egoAt(98.5)->center.x, 10 - 5 * 3.54, 1e-9);
  EXPECT_NEAR(motion.egoAt(101.25)->center.x, 10 - 5 * 0.79, 1e-9);
  EXPECT_NEAR(motion.attackerAt(98.5)->center.x, 5.5 - 10 * 3.54, 1e-9);
  EXPECT_NEAR(motion.attackerAt(101.25)->center.x, 5.5 - 10 * 0.79, 1e-9);
  EXPECT_FALSE(motion.egoAt(97.9));
  EXPECT_FALSE(motion.attackerAt(97.9));
}

TEST(ScenarioMotion, AnAddedAttackerComesFromItsOwnPast) {
  ScenarioView view = sampleView();
  view.snapshot.agents.erase(view.snapshot.agents.begin());
  EXPECT_FALSE(ScenarioMotion(view).attackerAt(99.0));
  view.trajectory.past = {{98.5, {-30.0, 0.0, 0.0}, {10.0, 0.0}},
                          {99.5, {-20.0, 0.0, 0.0}, {10.0, 0.0}},
                          {100.0, {-15.0, 0.0, 0.0}, {10.0, 0.0}}};
  const ScenarioMotion motion(view);
  EXPECT_DOUBLE_EQ(motion.attackerAt(99.0)->center.x, -25.0);
  EXPECT_EQ(motion.attackerAt(99.0)->size.length, view.trajectory.size.length);
  EXPECT_FALSE(motion.attackerAt(98.4));
  EXPECT_EQ(motion.otherAgentsAt(99.0).size(), 1U);
}

TEST(ScenarioMotion, FollowsThePostCrashMotionAfterContact) {
  const ScenarioView view = sampleCrash();
  const ScenarioMotion motion(view);
  EXPECT_DOUBLE_EQ(motion.egoAt(102.04)->center.x, 10.0);
  EXPECT_NEAR(motion.egoAt(102.54)->center.x, view.crash->egoAt(102.54).pose.x, 1e-9);
  EXPECT_NEAR(motion.egoAt(102.54)->center.x, 10.0 + 0.75 * 3.7, 0.1);
  EXPECT_NEAR(motion.attackerAt(102.54)->center.x, 5.5 + 0.75 * 3.7, 0.1);
  EXPECT_EQ(motion.standTime(), view.crash->standTime());
  EXPECT_NEAR(motion.standTime(), 103.04, 0.2);
  EXPECT_NEAR(motion.egoAt(103.5)->center.x, 13.7, 0.1);
}

TEST(ScenarioMotion, AnAnimationEndsSomeSecondsAfterTheStandOrWithTheRecording) {
  ScenarioView view = sampleCrash();
  const double stand = view.crash->standTime();
  EXPECT_NEAR(ScenarioMotion(view).endTime(), stand + 0.5, 1e-6);
  view.seconds_after_stand = 3.0;
  EXPECT_NEAR(ScenarioMotion(view).endTime(), 104.0, 1e-6) << "the recording's end";
  view.future.ego.states.resize(6);  // up to 102.5 s, as for an ego driven up to the contact
  EXPECT_NEAR(ScenarioMotion(view).endTime(), 104.0, 1e-6) << "the others are known up to then";
  for (Track& track : view.future.agents) track.states.resize(6);
  EXPECT_NEAR(ScenarioMotion(view).endTime(), stand, 1e-6) << "not before both stand";
}

TEST(ScenarioMotion, AgentsInThePathAtContactWereElsewhereWhenPassed) {
  ScenarioView view = sampleView();
  EXPECT_TRUE(ScenarioMotion(view).passedAgents().empty()) << "the truck stands beside the road";
  // Crosses from the north: at contact it is on the attacker's path, 12.5 m behind the contact.
  Track& truck = view.future.agents.back();
  for (AgentState& state : truck.states) {
    state.pose = {-7.0, 10.0 * (102.04 - state.time), 0.0};
  }
  const auto passed = ScenarioMotion(view).passedAgents();
  ASSERT_EQ(passed.size(), 1U);
  EXPECT_NEAR(passed.front().at_key_time.box.center.y, 0.0, 1e-9);
  // The attacker's rear, 2.5 m behind its centre, leaves the truck's front at x = -3: 0.6 s before.
  EXPECT_NEAR(passed.front().then.box.center.y, 6.0, 1.0 + 1e-6);
  EXPECT_FALSE(passed.front().then.is_support);
  view.supports = {truck.id};
  EXPECT_TRUE(ScenarioMotion(view).passedAgents().front().then.is_support);
}

TEST(ScenarioMotion, KeyTimeOfAnAvoidedHitIsTheHit) {
  ScenarioView view = sampleView();
  view.report.contact = false;
  EXPECT_DOUBLE_EQ(ScenarioMotion(view).keyTime(), view.pattern.time);
  view.avoided_hit = view.pattern.time + 1.5;
  const ScenarioMotion motion(view);
  EXPECT_DOUBLE_EQ(motion.keyTime(), view.pattern.time + 1.5);
  const double ego = motion.egoAt(motion.keyTime())->center.x;
  const double attacker = motion.attackerAt(motion.keyTime())->center.x;
  EXPECT_NEAR(motion.contactPoint().x(), (ego + attacker) / 2, 1e-9);
}

}  // namespace
}  // namespace forge
