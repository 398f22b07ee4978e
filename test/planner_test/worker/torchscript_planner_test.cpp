#include "collision_forge/planner_test/planners/torchscript_planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "collision_forge/planner_test/planners/planner_factory.h"
#include "planner_test/trials/rollout_scenes.h"
#include "planner_test/worker/script_files.h"

namespace forge {
namespace {

constexpr double kAttackerSpeed = 5.0;  // m/s

/// An attacker that drives far ahead of the ego for 3 s.
AttackerTrajectory farAttacker() {
  AttackerTrajectory attacker{"attacker", AgentClass::kCar, kCarSize, {}};
  for (int i = 0; i <= 30; ++i) {
    attacker.points.push_back(
        {kNow + 0.1 * i, {100.0 + 0.1 * i * kAttackerSpeed, 0.0, 0.0}, kAttackerSpeed, 0.0, 0.0});
  }
  return attacker;
}

RolloutOutcome driveWith(const TorchscriptOptions& options, double ego_speed) {
  PlannerOptions planners = shippedConfig().planners;
  planners.torchscript = options;
  const PlannerUnderTest made = makePlanner("torchscript", planners, "attacker");
  return rollout(*made.planner, made.driving, roadScenario(ego_speed, farAttacker()),
                 shippedSetup());
}

/// A body that executes `throwing` above 2 m/s, a speed that the test inputs at load do not have.
std::string whenDriving(const std::string& throwing) {
  return "    if bool(ego_history[-1, 3] > 2.0):\n        " + throwing + "\n" + kConstantVelocity;
}

TEST(TorchscriptPlanner, PlansInTheEgoFrame) {
  const ScriptFile file(kConstantVelocity);
  TorchscriptPlanner planner(file.options(), shippedConfig().planners.route_centerline);
  planner.initialize(taskOn(threeLaneRoad()));
  const Pose2 ego{3.0, 1.0, 0.5};
  const auto plan = planner.plan({egoAt(ego, 6.0), {}});
  ASSERT_EQ(plan.size(), 81u);
  EXPECT_EQ(plan.front().time, 0.0);
  EXPECT_NEAR(plan.back().time, 8.0, 1e-9);
  for (const TrajectoryPoint& point : plan) {
    const Pose2 expected = compose(ego, {6.0 * point.time, 0.0, 0.0});
    EXPECT_LT((point.pose.position() - expected.position()).norm(), 1e-4);
    EXPECT_NEAR(point.pose.yaw, 0.5, 1e-5);
    EXPECT_NEAR(point.speed, 6.0, 1e-3);
  }
}

TEST(TorchscriptPlanner, KeepsTheEgoHistory) {
  // The file returns the previous history frame in the ego frame; 0 (no motion) while that frame is
  // unknown.
  const ScriptFile file(
      "    was = ego_history[-2]\n"
      "    return was[5] * was[0:3].expand(80, 3)\n");
  TorchscriptPlanner planner(file.options(), shippedConfig().planners.route_centerline);
  planner.initialize(taskOn(threeLaneRoad()));
  TrajectoryPoint ego = egoAt({0.0, 0.0, 0.0}, 4.0);
  EXPECT_NEAR(planner.plan({ego, {}})[1].pose.x, 0.0, 1e-6);
  ego.time = 0.25;
  ego.pose.x = 1.0;
  EXPECT_NEAR(planner.plan({ego, {}})[1].pose.x, 1.0, 1e-6);
  ego.time = 0.5;
  ego.pose.x = 3.0;
  EXPECT_NEAR(planner.plan({ego, {}})[1].pose.x, 0.0, 1e-6);
  planner.initialize(taskOn(threeLaneRoad()));
  EXPECT_NEAR(planner.plan({ego, {}})[1].pose.x, 3.0, 1e-6);
}

TEST(TorchscriptPlanner, FailsIfTheFileThrows) {
  const ScriptFile file(whenDriving("assert False, 'no idea'"));
  const RolloutOutcome outcome = driveWith(file.options(), 6.0);
  EXPECT_EQ(outcome.failure, PlannerFailure::kError);
  EXPECT_THAT(outcome.failure_message, testing::HasSubstr(file.path()));
  EXPECT_THAT(outcome.failure_message, testing::HasSubstr("no idea"));
}

TEST(TorchscriptPlanner, FailsIfTheOutputChangesShape) {
  const ScriptFile file(whenDriving("return torch.zeros([79, 3])"));
  const RolloutOutcome outcome = driveWith(file.options(), 6.0);
  EXPECT_EQ(outcome.failure, PlannerFailure::kError);
  EXPECT_THAT(outcome.failure_message, testing::HasSubstr("[79, 3]"));
}

TEST(TorchscriptPlanner, TimesOutInAnEndlessLoop) {
  const ScriptFile file(
      whenDriving("while bool(ego_history[-1, 3] > 1.0):\n            self.count += 1.0"));
  TorchscriptOptions options = file.options();
  options.timeout = 0.5;
  const RolloutOutcome outcome = driveWith(options, 6.0);
  EXPECT_EQ(outcome.failure, PlannerFailure::kTimedOut);
  EXPECT_THAT(outcome.failure_message, testing::HasSubstr(file.path()));
  EXPECT_EQ(outcome.plans, 1);
  EXPECT_EQ(driveWith(options, 1.5).failure, PlannerFailure::kNone) << "with a new process";
}

TEST(TorchscriptPlanner, ReloadsAChangedFile) {
  const ScriptFile file(kConstantVelocity);
  const TorchscriptOptions options = file.options();
  EXPECT_GT(driveWith(options, 6.0).progress, 17.0);
  scriptOf("    return torch.zeros([80, 3])\n").save(file.path());
  EXPECT_LT(driveWith(options, 6.0).progress, 16.0);
}

TEST(TorchscriptPlanner, RunsInManyThreads) {
  const ScriptFile file(kConstantVelocity);
  const TorchscriptOptions options = file.options();
  std::vector<double> progress(3);
  std::vector<std::thread> threads;
  for (double& one : progress) {
    threads.emplace_back([&] { one = driveWith(options, 6.0).progress; });
  }
  for (std::thread& thread : threads) thread.join();
  for (const double one : progress) EXPECT_EQ(one, progress.front());
}

}  // namespace
}  // namespace forge
