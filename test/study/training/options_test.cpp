#include "collision_forge/study/training/options.h"

#include <gtest/gtest.h>

#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

const char* const kShipped = COLLISION_FORGE_SOURCE_DIR "/config";

TEST(TrainingOptions, TrainingCoversTheTtasOfRequests) {
  const StudyConfig config = loadStudyConfig(kShipped);
  EXPECT_EQ(config.training.max_tta, config.attack.prediction.max_tta);
  EXPECT_EQ(config.pattern_features.history_frames, config.attack.prediction.history_frames);
}

TEST(TrainingOptions, AnchorsCoverTheDistancesOfACityEgo) {
  const PatternFeatureOptions features = loadStudyConfig(kShipped).pattern_features;
  EXPECT_GT(features.way_anchors * (features.spacing_floor + features.spacing_rate), 5.0);
  EXPECT_LE(features.agent_frames, features.history_frames);
}

}  // namespace
}  // namespace forge
