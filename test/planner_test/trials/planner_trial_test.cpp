#include "collision_forge/planner_test/trials/planner_trial.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/planner_test/trials/evasion.h"
#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

constexpr double kNap = 0.05;  // s

/// A planner that drives straight at constant speed, sleeps in its third call, and proposes the
/// time of each call.
class NappingPlanner : public Planner {
 public:
  void initialize(const DrivingTask&) override {}

  std::vector<TrajectoryPoint> plan(const Observation& seen) override {
    if (++calls_ == 3) std::this_thread::sleep_for(std::chrono::duration<double>(kNap));
    time_ = seen.ego.time;
    TrajectoryPoint end = seen.ego;
    end.time += 4.0;
    end.pose.x += 4.0 * end.speed;
    return {seen.ego, end};
  }

  std::vector<std::vector<Pose2>> proposals() const override { return {{{time_, 0.0, 0.0}}}; }

 private:
  int calls_ = 0;
  double time_ = 0.0;
};

CrashScenario oncoming() { return roadScenario(8.0, straightDrive({40.0, 0.0, M_PI}, 5.0, 6.0)); }

TEST(PlannerTrial, IsTheRolloutAndTheAvoidabilityOfTheScenario) {
  const CrashScenario scenario = oncoming();
  const RolloutSetup setup = shippedSetup();
  const auto make = [&] { return makePlanner("idm", setup.planners, "attacker"); };
  const PlannerUnderTest watched = make();
  const PlannerTrial trial = tryPlanner(*watched.planner, watched.driving, scenario, setup);
  const PlannerUnderTest alone = make();
  const RolloutOutcome outcome = rollout(*alone.planner, alone.driving, scenario, setup);
  EXPECT_EQ(trial.outcome.duration, outcome.duration);
  EXPECT_EQ(trial.outcome.plans, outcome.plans);
  ASSERT_EQ(trial.outcome.contact.has_value(), outcome.contact.has_value());
  const Avoidability avoidability = findAvoidability(scenario, setup.planners.avoidability,
                                                     setup.planners.planning.route, setup.attack);
  EXPECT_EQ(trial.avoidability.isAvoidable(), avoidability.isAvoidable());
  EXPECT_EQ(trial.avoidability.from_now.size(), avoidability.from_now.size());
}

TEST(PlannerTrial, UsesFindEscapeOrTheDrivenMotionForAnAdaptiveAttacker) {
  CrashScenario scenario = oncoming();
  RolloutSetup setup = shippedSetup();
  const PlannerUnderTest idm = makePlanner("idm", setup.planners, "attacker");
  const FixedAttacker attacker(scenario.attacker);
  setup.attacker = &attacker;
  const PlannerTrial hit = tryPlanner(*idm.planner, idm.driving, scenario, setup);
  ASSERT_TRUE(hit.outcome.contact && hit.outcome.contact->is_attacker);
  const auto evasion = findEvasion(scenario, hit.outcome.driven, setup);
  ASSERT_TRUE(evasion && hit.avoidability.last);
  EXPECT_EQ(hit.avoidability.last->start, evasion->ego.start);
  EXPECT_TRUE(hit.avoidability.from_now.empty());
  const FixedAttacker away(straightDrive({40.0, 3.5, M_PI}, 5.0, 6.0));
  setup.attacker = &away;
  const PlannerTrial missed = tryPlanner(*idm.planner, idm.driving, scenario, setup);
  ASSERT_FALSE(missed.outcome.contact);
  ASSERT_TRUE(missed.avoidability.last);
  EXPECT_EQ(missed.avoidability.last->manoeuvre, EvasiveManoeuvre::kKeeping);
}

TEST(PlannerTrial, KeepsTheLastProposalsAndTheLongestCallTime) {
  NappingPlanner planner;
  const PlannerTrial trial = tryPlanner(planner, {0.1, false}, oncoming(), shippedSetup());
  ASSERT_GT(trial.outcome.plans, 10);
  ASSERT_EQ(trial.proposals.size(), 1U);
  EXPECT_NEAR(trial.proposals[0][0].x, kNow + 0.1 * (trial.outcome.plans - 1), 1e-6);
  EXPECT_GE(trial.max_call, kNap);
  EXPECT_GE(trial.mean_call, kNap / trial.outcome.plans);
  EXPECT_LT(trial.mean_call, trial.max_call);
}

TEST(PlannerTrial, APlannerThatFailsAtOnceHasNoTimes) {
  const CrashScenario scenario = oncoming();
  class Refusing : public NappingPlanner {
    void initialize(const DrivingTask&) override { throw PlannerTimeout("nobody there"); }
  } planner;
  const PlannerTrial trial = tryPlanner(planner, {0.1, false}, scenario, shippedSetup());
  EXPECT_EQ(trial.outcome.failure, PlannerFailure::kTimedOut);
  EXPECT_EQ(trial.outcome.failure_message, "nobody there");
  EXPECT_EQ(trial.outcome.driven.size(), 1U);
  EXPECT_TRUE(trial.proposals.empty());
  EXPECT_EQ(trial.mean_call, 0.0);
}

}  // namespace
}  // namespace forge
