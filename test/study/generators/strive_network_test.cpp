#include "collision_forge/study/generators/strive_network.h"

#include <gtest/gtest.h>

#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

/// Untrained networks with the shipped configuration.
class StriveNets : public testing::Test {
 protected:
  StriveNets() {
    torch::manual_seed(0);
    network_ = std::make_shared<StriveNetwork>(options_.c_strive, options_.traffic);
    network_->eval();
  }

  GeneratorOptions options_ = shippedConfig().generators;
  std::shared_ptr<StriveNetwork> network_;
};

TEST_F(StriveNets, EncodesAndPairsAgentsWithFullHistory) {
  std::vector<TrafficClip> clips = sampleClips(options_.traffic, 2);
  clips[1].agents.push_back(clips[1].agents[1]);
  clips[1].agents.push_back(clips[1].agents[1]);
  clips[1].agents[3][2].reset();
  const TrafficBatch batch = batchOf({{&clips[0], 7}, {&clips[1], 7}}, options_.traffic, 0);
  const StriveScene scene = network_->encode(batch);
  EXPECT_TRUE(torch::equal(scene.window, torch::tensor({0, 0, 1, 1, 1}).to(torch::kLong)));
  EXPECT_TRUE(torch::equal(scene.agent, torch::tensor({0, 1, 0, 1, 2}).to(torch::kLong)));
  EXPECT_EQ(scene.to.size(0), 2 + 6);
  EXPECT_NEAR(scene.speed[0].item<double>(), 5.0, 1e-4) << "that of the first clip's ego";
  EXPECT_NEAR(scene.speed[1].item<double>(), 9.0, 1e-4) << "that of its attacker";
  EXPECT_NEAR(scene.turn[0].item<double>(), 0.0, 1e-4);
}

TEST_F(StriveNets, TheBicycleEqualsThePublishedOne) {
  // (x 0, y 0, h 0, s 10, turn 0.1), length 4.7, a 1, turn's change 0.2: STRIVE's code gives
  // turn 0.2, h 0.212766, s 10.5, x 5.131616, y 1.108613. The last layer of the decoder is made to
  // ask for these, whatever it sees.
  {
    const torch::NoGradGuard no_gradients;
    auto parameters = network_->named_parameters();
    parameters["decoder.say.layers.6.weight"].zero_();
    parameters["decoder.say.layers.6.bias"].copy_(
        torch::tensor({1.0 / options_.c_strive.acceleration_scale,
                       0.4 / 2.0 / options_.c_strive.turn_change_scale})
            .to(torch::kFloat32));
  }
  const std::vector<TrafficClip> clips = sampleClips(options_.traffic, 1);
  StriveScene scene = network_->encode(batchOf({{&clips[0], 7}}, options_.traffic, 0));
  scene.pose = torch::zeros_like(scene.pose);
  scene.speed = torch::full_like(scene.speed, 10.0);
  scene.turn = torch::full_like(scene.turn, 0.1);
  const torch::Tensor driven =
      network_->drive(scene, torch::zeros({2, options_.c_strive.latent}), 1);
  EXPECT_NEAR(driven[0][0][0].item<double>(), 5.131616, 1e-5);
  EXPECT_NEAR(driven[0][0][1].item<double>(), 1.108613, 1e-5);
  EXPECT_NEAR(driven[0][0][2].item<double>(), 0.212766, 1e-5);
}

TEST_F(StriveNets, EncodesAgentsAndLanesRelativeToEachAgent) {
  std::vector<TrafficClip> clips = sampleClips(options_.traffic, 1);
  clips[0].lanes = {{{{0.0, 0.0, 0.3}, {10.0, 3.0, 0.3}, {20.0, 6.0, 0.3}}, false}};
  TrafficBatch batch = batchOf({{&clips[0], 7}}, options_.traffic, 0);
  const StriveScene scene = network_->encode(batch);
  const torch::Tensor latent = torch::zeros({2, options_.c_strive.latent});
  const torch::Tensor driven = network_->drive(scene, latent, 4);
  // the same scene, rotated by 90 degrees and moved
  batch.poses = torch::stack({5.0 - batch.poses.select(3, 1), 7.0 + batch.poses.select(3, 0),
                              batch.poses.select(3, 2) + M_PI_2},
                             3);
  batch.lanes =
      torch::stack({5.0 - batch.lanes.select(3, 1), 7.0 + batch.lanes.select(3, 0),
                    -batch.lanes.select(3, 3), batch.lanes.select(3, 2), batch.lanes.select(3, 4)},
                   3);
  const torch::Tensor turned = network_->drive(network_->encode(batch), latent, 4);
  EXPECT_TRUE(torch::allclose(5.0 - driven.select(2, 1), turned.select(2, 0), 1e-4, 1e-3));
  EXPECT_TRUE(torch::allclose(7.0 + driven.select(2, 0), turned.select(2, 1), 1e-4, 1e-3));
  batch.lanes = torch::zeros({1, 0, options_.traffic.lanes.points, kLaneNumbers});
  batch.lane_seen = torch::zeros({1, 0, options_.traffic.lanes.points});
  const torch::Tensor blind = network_->drive(network_->encode(batch), latent, 4);
  EXPECT_FALSE(torch::allclose(blind, turned, 1e-4, 1e-3)) << "lanes are seen";
}

TEST_F(StriveNets, OverlapIsOneForCoincidingAgents) {
  const std::vector<TrafficClip> clips = sampleClips(options_.traffic, 1);
  const StriveScene scene = network_->encode(batchOf({{&clips[0], 7}}, options_.traffic, 0));
  torch::Tensor poses = torch::zeros({2, 3, 3});
  poses[1][1][0] = 4.7;  // bumper to bumper
  poses[1][2][1] = 1.0;  // half a width to the left
  const torch::Tensor deep = overlapOf(scene, poses, options_.c_strive);
  ASSERT_EQ(deep.sizes(), torch::IntArrayRef({2, 3}));
  EXPECT_NEAR(deep[0][0].item<double>(), 1.0, 1e-3);
  EXPECT_NEAR(deep[0][1].item<double>(), 0.0, 1e-3);
  EXPECT_NEAR(deep[0][2].item<double>(), 0.5, 1e-3);
}

TEST_F(StriveNets, BeyondLanesIsTheDistanceFromTheNearestOne) {
  std::vector<TrafficClip> clips = sampleClips(options_.traffic, 1);
  clips[0].lanes = {{{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}}, false}};
  const TrafficBatch batch = batchOf({{&clips[0], 7}}, options_.traffic, 0);
  const torch::Tensor poses = torch::tensor({2.0f, 2.0f, 0.0f, 2.0f, 8.0f, 0.0f}).view({1, 2, 3});
  const torch::Tensor beyond = beyondLanes(torch::zeros({1}, torch::kLong), batch, poses, 3.0);
  EXPECT_NEAR(beyond[0][0].item<double>(), 0.0, 1e-3);
  EXPECT_NEAR(beyond[0][1].item<double>(), 5.0, 1e-3);
}

}  // namespace
}  // namespace forge
