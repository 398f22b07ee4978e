#include "collision_forge/attack/forecast/options.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

TEST(ForecastOptions, HistoryLengthIsThePapers) {
  constexpr double kFrameInterval = 0.5;  // s
  constexpr double kHistory = 3.5;        // s before now; arXiv 2510.12206, Sec. 4
  const PredictionOptions options = shippedOptions().prediction;
  EXPECT_EQ((options.history_frames - 1) * kFrameInterval, kHistory);
  EXPECT_LE(options.motion_frames, options.history_frames);
}

TEST(ForecastOptions, HalfOfTheEgosFuturesIsHeldOut) {
  EXPECT_EQ(shippedOptions().prediction.ego_samples % 2, 0);
}

TEST(ForecastOptions, AllFuturesHaveTheSameSteps) {
  EXPECT_EQ(shippedOptions().ego_futures.step, shippedOptions().prediction.step);
}

TEST(ForecastOptions, AFittedModelReachesTheLongestRequest) {
  const StudyConfig config = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  EXPECT_GE(config.speed_model_fit.intervals * kProfileStep, config.attack.prediction.max_tta);
}

TEST(ForecastOptions, ModelsAreComparedByEveryFeature) {
  const StudyConfig config = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  for (const double weight : config.speed_model_fit.feature_weights) EXPECT_GT(weight, 0.0);
}

}  // namespace
}  // namespace forge
