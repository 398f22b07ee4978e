#include "collision_forge/study/evaluation/options.h"

#include <gtest/gtest.h>

#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

const StudyConfig kShipped = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
const EvaluationOptions& kOptions = kShipped.evaluation;

TEST(EvaluationOptions, ClipsAreReadAndJudgedWithTheSameBoxes) {
  EXPECT_EQ(kOptions.published.box.length, kOptions.collide.box.length);
  EXPECT_EQ(kOptions.published.box.width, kOptions.collide.box.width);
}

TEST(EvaluationOptions, ASimilarHeadingIsWithinTenDegrees) {
  EXPECT_NEAR(kOptions.published.similar_heading, 10.0 * M_PI / 180.0, 1e-9);
}

TEST(EvaluationOptions, ThePublishedSearchIsConsistentWithItsProtocol) {
  EXPECT_LT(kOptions.published_search.heading_tolerance, kOptions.published.similar_heading);
  EXPECT_LE(kOptions.published_search.latest,
            kOptions.published.steps_after * 0.5 / kOptions.published.steps_per_interval);
  EXPECT_GT(kOptions.published_search.max_speed, kShipped.attack.verification.limits.max_speed);
}

TEST(ControlOptions, OverlapBandsCoverZeroToOne) {
  EXPECT_EQ(kOptions.controls.overlaps.front(), 0.0);
  EXPECT_EQ(kOptions.controls.overlaps.back(), 1.0);
}

TEST(ControlOptions, BandsHaveAWidth) {
  for (const auto& ends : {kOptions.controls.impact_speeds, kOptions.controls.overlaps}) {
    ASSERT_GE(ends.size(), 2u);
    for (std::size_t i = 1; i < ends.size(); ++i) EXPECT_GT(ends[i], ends[i - 1]);
  }
}

}  // namespace
}  // namespace forge
