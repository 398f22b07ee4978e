#include "collision_forge/planner_test/planners/planner_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/planner_test/planners/planner_protocol.h"
#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

using testing::HasSubstr;

constexpr char kReady[] = "echo '{\"ready\": 1}'; ";
// Answers `begin`, and each observation with the point in FIRST.
constexpr char kAnswering[] =
    "echo '{\"ready\": 1}'; read begin; echo '{}'; while read line; do FIRST; done";

ExternalOptions external(const std::string& command) {
  ExternalOptions options;
  static_cast<PlannerProcessOptions&>(options) = shippedConfig().planners.external;
  options.interval = shippedConfig().planners.external.interval;
  options.command = command;
  return options;
}

std::string answering(const std::string& script) {
  std::string command = kAnswering;
  return command.replace(command.find("FIRST"), 5, script);
}

CrashScenario scenario() {
  AttackerTrajectory attacker{"attacker", AgentClass::kCar, kCarSize, {}};
  for (int i = 0; i <= 50; ++i) {
    attacker.points.push_back({kNow + 0.1 * i, {30.0 + 0.2 * i, 0.0, 0.0}, 2.0, 0.0, 0.0});
  }
  return roadScenario(10.0, attacker, {straightCar("beside", {5.0, 3.5, 0.0}, 9.0)});
}

RolloutOutcome driveWith(const ExternalOptions& options) {
  ProcessPlanner planner(options);
  return rollout(planner, {options.interval, false}, scenario(), shippedSetup());
}

std::string startErrorOf(const std::string& command, double start_timeout = 20.0) {
  ExternalOptions options = external(command);
  options.start_timeout = start_timeout;
  try {
    ProcessPlanner(options).start();
    return "none";
  } catch (const PlannerFileError& error) {
    return error.what();
  }
}

class BuiltInPlannerAsProcess : public testing::TestWithParam<const char*> {};

