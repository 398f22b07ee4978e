#include "collision_forge/trials/planner_case.h"

#include <gtest/gtest.h>

#include "attack/test_scenes.h"
#include "data/collide_fixture.h"

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

CollideClip rearEnd() {
  return straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0, {-14.7, 0.0, 0.0}, 10.0);
}

PlannerCase ofClip(ClipAttacker attacker, const CollideClip& clip = rearEnd(),
                   const std::string& method = "search",
                   ClipAnswers answers = ClipAnswers::kVerified) {
  return caseOfClip(clip, attacker, std::make_shared<const LaneIndex>(twoLaneRoad()),
                    MethodMaker(method, builtInMethods(), config().attack, {}), config(), answers);
}

TEST(PlannerCase, AClipHasTheSetsBoxesAndAttacker) {
  const PlannerCase one = ofClip(ClipAttacker::kRecorded);
  EXPECT_EQ(one.status.code, StatusCode::kOk);
  EXPECT_EQ(one.name, rearEnd().name);
  EXPECT_EQ(one.scene, "scene-0001");
  EXPECT_EQ(one.scenario.ego.size.length, config().evaluation.collide.box.length);
  EXPECT_EQ(one.scenario.attacker.attacker_id, "attacker");
  EXPECT_NEAR(one.scenario.attacker.points.back().time,
              rearEnd().times.back() + config().attack.search.tail, 1e-6);
  EXPECT_EQ(one.pattern.attacker_id, "attacker");
  EXPECT_NEAR(one.pattern.attacker_offset.x, -4.7, 1e-6);
  ASSERT_TRUE(one.clip);
}

TEST(PlannerCase, OursIsSearchedOnTheSetsRequest) {
  const PlannerCase one = ofClip(ClipAttacker::kReplay);
  ASSERT_EQ(one.status.code, StatusCode::kOk) << one.status.message;
  EXPECT_EQ(one.request.mode, Mode::kReplay);
  EXPECT_EQ(one.scenario.attacker.attacker_id, "attacker");
  EXPECT_TRUE(one.scenario.attacker.points.size() > 20u);
}

TEST(PlannerCase, AttackersThatMissAreTestedWhereAllAnswersAre) {
  // The attacker falls behind, and cannot touch the ego at its own speed.
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 11, 8.0, {-14.7, 0.0, 0.0}, 5.0);
  const std::string method = "constant_velocity";
  const PlannerCase verified = ofClip(ClipAttacker::kHistory, clip, method);
  EXPECT_EQ(verified.status.code, StatusCode::kNoAttackWithinLimits);
  const PlannerCase all = ofClip(ClipAttacker::kHistory, clip, method, ClipAnswers::kAll);
  ASSERT_EQ(all.status.code, StatusCode::kOk) << all.status.message;
  ASSERT_FALSE(all.scenario.attacker.points.empty());
  EXPECT_NEAR(all.scenario.attacker.points.front().speed, 5.0, 1e-6);
  ASSERT_TRUE(all.clip);
}

TEST(PlannerCase, AVerifiedAttackIsTheSameWhereAllAnswersAre) {
  const PlannerCase verified = ofClip(ClipAttacker::kReplay);
  const PlannerCase all = ofClip(ClipAttacker::kReplay, rearEnd(), "search", ClipAnswers::kAll);
  ASSERT_EQ(verified.status.code, StatusCode::kOk) << verified.status.message;
  ASSERT_EQ(all.scenario.attacker.points.size(), verified.scenario.attacker.points.size());
  EXPECT_EQ(all.scenario.attacker.points.back().pose.x,
            verified.scenario.attacker.points.back().pose.x);
}

}  // namespace
}  // namespace forge
