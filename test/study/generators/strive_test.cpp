#include "collision_forge/study/generators/strive.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

std::shared_ptr<TrafficGenerator> striveOf(const GeneratorOptions& options) {
  torch::manual_seed(0);
  return makeStrive(options.c_strive, options.traffic, torch::kCPU);
}

TEST(Strive, OverfitsAFewClips) {
  GeneratorOptions options = shippedConfig().generators;
  options.c_strive.learning_rate = 0.002;
  const auto strive = striveOf(options);
  const TrafficBatch batch = sampleBatch(sampleClips(options.traffic, 4), options.traffic);
  const double before = driveError(*strive, batch, options.traffic);
  strive->network()->train();
  for (int step = 0; step < 250; ++step) {
    const std::vector<double> losses = strive->trainStep(batch);
    ASSERT_EQ(losses.size(), strive->lossNames().size());
  }
  EXPECT_GT(before, 1.0);
  EXPECT_LT(driveError(*strive, batch, options.traffic), 0.5);
}

TEST(Strive, AgentsWithoutFullHistorySendNoMessages) {
  const GeneratorOptions options = shippedConfig().generators;
  const auto strive = striveOf(options);
  strive->network()->eval();
  std::vector<TrafficClip> clips = sampleClips(options.traffic, 1);
  clips[0].agents.push_back(clips[0].agents[1]);
  clips[0].agents[2][0].reset();
  const auto drivenWith = [&](double x) {
    for (auto& pose : clips[0].agents[2]) {
      if (pose) pose->x = x;
    }
    const TrafficBatch history = batchOf({{&clips[0], 7}}, options.traffic, 0);
    return strive->predict(history, noiseOf(5)).slice(1, 0, 2).clone();
  };
  EXPECT_TRUE(torch::equal(drivenWith(3.0), drivenWith(40.0)));
}

}  // namespace
}  // namespace forge
