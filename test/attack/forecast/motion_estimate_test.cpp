#include "collision_forge/attack/forecast/motion_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace forge {
namespace {

Track trackOf(const std::vector<double>& times, const std::function<Pose2(double)>& pose) {
  Track track{"a", AgentClass::kCar, {4.0, 2.0}, {}};
  for (const double time : times) {
    track.states.push_back({time, pose(time), Vector2(77.0, 77.0)});
  }
  return track;
}

TEST(EstimateMotion, IsExactForConstantVelocityWhateverTheRecordedVelocities) {
  const Pose2 start{3.0, 4.0, 0.8};
  const auto pose = [&](double t) { return compose(start, {6.0 * t, 0.0, 0.0}); };
  const Motion motion = estimateMotion(trackOf({0.0, 0.5, 1.0, 1.5}, pose), 4);
  EXPECT_NEAR(motion.pose.x, pose(1.5).x, 1e-12);
  EXPECT_EQ(motion.pose.yaw, 0.8);
  EXPECT_NEAR(motion.speed, 6.0, 1e-9);
  EXPECT_NEAR(motion.acceleration, 0.0, 1e-9);
  EXPECT_NEAR(motion.yaw_rate, 0.0, 1e-9);
}

TEST(EstimateMotion, IsExactForConstantAcceleration) {
  const auto pose = [](double t) { return Pose2{5.0 * t + t * t, 0.0, 0.0}; };
  const Motion motion = estimateMotion(trackOf({0.0, 0.5, 1.0, 1.5}, pose), 4);
  EXPECT_NEAR(motion.speed, 8.0, 1e-9);
  EXPECT_NEAR(motion.acceleration, 2.0, 1e-9);
}

TEST(EstimateMotion, FindsTheYawRateAcrossTheWrapOfAngles) {
  const auto pose = [](double t) { return Pose2{0.0, 0.0, wrapAngle(3.0 + 0.3 * t)}; };
  const Motion motion = estimateMotion(trackOf({0.0, 0.5, 1.0, 1.5}, pose), 4);
  EXPECT_NEAR(motion.yaw_rate, 0.3, 1e-9);
  EXPECT_NEAR(motion.pose.yaw, wrapAngle(3.45), 1e-12);
}

TEST(EstimateMotion, UsesTheNewestFramesOnly) {
  const auto pose = [](double t) { return Pose2{t < 1.0 ? 100.0 : 4.0 * t, 0.0, 0.0}; };
  const Track track = trackOf({0.0, 0.5, 1.0, 1.5, 2.0}, pose);
  EXPECT_NEAR(estimateMotion(track, 3).speed, 4.0, 1e-9);
  EXPECT_GT(std::abs(estimateMotion(track, 4).speed - 4.0), 1.0);
}

TEST(EstimateMotion, IgnoresStatesBeforeAGap) {
  const auto pose = [](double t) { return Pose2{t < 2.0 ? 100.0 : 4.0 * t, 0.0, 0.0}; };
  EXPECT_NEAR(estimateMotion(trackOf({0.0, 0.5, 2.0, 2.5, 3.0}, pose), 8).speed, 4.0, 1e-9);
  const Motion alone = estimateMotion(trackOf({0.0, 0.5, 2.0}, pose), 8);
  EXPECT_EQ(alone.speed, 0.0);
  EXPECT_EQ(alone.yaw_rate, 0.0);
}

TEST(EstimateMotion, OneStateIsStandstill) {
  const Motion motion = estimateMotion(trackOf({2.0},
                                               [](double) {
                                                 return Pose2{1.0, 2.0, 3.0};
                                               }),
                                       4);
  EXPECT_EQ(motion.pose.y, 2.0);
  EXPECT_EQ(motion.speed, 0.0);
  EXPECT_EQ(motion.acceleration, 0.0);
  EXPECT_EQ(motion.yaw_rate, 0.0);
}

TEST(EstimateMotion, FitsByLeastSquares) {
  // Residuals 0.1 * (1, -3, 3, -1) are orthogonal to every parabola at even steps.
  const double noise[] = {0.1, -0.3, 0.3, -0.1};
  const auto pose = [&](double t) {
    return Pose2{4.0 * t + noise[static_cast<int>(2.0 * t)], 0.0, 0.0};
  };
  const Motion motion = estimateMotion(trackOf({0.0, 0.5, 1.0, 1.5}, pose), 4);
  EXPECT_NEAR(motion.speed, 4.0, 1e-9);
  EXPECT_NEAR(motion.acceleration, 0.0, 1e-9);
  EXPECT_NEAR(motion.pose.x, 5.9, 1e-12) << "the pose is the recorded one";
}

}  // namespace
}  // namespace forge
