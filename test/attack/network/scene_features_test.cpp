#include "collision_forge/attack/network/scene_features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "attack/network/sample_network.h"

namespace forge {
namespace {

constexpr float kTolerance = 1e-5F;

SceneFeatures featuresOf(const Snapshot& snapshot, const std::set<std::string>& hidden = {},
                         const PatternFeatureOptions& options = smallFeatures()) {
  return sceneFeatures(observedSnapshot(snapshot, hidden), lanesOf(snapshot), options);
}

TEST(ObservedSnapshot, VelocitiesAreBackwardDifferences) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.agents[0].states.back().velocity = {99.0, 99.0};
  const Snapshot observed = observedSnapshot(snapshot, {});
  EXPECT_NEAR(observed.agents[0].states.back().velocity.x(), 6.0, 1e-9);
  EXPECT_NEAR(observed.agents[0].states.back().velocity.y(), 0.0, 1e-9);
}

TEST(ObservedSnapshot, KeepsOneStateOfAgentsWithHiddenHistory) {
  const Snapshot observed = observedSnapshot(junctionSnapshot(), {"oncoming"});
  ASSERT_EQ(observed.agents[1].states.size(), 1U);
  EXPECT_NEAR(observed.agents[1].states[0].velocity.x(), -9.0, 1e-9);
  EXPECT_EQ(observed.agents[0].states.size(), 8U);
}

TEST(SceneFeatures, AreInTheFrameOfTheEgo) {
  const SceneFeatures features = featuresOf(junctionSnapshot());
  // the ego now: at the origin, 8 m/s ahead
  const Eigen::RowVectorXf ego = features.agents.row(7);
  EXPECT_NEAR(ego[0], 0.0F, kTolerance);
  EXPECT_NEAR(ego[2], 1.0F, kTolerance);
  EXPECT_NEAR(ego[4], 0.8F, kTolerance);
  EXPECT_NEAR(ego[7], 1.0F, kTolerance);
  // the nearest other one: 25 m ahead at 6 m/s
  const Eigen::RowVectorXf ahead = features.agents.row(15);
  EXPECT_NEAR(ahead[0], 25.0F / 30.0F, kTolerance);
  EXPECT_NEAR(ahead[4], 0.6F, kTolerance);
  EXPECT_NEAR(ahead[7], 0.0F, kTolerance);
  // 1.5 s earlier it was 9 m behind that
  EXPECT_NEAR(features.agents(12, 0), 16.0F / 30.0F, kTolerance);
  EXPECT_NEAR(features.ego[0], 0.8F, kTolerance);
  EXPECT_NEAR(features.ego[5], 0.0F, kTolerance);
}

TEST(SceneFeatures, MissingFramesAreMasked) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.agents[0].states.erase(snapshot.agents[0].states.begin(),
                                  snapshot.agents[0].states.begin() + 5);
  const SceneFeatures features = featuresOf(snapshot);
  EXPECT_EQ(features.agent_mask.segment(8, 5).sum(), 0.0F);
  EXPECT_EQ(features.agent_mask.segment(13, 3).sum(), 3.0F);
  EXPECT_EQ(features.agents.middleRows(8, 5).cwiseAbs().sum(), 0.0F);
}

TEST(SceneFeatures, HiddenHistoryChangesNothing) {
  Snapshot other = junctionSnapshot();
  for (std::size_t i = 0; i + 2 < other.agents[1].states.size(); ++i) {
    other.agents[1].states[i].pose.x += 10.0 + static_cast<double>(i);
  }
  const SceneFeatures a = featuresOf(junctionSnapshot(), {"oncoming"});
  const SceneFeatures b = featuresOf(other, {"oncoming"});
  EXPECT_EQ(a.agents, b.agents);
  EXPECT_EQ(a.agent_mask, b.agent_mask);
  EXPECT_NE(featuresOf(other).agents, featuresOf(junctionSnapshot()).agents);
}

TEST(SceneFeatures, AgentFramesLimitTheHistoryOfOtherAgents) {
  PatternFeatureOptions options = smallFeatures();
  options.agent_frames = 1;
  const SceneFeatures features = featuresOf(junctionSnapshot(), {}, options);
  EXPECT_EQ(features.agent_mask.head(8).sum(), 8.0F);
  EXPECT_EQ(features.agent_mask.segment(8, 8).sum(), 1.0F);
}

/// Rows of the lane whose first point is at (x, y) in the map.
Eigen::Index laneAt(const SceneFeatures& features, double x, double y) {
  const Eigen::Index points = smallFeatures().encoding.lane_points;
  for (Eigen::Index row = 0; row < features.lanes.rows(); row += points) {
    const double dx = static_cast<double>(features.lanes(row, 0)) * 30.0 - 30.0 - x;
    const double dy = static_cast<double>(features.lanes(row, 1)) * 30.0 - 1.75 - y;
    if (features.lane_mask[row] > 0.0F && std::hypot(dx, dy) < 1e-3) return row;
  }
  ADD_FAILURE() << "no lane at " << x << ' ' << y;
  return 0;
}

TEST(SceneFeatures, LanesEncodeTheirLinks) {
  Snapshot snapshot = junctionSnapshot();
  auto map = fourWayJunction();
  map->lanes[0].outgoing = {"east_through", "left", "right"};
  map->lanes[1].is_intersection = true;
  map->lanes[1].incoming = {"east_in"};
  Lane left = straightLane("left", {-10.0, -1.75}, {1.75, 10.0});
  left.centerline.push_back({1.75, 12.0, M_PI_2});
  Lane right = straightLane("right", {-10.0, -1.75}, {-1.75, -10.0});
  right.centerline.push_back({-1.75, -12.0, -M_PI_2});
  map->lanes.push_back(left);
  map->lanes.push_back(right);
  snapshot.map = map;
  PatternFeatureOptions options = smallFeatures();
  options.encoding.max_lanes = 8;
  const SceneFeatures features = featuresOf(snapshot, {}, options);
  const Eigen::RowVectorXf in = features.lanes.row(laneAt(features, -200.0, -1.75));
  EXPECT_NEAR(in[7], 1.0F, kTolerance);  // three follow
  EXPECT_NEAR(in[8], 0.0F, kTolerance);
  EXPECT_NEAR(in[9], M_PI_2, 1e-3);
  EXPECT_NEAR(in[10], -M_PI_2, 1e-3);
  EXPECT_EQ(in[11], 1.0F);
  const Eigen::RowVectorXf through = features.lanes.row(laneAt(features, -10.0, -1.75));
  EXPECT_NEAR(through[7], 1.0F / 3.0F, kTolerance);
  EXPECT_NEAR(through[8], 1.0F / 3.0F, kTolerance);
  EXPECT_NEAR(through[9], 0.0F, kTolerance);
  EXPECT_EQ(through[11], 0.0F);
  const Eigen::RowVectorXf west = features.lanes.row(laneAt(features, 200.0, 1.75));
  EXPECT_EQ(west.tail(5).cwiseAbs().sum(), 0.0F);
}

TEST(SceneFeatures, RejectNumbersThatAreNotFinite) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.agents[2].states[3].pose.y = std::numeric_limits<double>::quiet_NaN();
  try {
    featuresOf(snapshot);
    FAIL() << "no complaint";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("crossing"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace forge
