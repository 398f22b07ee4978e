#include "collision_forge/planner_test/planners/box_circles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

PlacedCircles at(const BoxCircles& circles, double x, double y, double yaw) {
  return placed(circles, {x, y}, {std::cos(yaw), std::sin(yaw)});
}

TEST(BoxCircles, CornersTouchTheEdgesAndTheMiddleTheSides) {
  const BoxCircles circles = circlesOf({4.6, 1.8});
  EXPECT_DOUBLE_EQ(circles.middle_radius, 0.9);
  EXPECT_DOUBLE_EQ(circles.corner_radius, 0.45);
  for (const Vector2& corner : circles.corners) {
    EXPECT_NEAR(std::abs(corner.x()) + circles.corner_radius, 2.3, 1e-12);
    EXPECT_NEAR(std::abs(corner.y()) + circles.corner_radius, 0.9, 1e-12);
  }
}

TEST(BoxCircles, OfAWideBoxTheLengthCounts) {
  const BoxCircles circles = circlesOf({0.6, 0.8});
  EXPECT_DOUBLE_EQ(circles.middle_radius, 0.3);
  EXPECT_NEAR(std::abs(circles.corners[0].x()) + circles.corner_radius, 0.3, 1e-12);
  EXPECT_NEAR(std::abs(circles.corners[0].y()) + circles.corner_radius, 0.4, 1e-12);
}

TEST(BoxCircles, TheGapOfBoxesBesideEachOtherIsThatOfTheirSides) {
  const BoxCircles circles = circlesOf({4.6, 1.8});
  EXPECT_NEAR(gapBetween(circles, at(circles, 0, 0, 0), circles, at(circles, 0, 3.5, 0)), 1.7,
              1e-12);
  // The one behind the other: corner to corner.
  EXPECT_NEAR(gapBetween(circles, at(circles, 0, 0, 0), circles, at(circles, 10, 0, 0)), 5.4,
              1e-12);
}

TEST(BoxCircles, BetweenTheCirclesNothingIsSeen) {
  // A corner that points at the side of a long box, between its middle and its end.
  const BoxCircles lorry = circlesOf({12.0, 2.4});
  const BoxCircles car = circlesOf({4.0, 1.6});
  const double gap = gapBetween(lorry, at(lorry, 0, 0, 0), car, at(car, 3.0, 3.0, 0.5 * M_PI));
  EXPECT_GT(gap, 0.0);  // the boxes overlap: the car's end is at y = 1
}

TEST(BoxCircles, OverlappingCirclesHaveANegativeGap) {
  const BoxCircles circles = circlesOf({4.6, 1.8});
  EXPECT_NEAR(gapBetween(circles, at(circles, 0, 0, 0), circles, at(circles, 0, 1.5, 0)), -0.3,
              1e-12);
}

TEST(BoxCircles, ReachIsTheFarthestEdgeOfACircle) {
  const BoxCircles circles = circlesOf({4.6, 1.8});
  EXPECT_NEAR(circles.reach, std::hypot(1.85, 0.45) + 0.45, 1e-12);
}

}  // namespace
}  // namespace forge
