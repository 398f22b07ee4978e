#include "collision_forge/planner_test/trials/rollout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>

#include "collision_forge/planner_test/planners/planner_factory.h"
#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

/// A planner that calls a function.
class FunctionPlanner : public Planner {
 public:
  using Plan = std::function<std::vector<TrajectoryPoint>(const Observation&)>;
  explicit FunctionPlanner(Plan plan) : plan_(std::move(plan)) {}
  void initialize(const DrivingTask& task) override { task_ = task; }
  std::vector<TrajectoryPoint> plan(const Observation& observation) override {
    return plan_(observation);
  }
  const DrivingTask& task() const { return task_; }

 private:
  Plan plan_;
  DrivingTask task_;
};

/// A plan of 4 s straight along x from the ego's speed with a constant acceleration.
std::vector<TrajectoryPoint> straightPlan(const TrajectoryPoint& ego, double acceleration = 0.0) {
  std::vector<TrajectoryPoint> plan = {ego};
  for (int i = 1; i <= 40; ++i) {
    TrajectoryPoint point = plan.back();
    point.time = ego.time + 0.1 * i;
    point.speed = std::max(0.0, point.speed + 0.1 * acceleration);
    point.pose.x += 0.05 * (plan.back().speed + point.speed);
    plan.push_back(point);
  }
  return plan;
}

FunctionPlanner keepingSpeed() {
  return FunctionPlanner([](const Observation& seen) { return straightPlan(seen.ego); });
}

RolloutOutcome drive(Planner& planner, const CrashScenario& scenario,
                     Background background = Background::kReplay) {
  return rollout(planner, {0.1, false}, scenario, shippedSetup(background));
}

/// A policy that records its observations and stops at a given time.
class StoppingAttacker : public AttackerPolicy {
 public:
  explicit StoppingAttacker(AttackerTrajectory trajectory) : trajectory_(std::move(trajectory)) {}
  std::unique_ptr<AttackerPolicy> clone() const override {
    return std::make_unique<StoppingAttacker>(*this);
  }
  void observe(const Frame& seen) override {
    seen_->push_back(seen);
    if (seen.time < kNow + 1.0 - 1e-6) return;
    for (TrajectoryPoint& point : trajectory_.points) {
      if (point.time <= seen.time + 1e-6) stop_ = point;
      if (point.time > kNow + 1.0 + 1e-6) point.pose = stop_.pose;
    }
  }
  const AttackerTrajectory& trajectory() const override { return trajectory_; }
  AttackerPhase phase() const override { return AttackerPhase::kDrivingOn; }
  const std::vector<AttackerPlan>& plans() const override { return plans_; }
  /// What its copies have seen, too.
  const std::vector<Frame>& seen() const { return *seen_; }

 private:
  AttackerTrajectory trajectory_;
  TrajectoryPoint stop_;
  std::vector<AttackerPlan> plans_;
  std::shared_ptr<std::vector<Frame>> seen_ = std::make_shared<std::vector<Frame>>();
};

TEST(Rollout, TheAttackerObservesEveryStepAndFollowsItsNewestPlan) {
  const CrashScenario scenario = roadScenario(8.0, straightDrive({40.0, 0.0, M_PI}, 5.0, 6.0),
                                              {straightCar("other", {-30.0, 3.5, 0.0}, 4.0)});
  FunctionPlanner planner = keepingSpeed();
  StoppingAttacker attacker(scenario.attacker);
  RolloutSetup setup = shippedSetup();
  setup.attacker = &attacker;
  const RolloutOutcome outcome = rollout(planner, {0.1, true}, scenario, setup);
  ASSERT_TRUE(outcome.contact);
  // The attacker stands at x = 35 m from 1 s after t0 on.
  const double gap = 35.0 - 0.5 * (kEgoSize.length + kCarSize.length);
  EXPECT_NEAR(outcome.contact->time, kNow + gap / 8.0, 1e-3);
  EXPECT_EQ(outcome.phase, AttackerPhase::kDrivingOn);
  EXPECT_NEAR(outcome.attacker.points.back().pose.x, 35.0, 1e-6);
  ASSERT_GT(attacker.seen().size(), 12u);
  const Frame& tenth = attacker.seen()[10];
  EXPECT_NEAR(tenth.time, kNow + 1.0, 1e-9);
  EXPECT_NEAR(tenth.ego.x, 8.0, 1e-6);
  const auto other = std::find_if(tenth.agents.begin(), tenth.agents.end(),
                                  [](const Track& agent) { return agent.id == "other"; });
  ASSERT_NE(other, tenth.agents.end());
  ASSERT_EQ(other->states.size(), 1u);
  EXPECT_NEAR(other->states.front().pose.x, -26.0, 1e-6);
}

