#include "collision_forge/study/generators/mid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

std::shared_ptr<TrafficGenerator> makeSeeded(const GeneratorOptions& options) {
  torch::manual_seed(0);
  return makeMid(options.c_mid, options.traffic, torch::kCPU);
}

TrafficBatch sampleHistory(const std::vector<TrafficClip>& clips, const TrafficOptions& options) {
  return historyOf(sampleBatch(clips, options), options.history_frames);
}

/// Sample clips that swerve after t0; every second one has another type and swerves to the right.
std::vector<TrafficClip> swervingClips(const TrafficOptions& options, int count) {
  std::vector<TrafficClip> clips = sampleClips(options, count);
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (i % 2 == 1) clips[i].type = CollisionType::kJunctionCrossing;
    for (AgentFrames& frames : clips[i].agents) {
      for (std::size_t t = 8; t < frames.size(); ++t) {
        frames[t]->y += (i % 2 == 0 ? 0.3 : -0.3) * std::pow(static_cast<double>(t) - 7.0, 2);
      }
    }
  }
  return clips;
}

/// Copies the weights of one network to another of the same size.
void copyNetwork(const TrafficGenerator& from, TrafficGenerator& to) {
  const torch::NoGradGuard no_gradients;
  const auto source = from.network()->parameters();
  const auto sink = to.network()->parameters();
  for (std::size_t i = 0; i < source.size(); ++i) sink[i].copy_(source[i]);
}

TEST(NoiseSchedule, EqualsThePublishedOne) {
  const NoiseSchedule schedule = noiseSchedule(shippedConfig().generators.c_mid);
  ASSERT_EQ(schedule.alpha_bar.size(), 101u);
  EXPECT_EQ(schedule.alpha_bar[0], 1.0);
  EXPECT_DOUBLE_EQ(schedule.beta[1], 1e-4);
  EXPECT_DOUBLE_EQ(schedule.beta[100], 5e-2);
  // of MID's models/diffusion.py, linear
  EXPECT_NEAR(schedule.alpha_bar[1], 0.9999, 1e-4);
  EXPECT_NEAR(schedule.alpha_bar[20], 0.9066, 1e-4);
  EXPECT_NEAR(schedule.alpha_bar[50], 0.5338, 1e-4);
  EXPECT_NEAR(schedule.alpha_bar[100], 0.0782, 1e-4);
}

TEST(Mid, HasThePublishedNumberOfWeightsAtPublishedSizes) {
  GeneratorOptions options = blindOptions();
  options.c_mid.width = 512;
  options.c_mid.layers = 3;
  options.c_mid.heads = 4;
  options.c_mid.feed_forward = 1024;
  options.c_mid.encoder = 128;
  const auto mid = makeMid(options.c_mid, options.traffic, torch::kCPU);
  long count = 0;
  for (const torch::Tensor& parameter : mid->network()->parameters()) count += parameter.numel();
  // 6,940,432 of MID's denoiser and 142,336 of its two LSTMs; 6 numbers more into gate and shift
  // of each layer's outputs
  EXPECT_EQ(count, 6940432 + 142336 + 6 * 2 * (512 + 256 + 128 + 2));
}

TEST(Mid, OverfitsAFewClips) {
  GeneratorOptions options = blindOptions();
  options.c_mid.dropout = 0.0;
  options.c_mid.encoder_dropout = 0.0;
  options.c_mid.encoder = 32;
  options.c_mid.width = 64;
  options.c_mid.layers = 1;
  const auto mid = makeSeeded(options);
  std::vector<TrafficClip> clips;  // each four times, for so many steps of the diffusion at once
  for (int i = 0; i < 4; ++i) {
    for (const TrafficClip& clip : swervingClips(options.traffic, 4)) clips.push_back(clip);
  }
  const TrafficBatch batch = sampleBatch(clips, options.traffic);
  EXPECT_GT(driveError(*mid, batch, options.traffic), 1.0);
  mid->network()->train();
  for (int step = 0; step < 300; ++step) {
    const std::vector<double> losses = mid->trainStep(batch);
    ASSERT_EQ(losses.size(), mid->lossNames().size());
    ASSERT_TRUE(std::isfinite(losses[0]));
  }
  EXPECT_LT(driveError(*mid, batch, options.traffic), 0.5) << "by DDIM";
  options.c_mid.sampling_steps = options.c_mid.diffusion_steps;
  const auto slow = makeSeeded(options);
  copyNetwork(*mid, *slow);
  EXPECT_LT(driveError(*slow, batch, options.traffic), 0.5) << "by DDPM";
}

