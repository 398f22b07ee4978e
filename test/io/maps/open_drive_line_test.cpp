#include "collision_forge/io/maps/open_drive_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace forge {
namespace {

// Fresnel integrals C and S of 1 and 2 (Abramowitz and Stegun, table 7.7).
constexpr double kC1 = 0.77989340037682283, kS1 = 0.43825914739035477;
constexpr double kC2 = 0.48825340607534076, kS2 = 0.34341567836369824;

TEST(OpenDriveLine, anArcEndsOnItsCircle) {
  const Clothoid arc({1.0, 2.0, 0.0}, 5.0 * M_PI, 0.1, 0.1);
  const LinePoint end = arc.at(5.0 * M_PI);
  EXPECT_NEAR(end.pose.x, 11.0, 1e-12);
  EXPECT_NEAR(end.pose.y, 12.0, 1e-12);
  EXPECT_NEAR(end.pose.yaw, M_PI / 2.0, 1e-12);
  EXPECT_EQ(end.curvature, 0.1);
}

TEST(OpenDriveLine, aSpiralEndsAtTheFresnelIntegrals) {
  // With curvature pi t / 50 per metre at 50 t metres, the point is 50 (C(t), S(t)).
  const Clothoid spiral({}, 100.0, 0.0, 2.0 * M_PI / 50.0);
  const LinePoint middle = spiral.at(50.0);
  EXPECT_NEAR(middle.pose.x, 50.0 * kC1, 1e-12);
  EXPECT_NEAR(middle.pose.y, 50.0 * kS1, 1e-12);
  EXPECT_NEAR(middle.pose.yaw, M_PI / 2.0, 1e-12);
  EXPECT_NEAR(middle.curvature, M_PI / 50.0, 1e-15);
  const LinePoint end = spiral.at(100.0);
  EXPECT_NEAR(end.pose.x, 50.0 * kC2, 1e-12);
  EXPECT_NEAR(end.pose.y, 50.0 * kS2, 1e-12);
}

TEST(OpenDriveLine, aSpiralFromACurveContinuesTheSameClothoid) {
  const Pose2 start{50.0 * kC1, 50.0 * kS1, M_PI / 2.0};
  const LinePoint end = Clothoid(start, 50.0, M_PI / 50.0, 2.0 * M_PI / 50.0).at(50.0);
  EXPECT_NEAR(end.pose.x, 50.0 * kC2, 1e-12);
  EXPECT_NEAR(end.pose.y, 50.0 * kS2, 1e-12);
}

TEST(OpenDriveLine, aParametricCubicIsMeasuredByItsArcLength) {
  // u = 10 p^3 is a straight line along which p = 0.5 is 1.25 m from the start.
  const CubicCurve straight({0.0, 0.0, M_PI / 2.0}, 10.0, {0.0, 0.0, 0.0, 10.0}, {}, 1.0);
  EXPECT_NEAR(straight.at(5.0).pose.y, 5.0, 1e-6);
  EXPECT_NEAR(straight.at(10.0).pose.y, 10.0, 1e-9);
  EXPECT_NEAR(straight.at(5.0).pose.yaw, M_PI / 2.0, 1e-9);
}

/// Length of v = a u^2 from 0 to u, in closed form.
double parabolaLength(double a, double u) {
  const double slope = 2.0 * a * u;
  return 0.5 * u * std::sqrt(1.0 + slope * slope) + std::asinh(slope) / (4.0 * a);
}

TEST(OpenDriveLine, aPoly3EndsWhereItsArcLengthIsTheLength) {
  const double length = parabolaLength(0.01, 40.0);
  const CubicCurve parabola = CubicCurve::ofHeight({}, length, {0.0, 0.0, 0.01, 0.0});
  const LinePoint end = parabola.at(length);
  EXPECT_NEAR(end.pose.x, 40.0, 1e-6);
  EXPECT_NEAR(end.pose.y, 16.0, 1e-6);
  const LinePoint middle = parabola.at(parabolaLength(0.01, 25.0));
  EXPECT_NEAR(middle.pose.x, 25.0, 1e-6);
  EXPECT_NEAR(middle.pose.yaw, std::atan(0.5), 1e-7);
  EXPECT_NEAR(middle.curvature, 0.02 / std::pow(1.25, 1.5), 1e-8);
}

TEST(OpenDriveLine, headingAndCurvatureAreTheDerivativesOfTheLine) {
  const Pose2 start{3.0, -4.0, 2.0};
  const Clothoid spiral(start, 60.0, -0.03, 0.05);
  const CubicCurve cubic(start, 30.0, {0.0, 28.0, 3.0, -2.0}, {0.0, 0.0, 9.0, -4.0}, 1.0);
  const std::function<LinePoint(double)> lines[] = {[&](double s) { return spiral.at(s); },
                                                    [&](double s) { return cubic.at(s); }};
  constexpr double kStep = 1e-3;  // m
  const double scales[] = {
      1.0,
      (cubic.at(15.0 + kStep).pose.position() - cubic.at(15.0 - kStep).pose.position()).norm() /
          (2.0 * kStep)};
  for (int i = 0; i < 2; ++i) {
    const Pose2 before = lines[i](15.0 - kStep).pose, after = lines[i](15.0 + kStep).pose;
    const LinePoint here = lines[i](15.0);
    const Vector2 step = after.position() - before.position();
    EXPECT_NEAR(std::atan2(step.y(), step.x()), here.pose.yaw, 1e-5) << i;
    const double turn = angleBetween(before.yaw, after.yaw) / (2.0 * kStep * scales[i]);
    EXPECT_NEAR(turn, here.curvature, 1e-4) << i;
  }
}

TEST(OpenDriveLine, aCurveWithoutLengthIsRefused) {
  EXPECT_THROW(CubicCurve({}, 10.0, {}, {}, 1.0), std::invalid_argument);
  EXPECT_THROW(CubicCurve({}, 10.0, {0.0, 1e308, 1e308, 1e308}, {}, 1.0), std::invalid_argument);
}

TEST(OpenDriveLine, aReferenceLineUsesThePieceAtTheArcLength) {
  ReferenceLine line;
  line.append(10.0, Clothoid({0.0, 0.0, 0.0}, 10.0, 0.0, 0.0));
  line.append(5.0, Clothoid({20.0, 0.0, M_PI / 2.0}, 5.0, 0.0, 0.0));
  EXPECT_EQ(line.length(), 15.0);
  EXPECT_NEAR(line.at(9.0).pose.x, 9.0, 1e-12);
  EXPECT_NEAR(line.at(10.0).pose.x, 20.0, 1e-12);
  EXPECT_NEAR(line.at(15.0).pose.y, 5.0, 1e-12);
}

TEST(OpenDriveLine, aPiecewiseCubicIsZeroBeforeItsFirstPiece) {
  PiecewiseCubic width;
  width.add(20.0, {2.0, 0.0, 0.0, 0.0});
  width.add(10.0, {1.0, 0.1, 0.0, 0.0});
  EXPECT_EQ(width.value(9.0), 0.0);
  EXPECT_EQ(width.slope(9.0), 0.0);
  EXPECT_DOUBLE_EQ(width.value(15.0), 1.5);
  EXPECT_DOUBLE_EQ(width.slope(15.0), 0.1);
  EXPECT_EQ(width.value(20.0), 2.0);
}

}  // namespace
}  // namespace forge
