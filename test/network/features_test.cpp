#include "network/features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "network/sample_network.h"

namespace forge {
namespace {

constexpr float kTolerance = 1e-5F;
constexpr double kTta = 3.0;  // s

SceneFeatures featuresOf(const Snapshot& snapshot, const std::set<std::string>& hidden = {},
                         const PatternFeatureOptions& options = smallFeatures()) {
  return sceneFeatures(observedSnapshot(snapshot, hidden), lanesOf(snapshot), options);
}

AnchorFeatures anchorsOf(const Snapshot& snapshot, EgoHead head = EgoHead::kRegionProposal) {
  PatternFeatureOptions options = smallFeatures();
  options.head = head;
  const LaneIndex lanes = lanesOf(snapshot);
  const EgoWays ways = egoWays(observedSnapshot(snapshot, {}), lanes, 9.0,
                               shippedEgoFutureOptions(), options.max_ways);
  return anchorFeatures(ways, lanes, kTta, shippedEgoFutureOptions(), options);
}

TEST(ObservedSnapshot, VelocitiesLookBack) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.agents[0].states.back().velocity = {99.0, 99.0};
  const Snapshot observed = observedSnapshot(snapshot, {});
  EXPECT_NEAR(observed.agents[0].states.back().velocity.x(), 6.0, 1e-9);
  EXPECT_NEAR(observed.agents[0].states.back().velocity.y(), 0.0, 1e-9);
}

TEST(ObservedSnapshot, KeepsOneStateOfWhoseHistoryIsHidden) {
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

TEST(SceneFeatures, AgentFramesBoundWhatIsSeenOfOthers) {
  PatternFeatureOptions options = smallFeatures();
  options.agent_frames = 1;
  const SceneFeatures features = featuresOf(junctionSnapshot(), {}, options);
  EXPECT_EQ(features.agent_mask.head(8).sum(), 8.0F);
  EXPECT_EQ(features.agent_mask.segment(8, 8).sum(), 1.0F);
}

TEST(SceneFeatures, NoLanesAndNoOthersAreFine) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.agents.clear();
  snapshot.map = emptyMap();
  const SceneFeatures features = featuresOf(snapshot);
  EXPECT_EQ(features.lane_mask.sum(), 0.0F);
  EXPECT_EQ(features.agent_mask.sum(), 8.0F);
  EXPECT_TRUE(features.agents.allFinite());
}

TEST(SceneFeatures, TakeTheNearestOfManyAgents) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.agents.clear();
  for (int i = 0; i < 300; ++i) {
    const double x = 500.0 - i;
    snapshot.agents.push_back(
        pastTrack("agent " + std::to_string(i), kCarSize, {x, 30.0, 0.0}, 1.0));
  }
  const SceneFeatures features = featuresOf(snapshot);
  EXPECT_EQ(features.agents.rows(), 5 * 8);
  EXPECT_NEAR(features.agents(15, 0), (201.0F + 30.0F) / 30.0F, kTolerance);
}

TEST(SceneFeatures, RefuseWhatIsNotFinite) {
  Snapshot snapshot = junctionSnapshot();
  snapshot.agents[2].states[3].pose.y = std::numeric_limits<double>::quiet_NaN();
  try {
    featuresOf(snapshot);
    FAIL() << "no complaint";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("crossing"), std::string::npos) << error.what();
  }
}

TEST(AnchorFeatures, LieAlongTheWaysAboutThePresentSpeed) {
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

TEST(AnchorFeatures, NoneLiesBehindTheEgo) {
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

TEST(AnchorFeatures, RefuseAnInstantThatIsNotAhead) {
  const Snapshot snapshot = junctionSnapshot();
  const LaneIndex lanes = lanesOf(snapshot);
  const EgoWays ways = egoWays(snapshot, lanes, 9.0, shippedEgoFutureOptions(), 4);
  EXPECT_THROW(anchorFeatures(ways, lanes, 0.0, shippedEgoFutureOptions(), smallFeatures()),
               std::invalid_argument);
}

TEST(RequestFeatures, TellTypeAndTime) {
  const Eigen::VectorXf none = requestFeatures(std::nullopt, 9.0);
  EXPECT_EQ(none.head(5).sum(), 0.0F);
  EXPECT_NEAR(none[5], 1.0F, kTolerance);
  const Eigen::VectorXf rear_end = requestFeatures(CollisionType::kRearEnd, 0.5);
  EXPECT_EQ(rear_end.head(5).sum(), 1.0F);
  EXPECT_EQ(rear_end[2], 1.0F);
  EXPECT_NEAR(rear_end[5], 0.0F, kTolerance);
}

TEST(CandidateFeatures, DoNotSeeTheHistory) {
  Track track = pastTrack("candidate", kCarSize, {10.0, 5.0, 0.3}, 6.0);
  const Pose2 ego{1.0, 2.0, 0.1};
  const CandidateNow before = candidateNow(track, ego);
  for (std::size_t i = 0; i + 1 < track.states.size(); ++i) track.states[i].pose.x -= 3.0;
  const CandidateNow after = candidateNow(track, ego);
  EXPECT_EQ(before.speed, after.speed);
  EXPECT_EQ(before.pose.x, after.pose.x);
  EXPECT_NEAR(before.speed, 6.0, 1e-9);
}

TEST(CandidateFeatures, TellWhereConstantSpeedLeads) {
  // 20 m beside, heading across at 5 m/s for 2 s: ends 10 m beside the ego's place
  const CandidateNow candidate{{0.0, 20.0, -M_PI_2}, 5.0};
  const Eigen::VectorXf features =
      candidateFeatures(candidate, 8.0, {0.0, 0.0, 0.0}, 2.0, CollisionType::kJunctionCrossing);
  EXPECT_NEAR(features[10], 0.0F, kTolerance);
  EXPECT_NEAR(features[11], 0.5F, kTolerance);
  EXPECT_NEAR(features[13], 1.0F, kTolerance);  // 10 m/s are needed
  EXPECT_NEAR(features[14], 0.5F, kTolerance);  // 5 m/s more than it has
  EXPECT_NEAR(features[16], 1.0F, kTolerance);  // straight ahead of it
  EXPECT_EQ(features.tail(5).sum(), 1.0F);
}

}  // namespace
}  // namespace forge
