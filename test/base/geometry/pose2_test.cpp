#include "collision_forge/base/geometry/pose2.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/geometry/reference_geometry.h"

namespace forge {
namespace {

void expectSamePose(const Pose2& a, const Pose2& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(angleBetween(a.yaw, b.yaw), 0.0, tolerance);
}

TEST(Angle, WrapsToHalfOpenRange) {
  EXPECT_EQ(wrapAngle(M_PI), M_PI);
  EXPECT_EQ(wrapAngle(-M_PI), M_PI);
  EXPECT_EQ(wrapAngle(0.0), 0.0);
  for (int i = -500; i <= 500; ++i) {
    const double angle = 0.1 * i;
    const double wrapped = wrapAngle(angle);
    EXPECT_GT(wrapped, -M_PI);
    EXPECT_LE(wrapped, M_PI);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
  }
}

TEST(Angle, BetweenIsTheShorterTurn) {
  EXPECT_NEAR(angleBetween(0.1, 0.4), 0.3, 1e-12);
  EXPECT_NEAR(angleBetween(3.0, -3.0), 2.0 * M_PI - 6.0, 1e-12);
  EXPECT_NEAR(angleBetween(-3.0, 3.0), 6.0 - 2.0 * M_PI, 1e-12);
  EXPECT_NEAR(angleBetween(0.0, M_PI), M_PI, 1e-12);
}

TEST(Pose2, RelativeToUndoesCompose) {
  reference::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 base = random.pose(1000.0);
    const Pose2 target = random.pose(1000.0);
    expectSamePose(compose(base, relativeTo(base, target)), target, 1e-9);
    expectSamePose(relativeTo(base, compose(base, target)), target, 1e-9);
  }
}

TEST(Pose2, InterpolatesAlongTheShorterTurn) {
  const Pose2 a{0.0, 2.0, 3.0};
  const Pose2 b{4.0, 0.0, -3.0};
  expectSamePose(interpolate(a, b, 0.0), a, 1e-12);
  expectSamePose(interpolate(a, b, 1.0), b, 1e-12);
  expectSamePose(interpolate(a, b, 0.5), {2.0, 1.0, M_PI}, 1e-12);
  expectSamePose(interpolate(a, b, 0.25), {1.0, 1.5, 3.0 + 0.5 * (M_PI - 3.0)}, 1e-12);
}

}  // namespace
}  // namespace forge
