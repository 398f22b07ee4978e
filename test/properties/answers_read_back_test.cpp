// Answers are written, read and verified again: scenario files, messages of bags, ScenarioNet; and
// requests of any kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_forge/data/request_file.h"
#include "collision_forge/data/scenario_file.h"
#include "collision_forge/data/scenario_net_logs.h"
#include "collision_forge/export/scenario_net.h"
#include "collision_forge/ros/conversions.h"
#include "collision_forge/verify/verification.h"
#include "data/nuscenes_fixture.h"
#include "properties/random_scenes.h"

namespace forge {
namespace {

const std::vector<Mode> kBothModes = {Mode::kHistory, Mode::kReplay};
constexpr double kClock = 2e-6;  // s: files and messages have microseconds

void expectSameVerdict(const AttackerTrajectory& read, const AttackerTrajectory& written,
                       const AskedMoment& asked) {
  const CollisionReport before = testedReport(written, asked), after = testedReport(read, asked);
  EXPECT_EQ(after.verified(), before.verified());
  EXPECT_EQ(after.unbelievable, before.unbelievable);
  ASSERT_EQ(after.contact, before.contact);
  if (!before.contact) return;
  EXPECT_NEAR(after.contact_time, before.contact_time, kClock);
}

Scenario scenarioOf(const AskedMoment& asked) {
  return {{asked.recording->scene.name, asked.now, asked.request},
          embeddedConfig().ego_vehicle,
          answerTo(asked)};
}

TEST(AnswersReadBack, OfAScenarioFileTheyAreTheSameLineAndVerdict) {
  forAllCases([](Random& random) {
    const AskedMoment asked = randomRequest(random, kBothModes);
    const Scenario scenario = scenarioOf(asked);
    const std::string line = scenarioLine(scenario);
    const Scenario read = readScenarioLine("here", line, embeddedConfig().input_limits);
    EXPECT_EQ(scenarioLine(read), line);
    if (scenario.answer.status.code != StatusCode::kOk) return;
    expectSameVerdict(read.answer.trajectory, scenario.answer.trajectory, asked);
  });
}

TEST(AnswersReadBack, OfTheMessagesInABagTheyHaveTheSameVerdict) {
  forAllCases([](Random& random) {
    const AskedMoment asked = randomRequest(random, kBothModes);
    const Realization answer = answerTo(asked);
    if (answer.status.code != StatusCode::kOk) return;
    expectSameVerdict(fromMessage(toMessage(answer.trajectory)), answer.trajectory, asked);
  });
}

const Track& trackOf(const Scene& scene, const std::string& id) {
  return *std::find_if(scene.agents.begin(), scene.agents.end(),
                       [&](const Track& agent) { return agent.id == id; });
}

TEST(AnswersReadBack, OfScenarioNetTheBoxesMeetWhenTheyDidToAStep) {
  const TemporaryFolder folder;
  const Config& config = embeddedConfig();
  const auto writer = makeScenarioNetWriter(
      {folder.path(), false, config.exports, config.attack.verification.drivable});
  const LaneArcs no_arcs;
  forAllCases([&](Random& random) {
    const AskedMoment asked = randomRequest(random, kBothModes);
    const Scenario scenario = scenarioOf(asked);
    if (scenario.answer.status.code != StatusCode::kOk) return;
    const CrashRecord record =
        crashRecord(scenario, 1, config.exports.history,
                    {*asked.recording, no_arcs, config.exports, config.attack.verification});
    const std::string path = folder.path() + "/" + writer->write(record).at(0);
    const Scene scene = flattened(readScenarioNet(path, config), {{}, config, {}, {}}).scene;
    const Track& attacker = trackOf(scene, record.attacker.id);
    AttackerTrajectory drive{attacker.id, attacker.agent_class, attacker.size, {}};
    const double begin = scene.ego.states.front().time;
    for (const AgentState& state : attacker.states) {
      if (state.time - begin < record.now) continue;
      drive.points.push_back({state.time, state.pose, 0.0, 0.0, 0.0});
    }
    const auto contact = firstContactTime(drive, scene.ego, drive.points.back().time, 1e-3);
    ASSERT_EQ(contact.has_value(), record.contact.has_value());
    if (!contact) return;
    EXPECT_NEAR(*contact - begin, *record.contact, record.step + kClock);
  });
}

/// Any number that a file can hold, and at times the largest and the smallest.
double anyNumber(Random& random) {
  if (isLikely(random, 0.1)) return std::numeric_limits<double>::max();
  if (isLikely(random, 0.1)) return std::numeric_limits<double>::denorm_min();
  return random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-12.0, 12.0));
}

TEST(AnswersReadBack, AnyRequestIsTheSameLineAgain) {
  forAllCases([](Random& random) {
    SceneRequest asked{"scene-\"\\\n0001", anyNumber(random), {}};
    CollisionRequest& request = asked.request;
    request.type = oneOf(kCollisionTypes, random);
    request.tta = anyNumber(random);
    request.seed = std::numeric_limits<std::uint64_t>::max() - random.index(1000);
    request.crash.believable = isLikely(random, 0.5);
    if (isLikely(random, 0.5)) request.attacker = "\t\xc3\xa4 \"";
    if (isLikely(random, 0.5)) request.attacker_class = oneOf(kAttackerClasses, random);
    if (isLikely(random, 0.5)) request.manoeuvre = oneOf(kManoeuvres, random);
    if (isLikely(random, 0.5)) request.impact_speed = Range{anyNumber(random), anyNumber(random)};
    if (isLikely(random, 0.5)) request.overlap = Range{anyNumber(random), anyNumber(random)};
    const SceneRequest read = readRequestLine("here", requestLine(asked));
    EXPECT_EQ(requestLine(read), requestLine(asked));
    EXPECT_EQ(read.now, asked.now);
    EXPECT_EQ(read.request.tta, request.tta);
    EXPECT_EQ(read.request.seed, request.seed);
    EXPECT_EQ(read.request.attacker, request.attacker);
  });
}

}  // namespace
}  // namespace forge
