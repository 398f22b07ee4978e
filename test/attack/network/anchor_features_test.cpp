#include "collision_forge/attack/network/anchor_features.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/network/sample_network.h"

namespace forge {
namespace {

constexpr double kTta = 3.0;  // s

AnchorFeatures anchorsOf(const Snapshot& snapshot, EgoHead head = EgoHead::kRegionProposal) {
  PatternFeatureOptions options = smallFeatures();
  options.head = head;
  const LaneIndex lanes = lanesOf(snapshot);
  const EgoWays ways = egoWays(observedSnapshot(snapshot, {}), lanes, 9.0,
                               shippedEgoFutureOptions(), options.max_ways);
  return anchorFeatures(ways, lanes, kTta, shippedEgoFutureOptions(), options);
}

TEST(AnchorFeatures, LieAlongThePathsAroundConstantSpeed) {
  const AnchorFeatures anchors = anchorsOf(junctionSnapshot());
  ASSERT_EQ(anchors.group_size, 10);
  ASSERT_GT(anchors.prior[0], kAbsent);
  EXPECT_NEAR(anchors.poses(0, 0), 0.0F, 1e-3F);  // standing still
  // the middle one: on at 8 m/s, straight on the likeliest way
  EXPECT_NEAR(anchors.arc_lengths[5], 24.0F, 1e-3F);
  EXPECT_NEAR(anchors.poses(5, 0), 24.0F, 0.05F);
  EXPECT_NEAR(anchors.poses(5, 1), 0.0F, 0.05F);
  EXPECT_NEAR(anchors.arc_lengths[6] - anchors.arc_lengths[5], anchors.along_scale, 1e-4F);
  EXPECT_NEAR(anchors.along_scale, 0.05 + 0.5 * std::pow(kTta, 1.5), 1e-5);
}

TEST(AnchorFeatures, NeverLieBehindTheEgo) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.ego = pastTrack(kEgoId, kEgoSize, {-30.0, -1.75, 0.0}, 1.0);
  const AnchorFeatures anchors = anchorsOf(snapshot);
  int present = 0;
  for (Eigen::Index i = 0; i < anchors.prior.size(); ++i) {
    if (anchors.prior[i] <= kAbsent) continue;
    ++present;
    EXPECT_GE(anchors.arc_lengths[i], 0.0F);
  }
  EXPECT_GT(present, 0);
  EXPECT_EQ(anchors.prior[1], kAbsent);
}

TEST(AnchorFeatures, TargetPointsLieOnCentrelines) {
  const AnchorFeatures anchors = anchorsOf(junctionSnapshot(), EgoHead::kTargetPoints);
  int present = 0;
  for (Eigen::Index i = 0; i < anchors.prior.size(); ++i) {
    if (anchors.prior[i] <= kAbsent) continue;
    ++present;
    const double x = anchors.poses(i, 0) - 30.0;  // back in the map
    const double y = anchors.poses(i, 1) - 1.75;
    EXPECT_TRUE(std::abs(std::abs(x) - 1.75) < 1e-4 || std::abs(std::abs(y) - 1.75) < 1e-4)
        << x << ' ' << y;
  }
  EXPECT_GT(present, 10);
}

TEST(AnchorFeatures, HeadsWithoutLanesGoStraightOn) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.map = emptyMap();
  for (const EgoHead head : {EgoHead::kTargetPoints, EgoHead::kRegression}) {
    const AnchorFeatures anchors = anchorsOf(snapshot, head);
    EXPECT_NEAR(anchors.poses(0, 0), 24.0F, 1e-3F);
    EXPECT_GT(anchors.prior[0], kAbsent);
  }
}

TEST(AnchorFeatures, RejectATimeThatIsNotAfterNow) {
  const Snapshot snapshot = junctionSnapshot();
  const LaneIndex lanes = lanesOf(snapshot);
  const EgoWays ways = egoWays(snapshot, lanes, 9.0, shippedEgoFutureOptions(), 4);
  EXPECT_THROW(anchorFeatures(ways, lanes, 0.0, shippedEgoFutureOptions(), smallFeatures()),
               std::invalid_argument);
}

}  // namespace
}  // namespace forge
