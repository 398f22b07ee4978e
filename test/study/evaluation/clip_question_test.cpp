#include "collision_forge/study/evaluation/clip_question.h"

#include <gtest/gtest.h>

#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/settings/study_config.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

StudyConfig someConfig() {
  return loadStudyConfig(std::string(COLLISION_FORGE_SOURCE_DIR) + "/config");
}

std::shared_ptr<const LaneIndex> noLanes() {
  return std::make_shared<const LaneIndex>(std::make_shared<const LaneMap>());
}

/// The attacker approaches from behind at 5 m/s relative speed; contact 2 s after t0.
CollideClip rearEnd() {
  return straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0, {-14.7, 0.0, 0.0}, 10.0);
}

TEST(ClipQuestion, RequestsTheClipAtAnyConfidence) {
  StudyConfig config = someConfig();
  config.crash.min_confidence = 0.9;
  config.crash.limits = LimitSet::kDrivable;
  const ClipQuestion question(rearEnd(), noLanes(), Mode::kReplay, config);
  EXPECT_EQ(question.request().type, CollisionType::kRearEnd);
  EXPECT_EQ(question.request().attacker, "attacker");
  EXPECT_NEAR(question.request().tta, 2.0, 1e-6);
  EXPECT_EQ(question.request().mode, Mode::kReplay);
  EXPECT_EQ(question.request().crash.min_confidence, 0.0);
  EXPECT_EQ(question.request().crash.limits, LimitSet::kStrict);
  EXPECT_NEAR(question.moment().snapshot.now, kClipStart + 3.5, 1e-6);
  ASSERT_TRUE(question.moment().recorded);
}

/// Records its arguments.
class Listener : public AttackMethod {
 public:
  Attack answer(const Moment& moment, const CollisionRequest& request) const override {
    ++calls;
    is_shown_what_came = moment.recorded.has_value();
    seed = request.seed;
    return {};
  }
  mutable int calls = 0;
  mutable bool is_shown_what_came = false;
  mutable std::uint64_t seed = 0;
};

TEST(ClipQuestion, PassesTheSeedAndHidesTheFutureInHistoryMode) {
  const StudyConfig config = someConfig();
  const Listener listener;
  ClipQuestion(rearEnd(), noLanes(), Mode::kHistory, config).ask(listener, 7);
  EXPECT_EQ(listener.seed, 7u);
  EXPECT_FALSE(listener.is_shown_what_came);
  ClipQuestion(rearEnd(), noLanes(), Mode::kReplay, config).ask(listener, 8);
  EXPECT_EQ(listener.seed, 8u);
  EXPECT_TRUE(listener.is_shown_what_came);
}

TEST(ClipQuestion, InvalidRequestsAreRejectedOnlyForSeededMethods) {
  const StudyConfig config = someConfig();
  const int too_late =
      kCollideNowFrame + static_cast<int>(config.attack.prediction.max_tta / 0.5) + 2;
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, too_late, 5.0, {-14.7, 0.0, 0.0}, 6.0);
  const ClipQuestion question(clip, noLanes(), Mode::kHistory, config);
  const MethodMaker search("search", builtInMethods(), config.attack, {});
  const MethodMaker baseline("constant_velocity", builtInMethods(), config.attack, {});
  const Listener listener;
  EXPECT_EQ(question.check(search).code, StatusCode::kTtaOutOfRange);
  EXPECT_EQ(question.answer(search, listener, 0).status.code, StatusCode::kTtaOutOfRange);
  EXPECT_EQ(listener.calls, 0);
  EXPECT_EQ(question.check(baseline).code, StatusCode::kOk);
  EXPECT_EQ(question.answer(baseline, listener, 0).status.code, StatusCode::kOk);
  EXPECT_EQ(listener.calls, 1);
}

TEST(ClipMethod, UsesModelsOfTheSceneOnlyWithSeenScenes) {
  const StudyConfig config = someConfig();
  const PredictionModels models = loadPredictionModels(config);
  const MethodRegistry methods = builtInMethods();
  const ClipEvaluationSetup setup{methods, models, config};
  CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, 15, 8.0, {-20.0, 0.3, 0.0}, 10.0);
  clip.scene = models.network->folds().back()->weights().left_out_scenes.front();
  const ClipQuestion question(clip, noLanes(), Mode::kHistory, config);
  const auto endWith = [&](const MethodMaker& maker) {
    return question.answer(maker, *maker.make(), 0).trajectory.points.back().pose.x;
  };
  const double unseen = endWith(clipMethod("network", clip, setup, false));
  const double seen = endWith(clipMethod("network", clip, setup, true));
  EXPECT_NE(unseen, seen);
  const MethodMaker of_all("network", methods, config.attack, models);
  EXPECT_EQ(unseen, question.answer(of_all, *of_all.makeWithoutScene(clip.scene), 0)
                        .trajectory.points.back()
                        .pose.x);
}

}  // namespace
}  // namespace forge
