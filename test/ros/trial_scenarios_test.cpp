#include "collision_forge/ros/nodes/trial_scenarios.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/io/scenarios/scenario_file.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::HasSubstr;

/// The second line of its file is as long as lines may be, the first is longer.
class TrialScenariosTest : public testing::Test {
 protected:
  TrialScenariosTest() {
    config_.input_limits.max_line = static_cast<int>(line_.size());
    folder_.write("scenarios.jsonl", line_ + " \n" + line_ + "\n");
  }

  static std::string lineOfNoScene() {
    Scenario scenario;
    scenario.asked.scene = "nowhere";
    scenario.ego = {{4.0, 1.7}, 1.0};
    scenario.answer.status = {StatusCode::kNoCandidate, "nobody is near"};
    return scenarioLine(scenario);
  }

  /// What the refusal of a line says.
  std::string refusalOf(const std::string& line) {
    const LogSource logs{COLLISION_FORGE_SOURCE_DIR "/data/embedded", ""};
    TrialScenarios scenarios({logs, folder_.path() + "/scenarios.jsonl", ""}, config_, nullptr);
    try {
      scenarios.ofLine(line);
    } catch (const TestRefusal& refusal) {
      EXPECT_EQ(refusal.code, collision_forge::TestPlanner::Response::UNREADABLE);
      return refusal.what();
    }
    return "";
  }

  const std::string line_ = lineOfNoScene();
  const TemporaryFolder folder_;
  Config config_ = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
};

TEST_F(TrialScenariosTest, LinesAreNoLongerThanTheLimit) {
  EXPECT_THAT(refusalOf("1"), HasSubstr("scenarios.jsonl: line 1: length = "));
  EXPECT_THAT(refusalOf(line_ + " "), HasSubstr("scenario: length = "));
}

TEST_F(TrialScenariosTest, OfALineThatIsTooLongTheNextIsRead) {
  EXPECT_THAT(refusalOf("2"), HasSubstr("scene = \"nowhere\" is not in"));
  EXPECT_THAT(refusalOf(line_), HasSubstr("scene = \"nowhere\" is not in"));
}

}  // namespace
}  // namespace forge
