#include "collision_forge/study/evaluation/clip_cases.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/study/settings/study_config.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

const StudyConfig& config() {
  static const StudyConfig loaded = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return loaded;
}

CollideClip rearEnd() {
  return straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0, {-14.7, 0.0, 0.0}, 10.0);
}

PlannerCase ofClip(ClipAttacker attacker, const CollideClip& clip = rearEnd(),
                   const std::string& method = "search",
                   ClipAttacks answers = ClipAttacks::kVerified) {
  return caseOfClip(clip, attacker, std::make_shared<const LaneIndex>(twoLaneRoad()),
                    MethodMaker(method, builtInMethods(), config().attack, {}), config(), answers);
}

TEST(ClipCases, AClipHasTheBoxesAndAttackerOfTheDataSet) {
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
  ASSERT_TRUE(one.published);
}

TEST(ClipCases, AMethodsAttackerIsSearchedForTheRequestOfTheClip) {
  const PlannerCase one = ofClip(ClipAttacker::kReplay);
  ASSERT_EQ(one.status.code, StatusCode::kOk) << one.status.message;
  EXPECT_EQ(one.request.mode, Mode::kReplay);
  EXPECT_EQ(one.scenario.attacker.attacker_id, "attacker");
  EXPECT_TRUE(one.scenario.attacker.points.size() > 20u);
}

TEST(ClipCases, MissingAttackersAreCasesWithAllAnswers) {
  // The attacker falls behind and cannot reach the ego at its speed.
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 11, 8.0, {-14.7, 0.0, 0.0}, 5.0);
  const std::string method = "constant_velocity";
  const PlannerCase verified = ofClip(ClipAttacker::kHistory, clip, method);
  EXPECT_EQ(verified.status.code, StatusCode::kNoAttackWithinLimits);
  const PlannerCase all = ofClip(ClipAttacker::kHistory, clip, method, ClipAttacks::kAll);
  ASSERT_EQ(all.status.code, StatusCode::kOk) << all.status.message;
  ASSERT_FALSE(all.scenario.attacker.points.empty());
  EXPECT_NEAR(all.scenario.attacker.points.front().speed, 5.0, 1e-6);
  ASSERT_TRUE(all.published);
}

TEST(ClipCases, AVerifiedAttackIsTheSameWithAllAnswers) {
  const PlannerCase verified = ofClip(ClipAttacker::kReplay);
  const PlannerCase all = ofClip(ClipAttacker::kReplay, rearEnd(), "search", ClipAttacks::kAll);
  ASSERT_EQ(verified.status.code, StatusCode::kOk) << verified.status.message;
  ASSERT_EQ(all.scenario.attacker.points.size(), verified.scenario.attacker.points.size());
  EXPECT_EQ(all.scenario.attacker.points.back().pose.x,
            verified.scenario.attacker.points.back().pose.x);
}

}  // namespace
}  // namespace forge
