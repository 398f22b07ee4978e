#include "collision_forge/planner_test/planners/lqr_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const KinematicBicycleOptions& bicycleOptions() { return shippedConfig().planners.car; }
const LqrOptions& lqrOptions() { return shippedConfig().planners.lqr; }

/// Poses every 0.1 s on a circle of `curvature` (0: a line) from the origin, at `speed`.
std::vector<Pose2> referenceOn(double curvature, double speed, int count) {
  std::vector<Pose2> poses;
  for (int i = 0; i < count; ++i) {
    const double length = speed * 0.1 * i;
    const double turned = curvature * length;
    if (curvature == 0.0) {
      poses.push_back({length, 0.0, 0.0});
    } else {
      poses.push_back(
          {std::sin(turned) / curvature, (1.0 - std::cos(turned)) / curvature, wrapAngle(turned)});
    }
  }
  return poses;
}

/// The car at the end of the reference, seen from its last pose.
Pose2 missAtEnd(const std::vector<Pose2>& reference, BicycleState state, double* speed = nullptr) {
  const KinematicBicycle bicycle(bicycleOptions());
  LqrTracker tracker(lqrOptions(), bicycleOptions().wheelbase);
  tracker.setReference(reference);
  for (std::size_t i = 0; i + 1 < reference.size(); ++i) {
    state = bicycle.step(state, tracker.command(state, i), 0.1);
  }
  if (speed) *speed = state.speed;
  return relativeTo(reference.back(), state.rear_axle);
}

TEST(LqrTracker, ConvergesToAStraightLineFromAnOffset) {
  for (const double offset : {-1.0, 1.0}) {
    const Pose2 miss = missAtEnd(referenceOn(0.0, 8.0, 101), {{0.0, offset, 0.1}, 8.0, 0.0, 0.0});
    EXPECT_NEAR(miss.y, 0.0, 0.04) << offset;
    EXPECT_NEAR(miss.yaw, 0.0, 0.01) << offset;
  }
}

TEST(LqrTracker, ConvergesToAnArcFromAnOffset) {
  for (const double curvature : {-1.0 / 25.0, 1.0 / 25.0}) {
    const Pose2 miss =
        missAtEnd(referenceOn(curvature, 6.0, 201), {{0.0, 0.7, 0.0}, 6.0, 0.0, 0.0});
    EXPECT_NEAR(miss.y, 0.0, 0.1) << curvature;
    EXPECT_NEAR(miss.yaw, 0.0, 0.03) << curvature;
  }
}

TEST(LqrTracker, TakesOnTheSpeedOfTheReference) {
  double speed = 0.0;
  missAtEnd(referenceOn(0.0, 8.0, 81), {{0.0, 0.0, 0.0}, 5.0, 0.0, 0.0}, &speed);
  EXPECT_NEAR(speed, 8.0, 0.05);
}

TEST(LqrTracker, StandsWhereTheReferenceStands) {
  double speed = 0.0;
  const Pose2 miss =
      missAtEnd(std::vector<Pose2>(60, Pose2{4.0, 0.0, 0.0}), {{}, 3.0, 0.0, 0.0}, &speed);
  EXPECT_NEAR(speed, 0.0, 0.05);
  EXPECT_NEAR(miss.yaw, 0.0, 1e-9);
}

TEST(LqrTracker, AcceleratesByTheGainOfTheHorizon) {
  LqrTracker tracker(lqrOptions(), bicycleOptions().wheelbase);
  tracker.setReference(referenceOn(0.0, 8.0, 41));
  // One second at a constant acceleration a: the least 10 (5 + a - 8)^2 + a^2.
  EXPECT_NEAR(tracker.command({{}, 5.0, 0.0, 0.0}, 0).acceleration, 30.0 / 11.0, 1e-6);
}

TEST(LqrTracker, BelowTheStoppingSpeedOnlySpeedIsControlled) {
  LqrTracker tracker(lqrOptions(), bicycleOptions().wheelbase);
  tracker.setReference(std::vector<Pose2>(41, Pose2{0.0, 1.0, 0.3}));
  const BicycleCommand command = tracker.command({{}, 0.1, 0.0, 0.0}, 0);
  EXPECT_NEAR(command.acceleration, -0.05, 1e-9);
  EXPECT_EQ(command.steering_rate, 0.0);
}

TEST(LqrTracker, HeadingErrorsAreTakenTheShorterWay) {
  const std::vector<Pose2> west = {{0.0, 0.0, M_PI - 0.01}, {-1.0, 0.01, M_PI - 0.01}};
  LqrTracker tracker(lqrOptions(), bicycleOptions().wheelbase);
  tracker.setReference(west);
  const double rate = tracker.command({{0.0, 0.0, -M_PI + 0.01}, 10.0, 0.0, 0.0}, 0).steering_rate;
  EXPECT_LT(rate, 0.0);  // 0.02 rad too far left
  EXPECT_GT(rate, -0.5);
}

TEST(FitProfile, FindsSpeedAndCurvatureOfACircle) {
  const ReferenceProfile profile = fitProfile(referenceOn(0.05, 6.0, 41), lqrOptions());
  ASSERT_EQ(profile.speeds.size(), 40U);
  ASSERT_EQ(profile.curvatures.size(), 40U);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_NEAR(profile.speeds[i], 6.0, 0.01) << i;
    EXPECT_NEAR(profile.curvatures[i], 0.05, 1e-3) << i;
  }
}

/// What fitProfile() makes least, for the speeds.
double speedCost(const std::vector<Pose2>& poses, const std::vector<double>& speeds) {
  double cost = 0.0;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const double moved = (poses[i + 1].position() - poses[i].position()).dot(poses[i].heading());
    cost += std::pow(0.1 * speeds[i] - moved, 2);
    if (i >= 2) {
      const double change = (speeds[i] - 2.0 * speeds[i - 1] + speeds[i - 2]) / 0.1;
      cost += lqrOptions().jerk_penalty * change * change;
    }
  }
  return cost;
}

TEST(FitProfile, NoOtherSpeedsFitRoughPosesBetter) {
  std::vector<Pose2> poses = referenceOn(0.0, 5.0, 21);
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i].x += i % 3 == 0 ? 0.2 : -0.1;
  const std::vector<double> speeds = fitProfile(poses, lqrOptions()).speeds;
  const double best = speedCost(poses, speeds);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    for (const double change : {-0.01, 0.01}) {
      std::vector<double> others = speeds;
      others[i] += change;
      EXPECT_GT(speedCost(poses, others), best) << i;
    }
  }
}

TEST(FitProfile, StandingPosesHaveNoSpeedAndNoCurvature) {
  const ReferenceProfile profile =
      fitProfile(std::vector<Pose2>(10, Pose2{1.0, 2.0, 0.5}), lqrOptions());
  for (std::size_t i = 0; i < profile.speeds.size(); ++i) {
    EXPECT_NEAR(profile.speeds[i], 0.0, 1e-9);
    EXPECT_NEAR(profile.curvatures[i], 0.0, 1e-9);
  }
}

TEST(FitProfile, OnePoseIsNoReference) {
  EXPECT_THROW(fitProfile({{0.0, 0.0, 0.0}}, lqrOptions()), std::invalid_argument);
}

}  // namespace
}  // namespace forge
