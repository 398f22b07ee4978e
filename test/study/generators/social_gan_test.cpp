#include "collision_forge/study/generators/social_gan.h"

#include <gtest/gtest.h>

#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

std::shared_ptr<TrafficGenerator> makeSeeded(const GeneratorOptions& options) {
  torch::manual_seed(0);
  return makeSocialGan(options.c_sgan, options.traffic, torch::kCPU);
}

TEST(SocialGan, HasThePublishedNumberOfWeights) {
  const GeneratorOptions options = blindOptions();
  const auto gan = makeSocialGan(options.c_sgan, options.traffic, torch::kCPU);
  long count = 0;
  for (const torch::Tensor& parameter : gan->network()->parameters()) count += parameter.numel();
  // 60,234 by the sizes of Social-GAN's scripts/run_traj.sh, and 6 numbers more into the decoder
  EXPECT_EQ(count, 60234 + 6 * 4 * 32);
}

TEST(SocialGan, OverfitsAFewClips) {
  GeneratorOptions options = blindOptions();
  options.c_sgan.learning_rate = 0.003;
  options.c_sgan.variety = 2;
  const auto gan = makeSeeded(options);
  const std::vector<TrafficClip> clips = sampleClips(options.traffic, 4);
  const TrafficBatch batch = sampleBatch(clips, options.traffic);
  const double before = driveError(*gan, batch, options.traffic);
  for (int step = 0; step < 600; ++step) {
    const std::vector<double> losses = gan->trainStep(batch);
    ASSERT_EQ(losses.size(), gan->lossNames().size());
    EXPECT_EQ(std::isnan(losses[2]), step % 3 == 2) << "two steps of the judge, one of the driver";
  }
  const double after = driveError(*gan, batch, options.traffic);
  EXPECT_GT(before, 1.0);
  EXPECT_LT(after, 0.5);
}

TEST(SocialGan, AgentsWithoutFullHistoryAreNotPooled) {
  const GeneratorOptions options = blindOptions();
  const auto gan = makeSeeded(options);
  std::vector<TrafficClip> clips = sampleClips(options.traffic, 1);
  clips[0].agents.push_back(clips[0].agents[1]);
  clips[0].agents[2][0].reset();
  const auto drivenWith = [&](double x) {
    for (auto& pose : clips[0].agents[2]) {
      if (pose) pose->x = x;
    }
    const TrafficBatch history = batchOf({{&clips[0], 7}}, options.traffic, 0);
    return gan->predict(history, noiseOf(5)).slice(1, 0, 2).clone();
  };
  EXPECT_TRUE(torch::equal(drivenWith(3.0), drivenWith(40.0)));
  clips[0].agents[2][0] = clips[0].agents[2][1];
  EXPECT_FALSE(torch::equal(drivenWith(3.0), drivenWith(40.0)));
}

}  // namespace
}  // namespace forge