TEST_P(BuiltInPlannerAsProcess, DrivesBitForBitAsInThisProcess) {
  const PlannerUnderTest made = makePlanner(GetParam(), shippedConfig().planners, "");
  const RolloutOutcome expected = rollout(*made.planner, made.driving, scenario(), shippedSetup());
  ExternalOptions options = external(LINE_PLANNER " " + std::string(GetParam()));
  options.interval = made.driving.interval;
  const RolloutOutcome driven = driveWith(options);
  EXPECT_EQ(driven.failure_message, "");
  ASSERT_EQ(driven.driven.size(), expected.driven.size());
  for (std::size_t i = 0; i < driven.driven.size(); ++i) {
    EXPECT_EQ(driven.driven[i].pose.x, expected.driven[i].pose.x) << i;
    EXPECT_EQ(driven.driven[i].pose.yaw, expected.driven[i].pose.yaw) << i;
    EXPECT_EQ(driven.driven[i].speed, expected.driven[i].speed) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, BuiltInPlannerAsProcess,
                         testing::Values("idm", "rule_based", "pdm"));

TEST(ProcessPlanner, NamesTheCommandThatCannotStart) {
  EXPECT_THAT(startErrorOf("/no/such/planner"), HasSubstr("ended with exit code 127"));
  EXPECT_THAT(startErrorOf("exit 3"), HasSubstr("exit 3: before its first line: "));
  EXPECT_THAT(startErrorOf("sleep 60", 0.2), HasSubstr("no response within 0.2 s"));
  EXPECT_THAT(startErrorOf("echo starting"), HasSubstr("first line: invalid JSON"));
  EXPECT_THAT(startErrorOf("echo '{\"ready\": 2}'"), HasSubstr("ready"));
  EXPECT_THAT(startErrorOf(""), HasSubstr("--planner-command"));
}

TEST(ProcessPlanner, EndsAProcessThatFloodsItsOutput) {
  EXPECT_THAT(startErrorOf("yes | tr -d '\\n'"), HasSubstr("more than 16000000 bytes"));
}

struct BadProcess {
  const char* name;
  const char* script;
  PlannerFailure failure;
  const char* message;
};

class ProcessPlannerFailure : public testing::TestWithParam<BadProcess> {};

TEST_P(ProcessPlannerFailure, CostsItsRolloutAlone) {
  const BadProcess& bad = GetParam();
  ExternalOptions options = external(answering(bad.script));
  options.timeout = 0.5;
  for (int again = 0; again < 2; ++again) {
    const RolloutOutcome outcome = driveWith(options);
    EXPECT_EQ(outcome.failure, bad.failure) << outcome.failure_message;
    EXPECT_THAT(outcome.failure_message, HasSubstr(bad.message));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ProcessPlannerFailure,
    testing::Values(
        BadProcess{"dies", "kill -9 $$", PlannerFailure::kError, "ended by signal 9"},
        BadProcess{"hangs", "sleep 60", PlannerFailure::kTimedOut, "no response within 0.5 s"},
        BadProcess{"talks", "echo hello", PlannerFailure::kError, "response: invalid JSON"},
        BadProcess{"plans_nothing", "echo '{}'", PlannerFailure::kEmpty, ""},
        BadProcess{"short_rows", "echo '{\"points\": [[0, 1]]}'", PlannerFailure::kError, "points"},
        BadProcess{"too_early", "echo '{\"points\": [[0, 0, 0, 0, 1]]}'", PlannerFailure::kLate,
                   ""},
        BadProcess{"own_error", "echo '{\"error\": \"no route\"}'", PlannerFailure::kError,
                   "no route"},
        BadProcess{"own_timeout", "echo '{\"error\": \"node\", \"failure\": \"timed_out\"}'",
                   PlannerFailure::kTimedOut, "node"}),
    [](const auto& info) { return info.param.name; });

TEST(ProcessPlanner, PassesParametersAsEnvironmentVariables) {
  ExternalOptions options = external(kReady + std::string("read begin; echo \"{\\\"error\\\": "
                                                          "\\\"gap is $min_gap\\\"}\"; read rest"));
  options.parameters = {{"min_gap", 2.5}};
  EXPECT_THAT(driveWith(options).failure_message, HasSubstr("gap is 2.5"));
}

TEST(ProcessPlanner, ReusesAnIdleProcess) {
  const ExternalOptions options =
      external(kReady + std::string("while read line; do echo \"{\\\"error\\\": \\\"$$\\\"}\"; "
                                    "echo '{}'; done"));
  PlannerProcess process(options);
  EXPECT_THROW(process.begin(taskOn(threeLaneRoad()), 0.1), std::runtime_error);
  EXPECT_FALSE(process.isUsable());
  const ExternalOptions good = external(LINE_PLANNER " idm");
  driveWith(good);
  const auto idle = good.processes->take(good, processKey(good));
  EXPECT_TRUE(idle->isUsable());
}

TEST(PlannerProtocol, KeepsTheTask) {
  DrivingTask task = taskOn(threeLaneRoad());
  const PlanRequest read = readPlanRequest(beginLine(task, 0.1));
  EXPECT_TRUE(read.is_begin);
  EXPECT_EQ(read.interval, 0.1);
  EXPECT_EQ(read.task.route, task.route);
  EXPECT_EQ(read.task.wheelbase, task.wheelbase);
  EXPECT_EQ(read.task.ego.size.length, task.ego.size.length);
  ASSERT_EQ(read.task.lanes->map().lanes.size(), 3u);
  EXPECT_EQ(read.task.lanes->map().lanes[1].polygon, task.lanes->map().lanes[1].polygon);
}

TEST(PlannerProtocol, KeepsTheObservation) {
  const Observation observation{
      egoAt({1.0, 2.0, 0.3}, 4.0), {agentAt("a", {5.0, 3.5, 0.1}, 3.0)}, {"lane 7"}};
  const PlanRequest read = readPlanRequest(planLine(observation));
  EXPECT_FALSE(read.is_begin);
  EXPECT_EQ(read.observation.ego.pose.yaw, 0.3);
  EXPECT_EQ(read.observation.agents.at(0).states.at(0).velocity,
            observation.agents[0].states[0].velocity);
  EXPECT_EQ(read.observation.red_lanes, observation.red_lanes);
}

}  // namespace
}  // namespace forge
