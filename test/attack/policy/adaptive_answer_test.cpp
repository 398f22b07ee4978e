#include "collision_forge/attack/policy/adaptive_answer.h"

#include <gtest/gtest.h>

#include "attack/policy/policy_scenes.h"

namespace forge {
namespace {

/// The chase as it was recorded, frames at 2 Hz.
class AdaptiveAnswerTest : public testing::Test {
 protected:
  AdaptiveAnswer ask(const SpeedOf& speed) {
    Scene scene;
    const Track driven = egoAt(speed);
    scene.map = chase_.map;
    scene.ego = chase_.snapshot.ego;
    scene.ego.states.pop_back();
    for (int i = -7; i <= 20; ++i) scene.frame_times.push_back(kNow + 0.5 * i);
    for (int i = 0; i <= 20; ++i) {
      scene.ego.states.push_back(*stateAt(driven, kNow + 0.5 * i - 1e-9 * i));
      scene.ego.states.back().time = kNow + 0.5 * i;
    }
    const Moment moment{chase_.snapshot, recordedFuture(scene, kNow), chase_.lanes};
    return answerAdaptively(searchMethod(shippedOptions()), moment, scene, chase_.ego,
                            chase_.request, shippedSetupOfAttackers());
  }

  Chase chase_;
};

TEST_F(AdaptiveAnswerTest, ReportsTheDriveOverTheRecording) {
  const AdaptiveAnswer answer = ask([](double t) { return std::max(5.0, 8.0 - 1.5 * t); });
  ASSERT_EQ(answer.attack.status.code, StatusCode::kOk) << answer.attack.status.message;
  EXPECT_TRUE(answer.attack.report.verified());
  EXPECT_EQ(answer.plans.front().reason, "initial plan");
  EXPECT_GT(answer.plans.size(), 1u);
  EXPECT_FALSE(answer.milliseconds.empty());
  EXPECT_EQ(withoutMisses(answer, chase_.request).attack.status.code, StatusCode::kOk);
}

TEST_F(AdaptiveAnswerTest, AMissIsRejectedWithTheReason) {
  const AdaptiveAnswer answer = ask([](double t) { return std::min(32.0, 8.0 + 12.0 * t); });
  EXPECT_FALSE(answer.attack.report.contact);
  const AdaptiveAnswer declined = withoutMisses(answer, chase_.request);
  EXPECT_EQ(declined.attack.status.code, StatusCode::kNoAttackWithinLimits);
  EXPECT_NE(declined.attack.status.message.find("missed the ego"), std::string::npos);
  EXPECT_NE(declined.attack.status.message.find(answer.plans.back().reason), std::string::npos);
  EXPECT_TRUE(declined.plans.empty());
}

}  // namespace
}  // namespace forge
