#include "collision_forge/study/dataset/options.h"

#include <gtest/gtest.h>

#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

const StudyConfig kShipped = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
const DatasetOptions& kOptions = kShipped.dataset;

TEST(DatasetOptions, ClipLengthsAreValidTtas) {
  constexpr double kHistory = 3.5;  // s of a clip before now
  EXPECT_GE(kOptions.min_length - kHistory, kShipped.attack.prediction.min_tta);
  EXPECT_LE(kOptions.max_length - kHistory, kShipped.attack.prediction.max_tta);
}

TEST(DatasetOptions, RareTypesHaveMoreAttempts) {
  EXPECT_GT(kOptions.attempts.at(CollisionType::kLtap),
            kOptions.attempts.at(CollisionType::kRearEnd));
  EXPECT_EQ(kOptions.attempts.size(), std::size(kCollisionTypes));
}

TEST(DatasetOptions, SplitSharesEqualCollides) {
  constexpr double kTrain = 6017.0;  // clips
  constexpr double kVal = 858.0;
  constexpr double kTest = 1697.0;
  EXPECT_NEAR(kOptions.split.train_share, kTrain / (kTrain + kVal + kTest), 0.01);
  EXPECT_NEAR(kOptions.split.val_share, kVal / (kTrain + kVal + kTest), 0.01);
}

TEST(DatasetOptions, TimeToleranceIsStricterThanForRequests) {
  EXPECT_LT(kOptions.time_tolerance, kShipped.crash.time_tolerance);
}

}  // namespace
}  // namespace forge
