#include "collision_forge/planner_test/trials/planner_case.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

const Config& config() {
  static const Config loaded = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return loaded;
}

IndexedScene straightScene() {
  Scene scene;
  scene.name = "scene-0001";
  scene.map = twoLaneRoad();
  scene.ego = straightTrack(kEgoId, kEgoSize, {}, 8.0, kNow, kNow - 4.0, kNow + 10.0);
  scene.agents = {
      straightTrack("other", kCarSize, {40.0, 3.5, M_PI}, 5.0, kNow, kNow - 4.0, kNow + 10.0)};
  for (const AgentState& state : scene.ego.states) scene.frame_times.push_back(state.time);
  return {scene, std::make_shared<const LaneIndex>(scene.map)};
}

Scenario answered() {
  Scenario scenario;
  scenario.asked = {"scene-0001", kNow, {}};
  scenario.asked.request.type = CollisionType::kOppositeDirection;
  scenario.ego = {kEgoSize, 1.385};
  scenario.answer.trajectory = straightDrive({40.0, 0.0, M_PI}, 5.0, 6.0);
  scenario.answer.trajectory.attacker_id = "other";
  scenario.answer.aim.time = kNow + 3.0;
  return scenario;
}

TEST(PlannerCase, AnAnswerComesWithItsScene) {
  const PlannerCase one = caseOfScenario(answered(), straightScene(), config());
  EXPECT_EQ(one.status.code, StatusCode::kOk);
  EXPECT_EQ(one.scene, "scene-0001");
  EXPECT_EQ(one.scenario.snapshot.now, kNow);
  EXPECT_EQ(one.scenario.recorded.ego.states.front().time, kNow);
  EXPECT_EQ(one.scenario.type, CollisionType::kOppositeDirection);
  EXPECT_EQ(one.scenario.attacker.points.size(), 61u);
  EXPECT_EQ(one.pattern.time, kNow + 3.0);
  EXPECT_NO_THROW(checkScenario(one.scenario));
}

TEST(PlannerCase, ADeclinedAnswerKeepsItsStatus) {
  Scenario scenario = answered();
  scenario.answer.status = {StatusCode::kLowConfidence, "no"};
  const PlannerCase one = caseOfScenario(scenario, straightScene(), config());
  EXPECT_EQ(one.status.code, StatusCode::kLowConfidence);
  EXPECT_EQ(one.scenario.snapshot.now, kNow);
  EXPECT_TRUE(one.scenario.attacker.points.empty());
}

TEST(PlannerCase, ATimeThatIsNoFrameHasNoScene) {
  Scenario scenario = answered();
  scenario.asked.now += 0.2;
  const PlannerCase one = caseOfScenario(scenario, straightScene(), config());
  EXPECT_EQ(one.status.code, StatusCode::kNoScene);
  EXPECT_EQ(one.scenario.snapshot.now, kNow + 0.2);
}

}  // namespace
}  // namespace forge
