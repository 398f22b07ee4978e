#include "collision_forge/planner_test/report/shell_commands.h"

#include <gmock/gmock.h>

#include "io/logs/nuscenes_fixture.h"
#include "planner_test/report/report_scenes.h"

namespace forge {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

/// An attack at 5 s of the recording, of logs in data/embedded.
std::vector<ShellCommands> commandsOf(const Scenario& scenario, int alternative = 1) {
  return commandsOfAttack(scenario, alternative, 5.0, {"data/embedded", "v1.0-embedded"}, {});
}

TEST(CommandsOfAttack, InjectTheRequestIntoAConvertedBag) {
  Scenario scenario = rearEnd();
  scenario.asked.request.mode = Mode::kReplay;
  scenario.asked.request.tta = 2.5;
  scenario.asked.request.seed = 7;
  EXPECT_EQ(commandsOf(scenario)[0].lines,
            "forge convert --source data/embedded --version v1.0-embedded --scene straight "
            "--out bags\n"
            "forge inject --bag bags/straight.bag --type rear_end --now 5 --tta 2.5 "
            "--mode replay --seed 7 --out attacked.bag --draw attacked");
}

TEST(CommandsOfAttack, ContainTheControlsOfTheRequest) {
  Scenario scenario = rearEnd();
  CollisionRequest& request = scenario.asked.request;
  request.choice = AttackerChoice::kNew;
  request.ego_side = Side::kLeft;
  request.impact_speed = Range{2.0, 9.5};
  request.crash.believable = false;
  EXPECT_THAT(commandsOf(scenario, 3)[0].lines,
              HasSubstr(" --attacker new --believable false --ego-side left --impact-speed 2 9.5 "
                        "--alternative 3 --out "));
  request.attacker = "0c96e8";
  EXPECT_THAT(commandsOf(scenario)[0].lines, HasSubstr(" --attacker 0c96e8 --believable"));
}

TEST(CommandsOfAttack, RegenerateTheLineWithoutTheRecording) {
  const auto commands = commandsOfAttack(rearEnd(), 1, {}, {}, {});
  ASSERT_THAT(commands, SizeIs(1));
  EXPECT_EQ(commands[0].lines,
            "echo '{\"scene\":\"straight\",\"now\":1000,\"type\":\"rear_end\",\"tta\":2,"
            "\"attacker\":null,\"seed\":0}' > request.jsonl\n"
            "forge generate --source SOURCE --requests request.jsonl --mode history "
            "--out answer.jsonl");
}

TEST(CommandsOfAttack, QuoteSpecialCharacters) {
  Scenario scenario = rearEnd();
  scenario.asked.request.attacker = "a'b $(c)";
  EXPECT_THAT(commandsOf(scenario)[0].lines, HasSubstr(R"( --attacker 'a'\''b $(c)' --)"));
}

TEST(CommandsOfTest, TestThePlannerOnThatLineAlone) {
  const ShellCommands commands =
      commandsOfTest("out/my runs.jsonl", 11, {"pdm", PolicyKind::kAdaptive, Background::kIdm},
                     {"data/embedded", ""});
  EXPECT_EQ(commands.lines,
            "sed -n 11p 'out/my runs.jsonl' > one.jsonl\n"
            "forge test --source data/embedded --scenarios one.jsonl --planners pdm "
            "--attacker-policy adaptive --background idm --out one --report one/page");
}

}  // namespace
}  // namespace forge
