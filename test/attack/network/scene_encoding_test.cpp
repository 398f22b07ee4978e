#include "collision_forge/attack/network/scene_encoding.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

constexpr int kFrames = 3;
constexpr std::size_t kAgentFeatures = 8;
constexpr std::size_t kLaneFeatures = 6;
constexpr float kTolerance = 1e-6F;

AgentState state(double time, const Pose2& pose, const Vector2& velocity) {
  return {time, pose, velocity};
}

/// The ego at (10, 20) drives north at 4 m/s; one agent faces south 6 m ahead and 1 m to the right,
/// seen in the last two of three frames; another was seen only in the first.
Snapshot tinySnapshot() {
  const Pose2 north{10.0, 20.0, M_PI_2};
  Snapshot snapshot;
  snapshot.now = 101.0;
  snapshot.ego = {kEgoId, AgentClass::kCar, {4.0, 2.0}, {}};
  snapshot.ego.states = {state(100.0, {10.0, 16.0, M_PI_2}, {0.0, 4.0}),
                         state(100.5, {10.0, 18.0, M_PI_2}, {0.0, 4.0}),
                         state(101.0, north, {0.0, 4.0})};
  Track oncoming{"oncoming", AgentClass::kTruck, {8.0, 2.5}, {}};
  oncoming.states = {state(100.5, {11.0, 29.0, -M_PI_2}, {0.0, -6.0}),
                     state(101.0, {11.0, 26.0, -M_PI_2}, {0.0, -6.0})};
  Track gone{"gone", AgentClass::kCar, {4.5, 1.8}, {}};
  gone.states = {state(100.0, {7.0, 20.0, 0.0}, {1.0, 0.0})};
  snapshot.agents = {oncoming, gone};
  return snapshot;
}

Lane straightLane(const std::string& id, double x, double start, double end) {
  Lane lane;
  lane.id = id;
  lane.centerline = {{x, start, M_PI_2}, {x, end, M_PI_2}};
  return lane;
}

/// A lane of 3 m beside the ego, a connector of 20 m farther away, one out of reach, one without a
/// centreline.
LaneIndex tinyMap() {
  LaneMap map;
  map.lanes = {straightLane("far", 500.0, 0.0, 50.0), straightLane("connector", 15.0, 20.0, 40.0),
               straightLane("short", 12.0, 20.0, 23.0), Lane{}};
  map.lanes[1].is_connector = true;
  map.lanes[1].is_intersection = true;
  map.lanes[3].id = "no line";
  return LaneIndex(std::make_shared<const LaneMap>(map));
}

EncodingOptions tinyOptions() {
  EncodingOptions options;
  options.lane_radius = 50.0;
  options.max_lanes = 8;
  options.lane_points = 4;
  options.lane_point_spacing = 2.0;
  return options;
}

/// One vector of a tensor of three dimensions.
std::vector<float> row(const DenseTensor& tensor, std::size_t first, std::size_t second) {
  const std::size_t width = tensor.shape.at(2);
  const auto begin = tensor.data.begin() +
                     static_cast<std::ptrdiff_t>((first * tensor.shape.at(1) + second) * width);
  return {begin, begin + static_cast<std::ptrdiff_t>(width)};
}

void expectNear(const std::vector<float>& actual, const std::vector<float>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_NEAR(actual[i], expected[i], kTolerance) << "feature " << i;
  }
}

TEST(SceneEncoding, PutsAgentsIntoTheFrameOfTheEgoNow) {
  const SceneEncoding encoding = encodeScene(tinySnapshot(), tinyMap(), kFrames, tinyOptions());
  EXPECT_EQ(encoding.agent_features.shape,
            (std::vector<std::uint32_t>{3, kFrames, kAgentFeatures}));
  ASSERT_EQ(encoding.agent_features.data.size(), 3U * kFrames * kAgentFeatures);
  // x, y, cos yaw, sin yaw, vx, vy, length, width
  expectNear(row(encoding.agent_features, 0, 0), {-4, 0, 1, 0, 4, 0, 4, 2});
  expectNear(row(encoding.agent_features, 0, 1), {-2, 0, 1, 0, 4, 0, 4, 2});
  expectNear(row(encoding.agent_features, 0, 2), {0, 0, 1, 0, 4, 0, 4, 2});
  expectNear(row(encoding.agent_features, 1, 1), {9, -1, -1, 0, -6, 0, 8, 2.5F});
  expectNear(row(encoding.agent_features, 1, 2), {6, -1, -1, 0, -6, 0, 8, 2.5F});
  expectNear(row(encoding.agent_features, 2, 0), {0, 3, 0, -1, 0, -1, 4.5F, 1.8F});
}

TEST(SceneEncoding, TurnsByAnyAngle) {
  Snapshot snapshot = tinySnapshot();
  snapshot.ego.states.back().pose.yaw = M_PI / 6.0;
  const SceneEncoding encoding = encodeScene(snapshot, tinyMap(), kFrames, tinyOptions());
  const auto c = static_cast<float>(std::cos(M_PI / 6.0));
  const float s = 0.5F;
  expectNear(row(encoding.agent_features, 1, 2),
             {c + 6 * s, -s + 6 * c, -s, -c, -6 * s, -6 * c, 8, 2.5F});
}

TEST(SceneEncoding, SamplesLanesNearestFirst) {
  const SceneEncoding encoding = encodeScene(tinySnapshot(), tinyMap(), kFrames, tinyOptions());
  EXPECT_EQ(encoding.lane_ids, (std::vector<std::string>{"short", "connector"}));
  EXPECT_EQ(encoding.lane_features.shape, (std::vector<std::uint32_t>{2, 4, kLaneFeatures}));
  EXPECT_EQ(encoding.lane_mask.shape, (std::vector<std::uint32_t>{2, 4}));
  EXPECT_EQ(encoding.lane_mask.data, (std::vector<float>{1, 1, 0, 0, 1, 1, 1, 1}));
  // x, y, cos yaw, sin yaw, is_connector, is_intersection
  expectNear(row(encoding.lane_features, 0, 0), {0, -2, 1, 0, 0, 0});
  expectNear(row(encoding.lane_features, 0, 1), {2, -2, 1, 0, 0, 0});
  EXPECT_EQ(row(encoding.lane_features, 0, 2), std::vector<float>(kLaneFeatures, 0.0F));
  expectNear(row(encoding.lane_features, 1, 0), {0, -5, 1, 0, 1, 1});
  expectNear(row(encoding.lane_features, 1, 3), {6, -5, 1, 0, 1, 1});
}

TEST(SceneEncoding, KeepsTheNearestLanesWhenThereAreTooMany) {
  EncodingOptions options = tinyOptions();
  options.max_lanes = 1;
  const SceneEncoding encoding = encodeScene(tinySnapshot(), tinyMap(), kFrames, options);
  EXPECT_EQ(encoding.lane_ids, std::vector<std::string>{"short"});
  EXPECT_EQ(encoding.lane_features.shape.front(), 1U);
}

}  // namespace
}  // namespace forge
