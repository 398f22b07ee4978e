#include "collision_forge/planner_test/planners/background_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "collision_forge/planner_test/trials/rollout.h"
#include "planner_test/trials/rollout_scenes.h"
#include "planner_test/worker/script_files.h"

namespace forge {
namespace {

using testing::HasSubstr;

TorchscriptOptions trafficOptions(const ScriptFile& file) {
  TorchscriptOptions options = file.options();
  options.contract = &kTrafficContract;
  return options;
}

/// A far attacker, and a car 20 m ahead that comes closer at 4 m/s up to t0 and stands from then
/// on.
CrashScenario scenarioWithBraker() {
  auto car = straightCar("braker", {20.0, 3.5, M_PI}, 4.0);
  for (AgentState& state : car.second.states) state.pose = {20.0, 3.5, M_PI};
  return roadScenario(5.0, straightDrive({0.0, 100.0, 0.0}, 5.0, 8.0), {car});
}

/// Returns an agent after `steps` steps of 0.1 s beside an ego that stands at the origin.
AgentState stateAfter(int steps, const std::string& id, const ScriptFile& file,
                      const CrashScenario& scenario = scenarioWithBraker()) {
  TrialOptions planners = shippedConfig().planners;
  planners.traffic_model = trafficOptions(file);
  const RolloutSetup setup{planners, shippedConfig().attack, shippedConfig().crash,
                           Background::kModel};
  Traffic traffic = makeRolloutTraffic(scenario, setup);
  for (int i = 0; i < steps; ++i) {
    traffic.advance(
        kNow + 0.1 * (i + 1),
        {kEgoId, AgentClass::kCar, kEgoSize, {{kNow + 0.1 * i, {0.0, 0.0, 0.3}, {0.0, 0.0}}}});
  }
  for (const Track& agent : traffic.agents()) {
    if (agent.id == id) return agent.states.back();
  }
  throw std::out_of_range(id);
}

TEST(BackgroundModel, MovesTheOtherAgentsAndNotTheAttacker) {
  const ScriptFile file(kSteadyTraffic, kTrafficArguments);
  const AgentState braker = stateAfter(20, "braker", file);
  EXPECT_NEAR(braker.pose.x, 20.0 - 2.0 * 4.0, 1e-2) << "the recording stands";
  EXPECT_NEAR(braker.pose.y, 3.5, 1e-3);
  EXPECT_NEAR(braker.velocity.x(), -4.0, 1e-2);
  EXPECT_NEAR(stateAfter(20, "attacker", file).pose.x, 10.0, 1e-9);
}

TEST(BackgroundModel, ReceivesTheStepAndTheEgo) {
  // Every agent goes to a place in the ego's frame that the step and the number of known ego frames
  // give.
  const ScriptFile file(
      "    count = ego_history[:, 5].sum()\n"
      "    place = torch.stack([10.0 * step[0], count, 0.0 * count])\n"
      "    return place.expand(64, 3)\n",
      kTrafficArguments);
  const Pose2 expected = compose({0.0, 0.0, 0.3}, {1.0, 2.0, 0.0});
  const Pose2 pose = stateAfter(6, "braker", file).pose;
  EXPECT_LT((pose.position() - expected.position()).norm(), 1e-4);
}

TEST(BackgroundModel, DependsOnItsInputsAlone) {
  const ScriptFile file(
      "    self.count += 1.0\n"
      "    return agents[:, -1, 0:3] + torch.rand([64, 3]) + self.count\n",
      kTrafficArguments);
  BackgroundModel model(trafficOptions(file), std::make_shared<const LaneIndex>(twoLaneRoad()));
  const std::vector<TrajectoryPoint> ego = {{kNow, {}, 0.0, 0.0, 0.0}};
  const std::vector<Track> agents = {straightCar("a", {5.0, 0.0, 0.0}, 1.0).first};
  const Pose2 first = model.next(ego, agents, 0.1).at("a");
  EXPECT_EQ(model.next(ego, agents, 0.1).at("a").x, first.x);
}

TEST(BackgroundModel, TheExampleStopsBehindAStandingEgo) {
  std::ifstream example(COLLISION_FORGE_SOURCE_DIR "/examples/export_traffic_model.py");
  std::string methods;
  for (std::string line; std::getline(example, line) && line.rfind("def main", 0) != 0;) {
    const bool is_in_method = !methods.empty() || line.rfind("    def forward", 0) == 0;
    if (is_in_method) methods += (line.empty() ? line : line.substr(4)) + "\n";
  }
  torch::jit::Module module("FollowAhead");
  module.define(methods);
  const ScriptFile file(kSteadyTraffic, kTrafficArguments);
  module.save(file.path());
  const CrashScenario scenario = roadScenario(5.0, straightDrive({0.0, 100.0, 0.0}, 5.0, 8.0),
                                              {straightCar("behind", {-30.0, 0.0, 0.0}, 8.0),
                                               straightCar("beside", {-30.0, 7.0, 0.0}, 8.0)});
  const double behind = stateAfter(70, "behind", file, scenario).pose.x;
  EXPECT_LT(behind, -0.5 * (kEgoSize.length + kCarSize.length));
  EXPECT_GT(behind, -20.0);
  EXPECT_NEAR(stateAfter(70, "beside", file, scenario).pose.x, -30.0 + 7.0 * 8.0, 0.1);
}

TEST(BackgroundModel, AnUnfitFileIsRejectedByName) {
  const auto refusalOf = [](const ScriptFile& file) {
    try {
      stateAfter(1, "braker", file);
      return std::string();
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr(file.path()));
      return std::string(error.what());
    }
  };
  EXPECT_THAT(refusalOf(ScriptFile(kConstantVelocity)), HasSubstr("route, not step"));
  EXPECT_THAT(refusalOf(ScriptFile("    return torch.zeros([64, 2])\n", kTrafficArguments)),
              HasSubstr("[64, 2], not [64, 3]"));
  EXPECT_THAT(refusalOf(ScriptFile("    pose = agents[:, -1, 0:3]\n"
                                   "    return pose / (1.0 if bool(pose[0, 0] < 2.0) else 0.0)\n",
                                   kTrafficArguments)),
              HasSubstr("agent 1 in the output is not finite"));
}

}  // namespace
}  // namespace forge
