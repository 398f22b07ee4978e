#include "collision_forge/attack/network/request_features.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/network/sample_network.h"

namespace forge {
namespace {

constexpr float kTolerance = 1e-5F;

TEST(RequestFeatures, EncodeTypeAndTime) {
  const Eigen::VectorXf none = requestFeatures(std::nullopt, 9.0);
  EXPECT_EQ(none.head(5).sum(), 0.0F);
  EXPECT_NEAR(none[5], 1.0F, kTolerance);
  const Eigen::VectorXf rear_end = requestFeatures(CollisionType::kRearEnd, 0.5);
  EXPECT_EQ(rear_end.head(5).sum(), 1.0F);
  EXPECT_EQ(rear_end[2], 1.0F);
  EXPECT_NEAR(rear_end[5], 0.0F, kTolerance);
}

TEST(CandidateFeatures, IgnoreTheHistory) {
  Track track = pastTrack("candidate", kCarSize, {10.0, 5.0, 0.3}, 6.0);
  const Pose2 ego{1.0, 2.0, 0.1};
  const CandidateNow before = candidateNow(track, ego);
  for (std::size_t i = 0; i + 1 < track.states.size(); ++i) track.states[i].pose.x -= 3.0;
  const CandidateNow after = candidateNow(track, ego);
  EXPECT_EQ(before.speed, after.speed);
  EXPECT_EQ(before.pose.x, after.pose.x);
  EXPECT_NEAR(before.speed, 6.0, 1e-9);
}

TEST(CandidateFeatures, ContainThePositionAtConstantSpeed) {
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