TEST(Mid, IsEquivariantToMotionsOfTheScene) {
  const GeneratorOptions options = blindOptions();
  const auto mid = makeSeeded(options);
  const TrafficBatch history = sampleHistory(sampleClips(options.traffic, 2), options.traffic);
  const double angle = 2.0;
  const torch::Tensor turn =
      torch::tensor({std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle)})
          .view({2, 2})
          .to(torch::kFloat);
  const torch::Tensor shift = torch::tensor({30.0f, -20.0f});
  const auto moved = [&](const torch::Tensor& poses) {
    return torch::cat({poses.slice(3, 0, 2).matmul(turn) + shift, poses.slice(3, 2) + angle}, 3);
  };
  TrafficBatch elsewhere = history;
  elsewhere.poses = moved(history.poses);
  const torch::Tensor expected = moved(mid->predict(history, noiseOf(5)));
  const torch::Tensor driven = mid->predict(elsewhere, noiseOf(5));
  const torch::Tensor apart = driven - expected;
  EXPECT_LT(apart.slice(3, 0, 2).abs().max().item<double>(), 1e-3);
  EXPECT_LT((apart.slice(3, 2) / 2.0).sin().abs().max().item<double>(), 1e-3);
}

TEST(Mid, AgentsWithoutFullHistoryAreNoNeighbours) {
  const GeneratorOptions options = blindOptions();
  const auto mid = makeSeeded(options);
  std::vector<TrafficClip> clips = sampleClips(options.traffic, 1);
  const auto driven = [&] {
    const TrafficBatch history = batchOf({{&clips[0], 7}}, options.traffic, 0);
    return mid->predict(history, noiseOf(5)).slice(1, 0, 2).clone();
  };
  const auto drivenWith = [&](double x) {
    for (auto& pose : clips[0].agents[2]) {
      if (pose) pose->x = x;
    }
    return driven();
  };
  const torch::Tensor alone = driven();
  clips[0].agents.push_back(clips[0].agents[1]);
  clips[0].agents[2][0].reset();
  EXPECT_TRUE(torch::equal(drivenWith(3.0), alone));
  EXPECT_TRUE(torch::equal(drivenWith(40.0), alone));
  clips[0].agents[2][0] = clips[0].agents[2][1];
  const torch::Tensor in_company = drivenWith(40.0);
  EXPECT_FALSE(torch::equal(drivenWith(3.0), in_company));
}

TEST(Mid, UsesOnlyNeighboursWithinReach) {
  const GeneratorOptions options = blindOptions();
  const auto mid = makeSeeded(options);
  std::vector<TrafficClip> clips = sampleClips(options.traffic, 1);
  const auto egoWithAttackerAt = [&](double y) {
    for (auto& pose : clips[0].agents[kAttackerAgent]) pose->y = y;
    const TrafficBatch history = batchOf({{&clips[0], 7}}, options.traffic, 0);
    return mid->predict(history, noiseOf(5)).select(1, kEgoAgent).clone();
  };
  const double reach = options.c_mid.neighbour_reach;
  EXPECT_FALSE(torch::equal(egoWithAttackerAt(0.3 * reach), egoWithAttackerAt(0.4 * reach)));
  EXPECT_TRUE(torch::equal(egoWithAttackerAt(1.3 * reach), egoWithAttackerAt(1.4 * reach)));
}

TEST(Mid, DependsOnTypeAndTime) {
  const GeneratorOptions options = blindOptions();
  const auto mid = makeSeeded(options);
  const TrafficBatch history = sampleHistory(sampleClips(options.traffic, 1), options.traffic);
  const torch::Tensor driven = mid->predict(history, noiseOf(5));
  for (int number = 0; number < kConditionNumbers; ++number) {
    TrafficBatch other = history;
    other.condition = history.condition.clone();
    other.condition.select(1, number) += 0.5;
    EXPECT_FALSE(torch::equal(mid->predict(other, noiseOf(5)), driven)) << number;
  }
}

TEST(Mid, ThrowsForNonFiniteValues) {
  const GeneratorOptions options = blindOptions();
  const auto mid = makeSeeded(options);
  const TrafficBatch batch = sampleBatch(sampleClips(options.traffic, 1), options.traffic);
  {
    const torch::NoGradGuard no_gradients;
    mid->network()->parameters().back().fill_(std::numeric_limits<float>::quiet_NaN());
  }
  EXPECT_THROW(mid->predict(historyOf(batch, options.traffic.history_frames), noiseOf(5)),
               std::runtime_error);
  EXPECT_THROW(mid->trainStep(batch), std::runtime_error);
}

}  // namespace
}  // namespace forge
