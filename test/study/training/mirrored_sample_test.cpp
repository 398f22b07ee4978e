#include "collision_forge/study/training/mirrored_sample.h"

#include <gtest/gtest.h>

#include "attack/network/sample_network.h"

namespace forge {
namespace {

constexpr float kTolerance = 1e-4F;
constexpr double kTta = 3.0;  // s

/// The ego in a bend before a fork, with a vehicle beside it: a scene without mirror symmetry.
Snapshot bentSnapshot(double side) {
  auto map = emptyMap();
  Lane in;
  in.id = "in";
  in.outgoing = {"on", "off"};
  for (int i = 0; i <= 20; ++i) {
    const double yaw = side * 0.02 * i;
    in.centerline.push_back({2.0 * i, side * 0.02 * i * i, yaw});
  }
  const Pose2 end = in.centerline.back();
  const auto ahead = [&](double distance, double yaw) {
    return Vector2(end.position() + distance * Pose2{0.0, 0.0, yaw}.heading());
  };
  map->lanes = {in, straightLane("on", end.position(), ahead(80.0, end.yaw)),
                straightLane("off", end.position(), ahead(80.0, end.yaw + side * 0.5))};
  map->lanes[2].is_intersection = true;
  Snapshot snapshot =
      snapshotOf(pastTrack(kEgoId, kEgoSize, {4.0, side * 0.3, side * 0.05}, 8.0),
                 {pastTrack("beside", kCarSize, {12.0, side * 6.0, side}, 5.0)}, map);
  for (std::size_t i = 0; i < 4; ++i) snapshot.ego.states[i].pose.y += side * 0.4;
  for (std::size_t i = 0; i < 7; ++i) snapshot.ego.states[i].pose.yaw -= side * 0.05;
  return snapshot;
}

PatternFeatureOptions optionsOf(EgoHead head) {
  PatternFeatureOptions options = smallFeatures();
  options.head = head;
  return options;
}

AnchorFeatures anchorsOf(const Snapshot& snapshot, EgoHead head) {
  const PatternFeatureOptions options = optionsOf(head);
  const LaneIndex lanes = lanesOf(snapshot);
  const EgoWays ways = egoWays(observedSnapshot(snapshot, {}), lanes, 9.0,
                               shippedEgoFutureOptions(), options.max_ways);
  return anchorFeatures(ways, lanes, kTta, shippedEgoFutureOptions(), options);
}

void expectNear(const RowMatrix& a, const RowMatrix& b) {
  ASSERT_EQ(a.rows(), b.rows());
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), kTolerance);
}

TEST(Mirrored, SceneEqualsTheFeaturesOfTheMirroredScene) {
  const auto featuresOf = [](double side) {
    const Snapshot snapshot = bentSnapshot(side);
    return sceneFeatures(observedSnapshot(snapshot, {}), lanesOf(snapshot), smallFeatures());
  };
  const SceneFeatures left = featuresOf(1.0);
  const SceneFeatures right = featuresOf(-1.0);
  EXPECT_GT((left.lanes - right.lanes).cwiseAbs().maxCoeff(), 0.1F);
  const SceneFeatures back = mirrored(right);
  expectNear(back.agents, left.agents);
  expectNear(back.lanes, left.lanes);
  expectNear(back.ego, left.ego);
  EXPECT_EQ(back.lane_mask, left.lane_mask);
  EXPECT_NE(left.ego[8], 0.0F);
  EXPECT_NE(left.lanes(0, 9), left.lanes(0, 10));
}

class MirroredHeads : public testing::TestWithParam<EgoHead> {};
INSTANTIATE_TEST_SUITE_P(Mirrored, MirroredHeads,
                         testing::Values(EgoHead::kRegionProposal, EgoHead::kTargetPoints,
                                         EgoHead::kRegression),
                         [](const auto& info) { return std::string(toString(info.param)); });

TEST_P(MirroredHeads, AnchorsEqualTheAnchorsOfTheMirroredScene) {
  const AnchorFeatures left = anchorsOf(bentSnapshot(1.0), GetParam());
  const TimedSample right{kTta, anchorsOf(bentSnapshot(-1.0), GetParam()), {20.0, -3.0, -0.2}};
  const TimedSample back = mirrored(right);
  expectNear(back.anchors.groups, left.groups);
  expectNear(back.anchors.anchors, left.anchors);
  expectNear(back.anchors.poses, left.poses);
  expectNear(back.anchors.prior, left.prior);
  EXPECT_EQ(back.tta, kTta);
  EXPECT_EQ(back.ego.y, 3.0);
  EXPECT_EQ(back.ego.yaw, 0.2);
}

TEST(Mirrored, AttackChangesSides) {
  AttackSample attack;
  attack.ego = {10.0, 2.0, 0.3};
  attack.candidates = {{{5.0, -4.0, 1.0}, 7.0}};
  attack.offset = {1.0, -2.0, 0.5};
  const AttackSample back = mirrored(attack);
  EXPECT_EQ(back.ego.y, -2.0);
  EXPECT_EQ(back.candidates[0].pose.y, 4.0);
  EXPECT_EQ(back.candidates[0].pose.yaw, -1.0);
  EXPECT_EQ(back.candidates[0].speed, 7.0);
  EXPECT_EQ(back.offset.y, 2.0);
  EXPECT_EQ(back.offset.yaw, -0.5);
}

}  // namespace
}  // namespace forge
