#include "collision_forge/study/training/planner_samples.h"

#include <gtest/gtest.h>

#include "collision_forge/planner_test/planners/planner_contract.h"
#include "planner_test/planners/planner_scenes.h"
#include "study/settings/shipped_study.h"

namespace forge {
namespace {

constexpr double kSpeed = 6.0;       // m/s
constexpr std::size_t kFrames = 21;  // every half second, ten seconds in all
constexpr std::size_t kFirst = 1;    // frame that has a motion

/// A scene with an ego that drives east along the right lane at constant speed.
Scene straightScene() {
  Scene scene;
  scene.name = "straight";
  scene.ego.id = kEgoId;
  for (std::size_t i = 0; i < kFrames; ++i) {
    scene.frame_times.push_back(100.0 + 0.5 * static_cast<double>(i));
    scene.ego.states.push_back(
        {scene.frame_times.back(), {0.5 * static_cast<double>(i) * kSpeed, 0.0, 0.0}, {0.0, 0.0}});
  }
  return scene;
}

std::vector<PlannerSample> straightSamples() {
  return plannerSamples(straightScene(), threeLaneRoad(), shippedStudy(), shippedStudy().planners);
}

TEST(PlannerSamples, CoverEveryFrameWithEnoughPastAndFuture) {
  const auto samples = straightSamples();
  const double min_future = shippedStudy().planner_training.min_future;
  ASSERT_EQ(samples.size(),
            kFrames - kFirst - static_cast<std::size_t>(std::ceil(2.0 * min_future)));
  for (const PlannerSample& sample : samples) EXPECT_EQ(sample.scene, "straight");
}

TEST(PlannerSamples, HaveTheFutureUntilTheEndOfTheRecording) {
  const auto samples = straightSamples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t left = 5 * (kFrames - 1 - kFirst - i);  // tenths of a second
    EXPECT_EQ(samples[i].known, std::min(left, kContractPoses)) << i;
    for (std::size_t pose = 0; pose < kContractPoses; ++pose) {
      const double expected =
          pose < samples[i].known ? 0.1 * static_cast<double>(pose + 1) * kSpeed : 0.0;
      EXPECT_NEAR(samples[i].poses[3 * pose], expected, 1e-4);
      EXPECT_NEAR(samples[i].poses[3 * pose + 1], 0.0, 1e-5);
    }
  }
}

TEST(PlannerSamples, EstimateTheMotionOnlyFromThePast) {
  const auto samples = straightSamples();
  const auto speedNow = [](const PlannerSample& sample) {
    return sample.ego_history[(kContractFrames - 1) * kContractEgoNumbers + 3];
  };
  for (const PlannerSample& sample : samples) EXPECT_NEAR(speedNow(sample), kSpeed, 1e-4);
  EXPECT_EQ(samples[3].ego_history[5], 0.0f) << "two seconds ago it had no motion yet";
  EXPECT_EQ(samples[4].ego_history[5], 1.0f);
}

TEST(PlannerSamples, HaveTheRouteAhead) {
  const PlannerSample sample = straightSamples()[3];
  ASSERT_EQ(sample.route.size(), kContractInputs[kRoute].count());
  for (std::size_t i = 0; i < kContractRoutePoints; ++i) {
    EXPECT_NEAR(sample.route[3 * i], 2.0 * static_cast<double>(i), 0.3);
    EXPECT_NEAR(sample.route[3 * i + 1], 0.0, 1e-4);
  }
}

}  // namespace
}  // namespace forge
