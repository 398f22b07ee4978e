#include "collision_forge/attack/network/network_ego_futures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/network/sample_network.h"
#include "collision_forge/attack/network/predicted_scene.h"
#include "collision_forge/io/weights/pattern_network_file.h"

namespace forge {
namespace {

constexpr double kHorizon = 6.0;  // s
constexpr int kCount = 128;

std::shared_ptr<const PatternNetwork> networkOf(PatternWeights weights) {
  return std::make_shared<const PatternNetwork>(std::move(weights));
}

/// Spreads of half the anchors' spacing, offsets of none: a sharp network.
PatternWeights modestWeights() {
  PatternWeights weights = randomWeights();
  weights.layers["anchor_last"].matrix *= 0.1F;
  weights.layers["anchor_last"].bias << 0.0F, 0.0F, 0.0F, -0.7F, -2.0F, 0.0F;
  return weights;
}

std::vector<Track> sampled(const std::shared_ptr<const PatternNetwork>& network,
                           const Snapshot& snapshot, std::uint64_t seed = 0,
                           std::optional<CollisionType> known_type = std::nullopt) {
  const LaneIndex lanes = lanesOf(snapshot);
  return NetworkEgoFutures(shippedEgoFutureOptions(), {nullptr, network, known_type})
      .sample(snapshot, lanes, kHorizon, kCount, seed);
}

double drivenAt(const Track& track, double time) {
  double driven = 0.0;
  for (std::size_t i = 1; i < track.states.size() && track.states[i].time <= time + 1e-9; ++i) {
    driven += (track.states[i].pose.position() - track.states[i - 1].pose.position()).norm();
  }
  return driven;
}

TEST(NetworkEgoFutures, DependOnTheSeedOnly) {
  const Snapshot snapshot = junctionSnapshot();
  const auto network = networkOf(modestWeights());
  const auto a = sampled(network, snapshot, 1);
  const auto b = sampled(network, snapshot, 1);
  const auto c = sampled(network, snapshot, 2);
  bool differs = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].states.back().pose.x, b[i].states.back().pose.x);
    differs = differs || a[i].states.back().pose.x != c[i].states.back().pose.x;
  }
  EXPECT_TRUE(differs);
}

/// The tracks drive less than some distances as often as the components say.
void expectSpread(const std::vector<Track>& tracks, const std::vector<EgoComponent>& components) {
  for (const double distance : {22.0, 28.0, 32.0, 36.0, 42.0}) {
    double expected = 0.0;
    for (const EgoComponent& component : components) {
      expected += component.probability /
                  (1.0 + std::exp(-(distance - component.arc_length) / component.along));
    }
    int below = 0;
    for (const Track& track : tracks) below += drivenAt(track, kNow + 4.0) < distance;
    EXPECT_NEAR(below / static_cast<double>(kCount), expected, 0.04) << distance;
  }
}

TEST(NetworkEgoFutures, DistancesFollowTheNetworksDistribution) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.map = emptyMap();  // one way alone
  const auto network = networkOf(modestWeights());
  const LaneIndex lanes = lanesOf(snapshot);
  const PredictedScene scene(*network, snapshot, lanes, kHorizon);
  expectSpread(sampled(network, snapshot), scene.egoAfter(4.0, std::nullopt));
}

TEST(NetworkEgoFutures, DistancesUseTheKnownType) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.map = emptyMap();
  PatternWeights weights = modestWeights();
  weights.layers["request"].matrix *= 200.0F;  // the type weighs
  const auto network = networkOf(weights);
  const LaneIndex lanes = lanesOf(snapshot);
  const PredictedScene scene(*network, snapshot, lanes, kHorizon);
  const auto with_type = scene.egoAfter(4.0, CollisionType::kRearEnd);
  ASSERT_GT(std::abs(medianPose(with_type).x - medianPose(scene.egoAfter(4.0, std::nullopt)).x),
            1.0);
  expectSpread(sampled(network, snapshot, 0, CollisionType::kRearEnd), with_type);
}

TEST(NetworkEgoFutures, AReversingEgoReversesAsWithoutTheNetwork) {
  Snapshot snapshot = junctionSnapshot();
  for (AgentState& state : snapshot.ego.states) state.pose.yaw = wrapAngle(state.pose.yaw + M_PI);
  const auto tracks = sampled(networkOf(modestWeights()), snapshot);
  const auto expected = KinematicEgoFutures(shippedEgoFutureOptions(), nullptr)
                            .sample(snapshot, lanesOf(snapshot), kHorizon, kCount, 0);
  ASSERT_EQ(tracks.size(), expected.size());
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const AgentState& last = tracks[i].states.back();
    EXPECT_EQ(last.pose.x, expected[i].states.back().pose.x);
    EXPECT_LE(last.pose.heading().dot(last.velocity), 1e-6);
  }
}

TEST(NetworkEgoFutures, NeverDriveBackwards) {
  const Snapshot snapshot = junctionSnapshot();
  for (const Track& track : sampled(networkOf(randomWeights(5)), snapshot)) {
    for (const AgentState& state : track.states) {
      EXPECT_GE(state.velocity.dot(state.pose.heading()), -0.1);
    }
  }
}

double chanceOf(const PredictedScene& scene, Eigen::Index way, double instant) {
  double chance = 0.0;
  for (const EgoComponent& component : scene.egoAfter(instant, std::nullopt)) {
    if (component.group == way) chance += component.probability;
  }
  return chance;
}

TEST(NetworkEgoFutures, FollowAPathOfTemporarilyZeroProbability) {
  const Snapshot snapshot = junctionSnapshot();
  const LaneIndex lanes = lanesOf(snapshot);
  const auto network = loadPatternNetwork(COLLISION_FORGE_SOURCE_DIR
                                          "/test/fuzz/cases/weights/way_without_chance.bin");
  const PredictedScene scene(*network, snapshot, lanes, kHorizon);
  ASSERT_GT(chanceOf(scene, 1, 4.0), 0.99);
  ASSERT_EQ(chanceOf(scene, 1, 5.0), 0.0);
  const auto tracks = sampled(network, snapshot);
  ASSERT_EQ(tracks.size(), static_cast<std::size_t>(kCount));
  for (const Track& track : tracks) {
    for (const AgentState& state : track.states) EXPECT_TRUE(state.pose.isFinite());
  }
}

}  // namespace
}  // namespace forge