TEST(Rollout, AnEgoAtConstantSpeedHitsAnOncomingAttackerAtTheExpectedTime) {
  const CrashScenario scenario = roadScenario(8.0, straightDrive({40.0, 0.0, M_PI}, 5.0, 6.0));
  FunctionPlanner planner = keepingSpeed();
  const RolloutOutcome outcome = drive(planner, scenario);
  ASSERT_TRUE(outcome.contact);
  const double gap = 40.0 - 0.5 * (kEgoSize.length + kCarSize.length);
  EXPECT_NEAR(outcome.contact->time, kNow + gap / 13.0, 1e-3);
  EXPECT_NEAR(outcome.duration, gap / 13.0, 1e-3);
  EXPECT_TRUE(outcome.contact->is_attacker);
  EXPECT_EQ(outcome.contact->other_id, "attacker");
  EXPECT_NEAR(std::abs(outcome.contact->relative_heading), M_PI, 1e-6);
  EXPECT_EQ(outcome.contact->ego_side, Side::kFront);
  EXPECT_EQ(outcome.contact->other_side, Side::kFront);
  EXPECT_NEAR(outcome.contact->impact_speed, 13.0, 1e-2);
  EXPECT_EQ(outcome.contact->type, CollisionType::kOppositeDirection);
  EXPECT_EQ(outcome.contact->cause, ContactCause::kFront);
  EXPECT_TRUE(outcome.contact->at_fault);
  EXPECT_NEAR(outcome.progress, 8.0 * gap / 13.0, 1e-2);
  EXPECT_NEAR(outcome.recorded_progress, 8.0 * gap / 13.0, 1e-2);
  EXPECT_EQ(outcome.failure, PlannerFailure::kNone);
}

TEST(Rollout, FindsTheFirstAgentHit) {
  const CrashScenario scenario = roadScenario(8.0, straightDrive({40.0, 0.0, M_PI}, 5.0, 6.0),
                                              {straightCar("standing", {15.0, 0.0, 0.0}, 0.0)});
  FunctionPlanner planner = keepingSpeed();
  const RolloutOutcome outcome = drive(planner, scenario);
  ASSERT_TRUE(outcome.contact);
  EXPECT_EQ(outcome.contact->other_id, "standing");
  EXPECT_FALSE(outcome.contact->is_attacker);
  EXPECT_EQ(outcome.contact->cause, ContactCause::kStoppedOther);
  EXPECT_TRUE(outcome.contact->at_fault);
}

TEST(Rollout, LastsUntilTheAttackersEndWithoutContact) {
  const CrashScenario scenario = roadScenario(5.0, straightDrive({20.0, 3.5, M_PI}, 5.0, 4.05));
  FunctionPlanner planner = keepingSpeed();
  const RolloutOutcome outcome = drive(planner, scenario);
  EXPECT_FALSE(outcome.contact);
  EXPECT_NEAR(outcome.duration, 4.0, 1e-9);  // the last point of straightDrive()
  EXPECT_EQ(outcome.plans, 40);
  EXPECT_EQ(outcome.driven.size(), 41u);
  EXPECT_LT(outcome.max_braking, 0.1);
  EXPECT_NEAR(outcome.off_road_share, 0.0, 1e-9);
}

TEST(Rollout, AnExactDriveFollowsThePlanWithoutVehicleLimits) {
  const CrashScenario scenario = roadScenario(5.0, straightDrive({-60.0, 3.5, 0.0}, 5.0, 2.0));
  FunctionPlanner planner([](const Observation& seen) { return straightPlan(seen.ego, -30.0); });
  const RolloutOutcome outcome = rollout(planner, {0.1, true}, scenario, shippedSetup());
  EXPECT_NEAR(outcome.driven[1].speed, 2.0, 1e-9);
  EXPECT_NEAR(outcome.max_braking, 30.0, 1e-6);
}

TEST(Rollout, CallsThePlannerAtItsInterval) {
  const CrashScenario scenario = roadScenario(5.0, straightDrive({-60.0, 3.5, 0.0}, 5.0, 3.0));
  std::vector<double> calls;
  FunctionPlanner planner([&](const Observation& seen) {
    calls.push_back(seen.ego.time);
    return straightPlan(seen.ego);
  });
  rollout(planner, {0.5, false}, scenario, shippedSetup());
  ASSERT_EQ(calls.size(), 6u);
  for (std::size_t i = 0; i < calls.size(); ++i) {
    EXPECT_NEAR(calls[i], kNow + 0.5 * static_cast<double>(i), 1e-6);
  }
}

TEST(Rollout, GivesThePlannerTheCurrentStatesAndTheTask) {
  const CrashScenario scenario = roadScenario(5.0, straightDrive({20.0, 3.5, M_PI}, 5.0, 2.0));
  FunctionPlanner planner([](const Observation& seen) {
    for (const Track& agent : seen.agents) EXPECT_EQ(agent.states.back().time, seen.ego.time);
    EXPECT_EQ(seen.agents.size(), 1u);
    return straightPlan(seen.ego);
  });
  drive(planner, scenario);
  EXPECT_GE(planner.task().route.size(), 2u);
  EXPECT_EQ(planner.task().wheelbase, shippedConfig().planners.car.wheelbase);
  EXPECT_EQ(planner.task().ego.size.length, kEgoSize.length);
}

