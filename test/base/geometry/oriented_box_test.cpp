#include "collision_forge/base/geometry/oriented_box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/geometry/reference_geometry.h"

namespace forge {
namespace {

constexpr int kPairs = 20000;

TEST(OrientedBox, CornersGoCounterClockwiseFromFrontLeft) {
  const auto points = corners({{10.0, 20.0, M_PI_2}, {4.0, 2.0}});
  const Vector2 expected[] = {{9.0, 22.0}, {9.0, 18.0}, {11.0, 18.0}, {11.0, 22.0}};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR((points[i] - expected[i]).norm(), 0.0, 1e-12);
  }
  reference::Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const OrientedBox box = random.box(100.0);
    const auto got = corners(box);
    const auto want = reference::outline(box);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR((got[k] - want[k]).norm(), 0.0, 1e-10);
      EXPECT_NEAR((got[k] - box.center.position()).norm(), circumradius(box.size), 1e-10);
    }
  }
}

TEST(OrientedBox, ShrinksEverySide) {
  const OrientedBox box{{1.0, 2.0, 0.3}, {4.0, 2.0}};
  EXPECT_DOUBLE_EQ(shrunk(box, 0.25).size.length, 3.5);
  EXPECT_DOUBLE_EQ(shrunk(box, 0.25).size.width, 1.5);
  EXPECT_DOUBLE_EQ(shrunk(box, -0.5).size.width, 3.0);
  EXPECT_DOUBLE_EQ(shrunk(box, 1.5).size.width, 0.0);
  EXPECT_DOUBLE_EQ(shrunk(box, 1.5).size.length, 1.0);
  EXPECT_DOUBLE_EQ(shrunk(box, 0.25).center.x, 1.0);
}

TEST(OrientedBox, OverlapAndDistanceAgreeWithEdgeByEdge) {
  reference::Random random(5);
  int overlapping = 0;
  for (int i = 0; i < kPairs; ++i) {
    const OrientedBox a = random.box(6.0);
    const OrientedBox b = random.box(6.0);
    const double expected = reference::distance(a, b);
    overlapping += expected == 0.0;
    EXPECT_EQ(overlaps(a, b), expected == 0.0);
    EXPECT_EQ(overlaps(b, a), expected == 0.0);
    EXPECT_NEAR(distance(a, b), expected, 1e-9);
    EXPECT_NEAR(distance(b, a), expected, 1e-9);
  }
  EXPECT_GT(overlapping, kPairs / 5);
  EXPECT_LT(overlapping, kPairs * 4 / 5);
}

TEST(OrientedBox, LargestAxisGapBoundsTheDistance) {
  reference::Random random(6);
  for (int i = 0; i < kPairs; ++i) {
    const OrientedBox a = random.box(15.0);
    const OrientedBox b = random.box(15.0);
    const double expected = reference::distance(a, b);
    double largest = -1e9;
    for (const AxisGap& axis_gap : axisGaps(a, b)) {
      largest = std::max(largest, axis_gap.gap);
      EXPECT_NEAR(axis_gap.axis.norm(), 1.0, 1e-12);
      EXPECT_GE(axis_gap.axis.dot(b.center.position() - a.center.position()), 0.0);
    }
    EXPECT_LE(largest, expected + 1e-9);
    if (expected > 0.0) {
      EXPECT_GE(largest * M_SQRT2, expected - 1e-9);
    }
  }
}

TEST(OrientedBox, IntersectionAreaAgreesWithSortedCrossings) {
  reference::Random random(7);
  for (int i = 0; i < kPairs; ++i) {
    const OrientedBox a = random.box(6.0);
    const OrientedBox b = random.box(6.0);
    const double expected = reference::intersectionArea(a, b);
    EXPECT_NEAR(intersectionArea(a, b), expected, 1e-8);
    EXPECT_NEAR(intersectionArea(b, a), expected, 1e-8);
    const double joint = a.size.length * a.size.width + b.size.length * b.size.width - expected;
    EXPECT_NEAR(intersectionOverUnion(a, b), expected / joint, 1e-8);
  }
}

TEST(OrientedBox, KnownCases) {
  const OrientedBox unit{{0.0, 0.0, 0.0}, {2.0, 2.0}};
  EXPECT_TRUE(overlaps(unit, {{2.0, 0.0, 0.0}, {2.0, 2.0}})) << "closed boxes share an edge";
  EXPECT_FALSE(overlaps(unit, {{2.0 + 1e-9, 0.0, 0.0}, {2.0, 2.0}}));
  EXPECT_NEAR(distance(unit, {{5.0, 6.0, 0.0}, {2.0, 2.0}}), 5.0, 1e-12);
  EXPECT_NEAR(intersectionArea(unit, unit), 4.0, 1e-12);
  EXPECT_NEAR(intersectionOverUnion(unit, unit), 1.0, 1e-12);
  // A square inside, and the octagon shared with a square rotated by 45 degrees.
  EXPECT_NEAR(intersectionArea(unit, {{0.2, 0.1, 0.7}, {0.5, 0.5}}), 0.25, 1e-12);
  EXPECT_NEAR(intersectionArea(unit, {{0.0, 0.0, M_PI_4}, {2.0, 2.0}}), 8.0 * (M_SQRT2 - 1.0),
              1e-12);
}

