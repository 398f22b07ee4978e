#include "collision_forge/study/generators/traffic_batch.h"

#include <gtest/gtest.h>

#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

TEST(WindowsOf, CoverAllFramesWithFuture) {
  const TrafficOptions options = withoutLanes(shippedConfig().generators.traffic);
  TrafficClip clip = sampleClips(options, 1).front();  // the crash is in frame 12
  const auto windows = windowsOf(clip, options);
  ASSERT_EQ(windows.size(), 2u);
  EXPECT_EQ(windows.front().now, 7);
  EXPECT_EQ(windows.back().now, 8);
  clip.collision_frame = 9;
  EXPECT_EQ(windowsOf(clip, options).size(), 1u);
}

TEST(BatchOf, IsInTheFrameOfEachWindowsEgo) {
  const TrafficOptions options = withoutLanes(shippedConfig().generators.traffic);
  const TrafficClip clip = sampleClips(options, 1).front();  // ego at 5 m/s, attacker at 9 m/s
  const TrafficBatch batch = batchOf({{&clip, 7}, {&clip, 8}}, options, 4);
  ASSERT_EQ(batch.poses.sizes(), (std::vector<std::int64_t>{2, 2, 12, 3}));
  for (int window = 0; window < 2; ++window) {
    EXPECT_NEAR(batch.poses[window][0][7][0].item<double>(), 0.0, 1e-4);
    EXPECT_NEAR(batch.poses[window][0][9][0].item<double>(), 5.0, 1e-4);
  }
  EXPECT_NEAR(batch.poses[0][1][7][0].item<double>(), -20.0, 1e-4);
  EXPECT_NEAR(batch.poses[1][1][7][0].item<double>(), -18.0, 1e-4);
  EXPECT_EQ(batch.seen.sum().item<double>(), 2 * 2 * 12);
}

TEST(BatchOf, MarksUnobservedAgents) {
  const TrafficOptions options = withoutLanes(shippedConfig().generators.traffic);
  TrafficClip clip = sampleClips(options, 1).front();
  clip.agents[1][3].reset();
  clip.agents[1].resize(10);
  const TrafficBatch batch = batchOf({{&clip, 7}}, options, 4);
  EXPECT_EQ(batch.seen[0][1].sum().item<double>(), 9.0);
  EXPECT_EQ(batch.poses[0][1][3].abs().sum().item<double>(), 0.0);
  const torch::Tensor throughout = seenThroughout(batch, options.history_frames);
  EXPECT_EQ(throughout[0][0].item<double>(), 1.0);
  EXPECT_EQ(throughout[0][1].item<double>(), 0.0);
  EXPECT_EQ(historyOf(batch, options.history_frames).poses.size(2), 8);
}

}  // namespace
}  // namespace forge