PlannerFailure failureOf(const FunctionPlanner::Plan& plan) {
  const CrashScenario scenario = roadScenario(5.0, straightDrive({-60.0, 3.5, 0.0}, 5.0, 3.0));
  FunctionPlanner planner([&](const Observation& seen) {
    return seen.ego.time < kNow + 0.95 ? straightPlan(seen.ego) : plan(seen);
  });
  const RolloutOutcome outcome = drive(planner, scenario);
  EXPECT_FALSE(outcome.failure_message.empty());
  EXPECT_NEAR(outcome.duration, 1.0, 0.06);
  return outcome.failure;
}

TEST(Rollout, ABadPlanEndsTheRolloutWithItsFailure) {
  EXPECT_EQ(failureOf([](const Observation&) { return std::vector<TrajectoryPoint>(); }),
            PlannerFailure::kEmpty);
  EXPECT_EQ(failureOf([](const Observation& seen) {
              auto plan = straightPlan(seen.ego);
              plan[7].pose.y = std::numeric_limits<double>::quiet_NaN();
              return plan;
            }),
            PlannerFailure::kNotFinite);
  EXPECT_EQ(failureOf([](const Observation& seen) {
              auto plan = straightPlan(seen.ego);
              plan[7].time = plan[6].time;
              return plan;
            }),
            PlannerFailure::kUnordered);
  EXPECT_EQ(failureOf([](const Observation& seen) {
              auto plan = straightPlan(seen.ego);
              for (TrajectoryPoint& point : plan) point.time -= 0.2;
              return plan;
            }),
            PlannerFailure::kLate);
  EXPECT_EQ(
      failureOf([](const Observation& seen) { return std::vector<TrajectoryPoint>{seen.ego}; }),
      PlannerFailure::kLate);
  EXPECT_EQ(failureOf([](const Observation&) -> std::vector<TrajectoryPoint> {
              throw std::runtime_error("out of ideas");
            }),
            PlannerFailure::kError);
  EXPECT_EQ(failureOf([](const Observation&) -> std::vector<TrajectoryPoint> {
              throw PlannerTimeout("no answer");
            }),
            PlannerFailure::kTimedOut);
  EXPECT_EQ(failureOf([](const Observation&) -> std::vector<TrajectoryPoint> {
              throw LatePlan("an old answer");
            }),
            PlannerFailure::kLate);
}

TEST(Rollout, LeavingTheMapEndsTheRollout) {
  const CrashScenario scenario = roadScenario(8.0, straightDrive({-60.0, 3.5, 0.0}, 5.0, 8.0));
  FunctionPlanner planner([](const Observation& seen) {
    std::vector<TrajectoryPoint> plan = {seen.ego};
    for (int i = 1; i <= 40; ++i) {
      plan.push_back(
          {seen.ego.time + 0.1 * i, compose(seen.ego.pose, {0.8 * i, 0.0, 0.0}), 8.0, 0.0, 0.0});
      const double yaw = std::max(seen.ego.pose.yaw - 0.02 * i, -1.0);
      plan.back().pose = {plan[plan.size() - 2].pose.x + 0.8 * std::cos(yaw),
                          plan[plan.size() - 2].pose.y + 0.8 * std::sin(yaw), yaw};
    }
    return plan;
  });
  const RolloutOutcome outcome = drive(planner, scenario);
  EXPECT_EQ(outcome.failure, PlannerFailure::kOffMap);
  EXPECT_LT(outcome.driven.back().pose.y, -1.75 - 0.5 * kEgoSize.width);
  EXPECT_GT(outcome.off_road_share, 0.0);
}

TEST(Rollout, AnAttackerThatTouchesTheEgoAtT0IsRejected) {
  const CrashScenario scenario = roadScenario(5.0, straightDrive({3.0, 0.0, 0.0}, 5.0, 3.0));
  FunctionPlanner planner = keepingSpeed();
  EXPECT_THROW(drive(planner, scenario), std::invalid_argument);
}

TEST(Rollout, BackgroundTrafficBrakesForAnEgoThatStops) {
  const CrashScenario scenario = roadScenario(8.0, straightDrive({-90.0, 3.5, 0.0}, 5.0, 8.0),
                                              {straightCar("behind", {-18.0, 0.0, 0.0}, 8.0)});
  FunctionPlanner planner([](const Observation& seen) { return straightPlan(seen.ego, -3.0); });
  const RolloutOutcome replayed = drive(planner, scenario);
  ASSERT_TRUE(replayed.contact);
  EXPECT_EQ(replayed.contact->other_id, "behind");
  EXPECT_TRUE(replayed.others.empty()) << "replayed agents are at their recorded poses";
  const RolloutOutcome outcome = drive(planner, scenario, Background::kIdm);
  EXPECT_FALSE(outcome.contact);
  ASSERT_EQ(outcome.others.size(), 1u);
  EXPECT_EQ(outcome.others[0].id, "behind");
  ASSERT_EQ(outcome.others[0].states.size(), outcome.driven.size());
  EXPECT_LT(outcome.others[0].states.back().pose.x, outcome.driven.back().pose.x);
}

}  // namespace
}  // namespace forge
