#include "collision_forge/planners/sampled_way.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

/// Half a circle of 30 m to the left from the origin.
SampledWay halfCircle() {
  std::vector<Vector2> points;
  for (int i = 0; i <= 100; ++i) {
    const double turned = M_PI * i / 100;
    points.emplace_back(30.0 * std::sin(turned), 30.0 * (1.0 - std::cos(turned)));
  }
  return SampledWay(Polyline(points));
}

TEST(SampledWay, FollowsItsLineToTheSide) {
  const Pose2 pose = SampledWay(Polyline({{0.0, 0.0}, {30.0, 40.0}})).at(10.0, 2.0);
  EXPECT_NEAR(pose.x, 6.0 - 1.6, 1e-6);
  EXPECT_NEAR(pose.y, 8.0 + 1.2, 1e-6);
  EXPECT_NEAR(pose.yaw, std::atan2(4.0, 3.0), 1e-9);
}

TEST(SampledWay, FollowsABendWithContinuousHeading) {
  const SampledWay way = halfCircle();
  for (double s = 10.0; s < 85.0; s += 0.37) {
    const Pose2 pose = way.at(s, 1.0);
    EXPECT_NEAR((pose.position() - Vector2(0.0, 30.0)).norm(), 29.0, 0.1) << s;
    EXPECT_NEAR(pose.yaw, s / 30.0, 0.02) << s;
  }
}

TEST(SampledWay, GoesStraightOnBeyondItsEnds) {
  const SampledWay way(Polyline({{0.0, 0.0}, {20.0, 0.0}}));
  EXPECT_NEAR(way.at(-5.0, 0.0).x, -5.0, 1e-9);
  EXPECT_NEAR(way.at(32.0, 1.0).x, 32.0, 1e-9);
  EXPECT_NEAR(way.project({-5.0, 1.0}).arc_length, -5.0, 1e-9);
  EXPECT_NEAR(way.project({32.0, -1.0}).arc_length, 32.0, 1e-9);
  EXPECT_NEAR(way.project({32.0, -1.0}).lateral, -1.0, 1e-9);
}

TEST(SampledWay, ProjectionsUndoPlaces) {
  const SampledWay way = halfCircle();
  for (double s = 2.0; s < 90.0; s += 1.3) {
    for (const double lateral : {-3.0, 0.0, 4.0}) {
      const SampledWay::Projection found = way.project(way.at(s, lateral).position());
      EXPECT_NEAR(found.arc_length, s, 0.05) << lateral;
      EXPECT_NEAR(found.lateral, lateral, 0.02) << s;
    }
  }
}

TEST(SampledWay, AHintFindsTheSameAsTheWholeSearch) {
  const SampledWay way = halfCircle();
  std::size_t hint = 0;
  for (double s = 0.0; s < 90.0; s += 3.0) {
    const Vector2 point = way.at(s, 2.0).position();
    const SampledWay::Projection found = way.project(point, hint);
    EXPECT_EQ(found.sample, way.project(point).sample) << s;
    EXPECT_EQ(way.project(point, way.project(point).sample + 5).sample, found.sample) << s;
    hint = found.sample;
  }
}

TEST(SampledWay, AHintKeepsToItsPartOfAWayThatCrossesItself) {
  // To the east along y = 0, around, and back down along x = 50.
  const SampledWay way(
      Polyline({{0.0, 0.0}, {100.0, 0.0}, {100.0, 50.0}, {50.0, 50.0}, {50.0, -50.0}}));
  const std::size_t before = way.project({40.0, 0.0}).sample;
  const double first = way.project({49.0, 0.2}, before).arc_length;
  EXPECT_NEAR(first, 49.0, 1.0);
}

}  // namespace
}  // namespace forge