TEST(OrientedBox, IntersectionCentroidIsTheMeanOfSharedPoints) {
  reference::Random random(8);
  constexpr int kGrid = 400;  // points along either side of `a`
  for (int i = 0; i < 20; ++i) {
    const OrientedBox a = random.box(3.0);
    const OrientedBox b = random.box(3.0);
    Vector2 sum = Vector2::Zero();
    int count = 0;
    for (int x = 0; x < kGrid; ++x) {
      for (int y = 0; y < kGrid; ++y) {
        const Pose2 local{((x + 0.5) / kGrid - 0.5) * a.size.length,
                          ((y + 0.5) / kGrid - 0.5) * a.size.width, 0.0};
        const Vector2 point = compose(a.center, local).position();
        if (distanceToPoint(b, point) > 0.0) continue;
        sum += point;
        ++count;
      }
    }
    const auto centroid = intersectionCentroid(a, b);
    if (count == 0) {
      EXPECT_LT(intersectionArea(a, b), 1e-2);
    } else if (count > kGrid) {
      ASSERT_TRUE(centroid);
      EXPECT_LT((*centroid - sum / count).norm(), 0.02);
    }
  }
  EXPECT_FALSE(intersectionCentroid({{0.0, 0.0, 0.0}, {2.0, 2.0}}, {{5.0, 0.0, 0.0}, {2.0, 2.0}}));
}

TEST(OrientedBox, ZeroSizeBoxesArePoints) {
  const OrientedBox point{{1.0, 0.0, 0.4}, {0.0, 0.0}};
  const OrientedBox box{{0.0, 0.0, 0.0}, {4.0, 2.0}};
  EXPECT_TRUE(overlaps(point, box));
  EXPECT_TRUE(overlaps(point, point));
  EXPECT_EQ(intersectionArea(point, box), 0.0);
  EXPECT_EQ(intersectionOverUnion(point, point), 0.0);
  EXPECT_NEAR(distance(point, {{5.0, 0.0, 0.0}, {0.0, 0.0}}), 4.0, 1e-12);
}

TEST(TouchedSide, IsTheSideOfTheOtherBox) {
  const BoxSize size{4.0, 2.0};
  const std::pair<Pose2, Side> places[] = {
      {{4.0, 0.8, 0.0}, Side::kFront},     {{-4.0, -0.8, 0.0}, Side::kRear},
      {{1.5, 2.0, 0.0}, Side::kLeft},      {{-1.5, -2.0, 0.0}, Side::kRight},
      {{2.9, -1.0, M_PI_2}, Side::kFront}, {{1.0, 2.95, -M_PI_2}, Side::kLeft}};
  for (const Pose2& center : {Pose2{}, Pose2{3.0, -7.0, 2.5}}) {
    for (const auto& [place, side] : places) {
      EXPECT_EQ(touchedSide({center, size}, {compose(center, place), size}), side)
          << place.x << " " << place.y;
    }
  }
}

/// Tests for every line along the side's normal whether it intersects `other`.
double overlapByLines(const OrientedBox& box, Side side, const OrientedBox& other) {
  constexpr int kLines = 20000;
  const bool is_across = side == Side::kFront || side == Side::kRear;
  const double length = is_across ? box.size.width : box.size.length;
  int met = 0;
  for (int i = 0; i < kLines; ++i) {
    const double at = ((i + 0.5) / kLines - 0.5) * length;
    int beyond = 0;
    for (const Vector2& corner : corners(other)) {
      const Pose2 local = relativeTo(box.center, {corner.x(), corner.y(), 0.0});
      beyond += (is_across ? local.y : local.x) > at;
    }
    met += beyond > 0 && beyond < 4;
  }
  return static_cast<double>(met) / kLines;
}

TEST(SideOverlap, IsTheSharedWidthEndToEndAndTheSharedLengthSideBySide) {
  const OrientedBox box{{3.0, -7.0, 2.5}, {4.0, 2.0}};
  const auto overlap = [&](const Pose2& place, const BoxSize& size, Side side) {
    return sideOverlap(box, side, {compose(box.center, place), size});
  };
  // An offset of 1.2 m leaves 0.8 m of two boxes that are 2 m wide.
  EXPECT_NEAR(overlap({4.0, 1.2, 0.0}, {4.0, 2.0}, Side::kFront), 0.4, 1e-12);
  EXPECT_NEAR(overlap({-4.0, -1.2, M_PI}, {4.0, 2.0}, Side::kRear), 0.4, 1e-12);
  EXPECT_NEAR(overlap({1.0, 2.0, 0.0}, {4.0, 2.0}, Side::kLeft), 0.75, 1e-12);
  EXPECT_NEAR(overlap({-1.0, -3.0, M_PI_2}, {4.0, 2.0}, Side::kRight), 0.5, 1e-12);
  EXPECT_EQ(overlap({3.0, 0.0, M_PI_2}, {5.0, 2.0}, Side::kFront), 1.0) << "from corner to corner";
  EXPECT_EQ(overlap({4.0, 2.5, 0.0}, {4.0, 2.0}, Side::kFront), 0.0) << "beside it";
}

TEST(SideOverlap, AgreesWithRaysAlongTheNormal) {
  const OrientedBox box{{-20.0, 5.0, -1.0}, {4.4, 1.8}};
  for (const double heading : {0.2, 0.9, 1.5, 2.4, -2.8}) {
    for (const Pose2& place : {Pose2{3.6, 1.1, heading}, Pose2{-3.8, -0.7, heading},
                               Pose2{1.9, 2.6, heading}, Pose2{-0.4, -2.2, heading}}) {
      const OrientedBox other{compose(box.center, place), {4.8, 2.1}};
      for (const Side side : {Side::kFront, Side::kRear, Side::kLeft, Side::kRight}) {
        EXPECT_NEAR(sideOverlap(box, side, other), overlapByLines(box, side, other), 1e-4);
      }
    }
  }
}

}  // namespace
}  // namespace forge
