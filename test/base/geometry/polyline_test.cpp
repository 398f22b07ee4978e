#include "collision_forge/base/geometry/polyline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/geometry/reference_geometry.h"

namespace forge {
namespace {

using Points = std::vector<Vector2>;

Points randomPoints(reference::Random& random) {
  Points points = {{random.between(-50.0, 50.0), random.between(-50.0, 50.0)}};
  const int count = static_cast<int>(random.between(2.0, 12.0));
  double yaw = random.between(-M_PI, M_PI);
  for (int i = 1; i < count; ++i) {
    yaw += random.between(-2.0, 2.0);
    points.push_back(points.back() +
                     random.between(0.5, 8.0) * Vector2(std::cos(yaw), std::sin(yaw)));
  }
  return points;
}

TEST(Polyline, DropsCoincidentPoints) {
  const Polyline line({{0, 0}, {0, 0}, {3, 0}, {3, 0}, {3, 4}, {3, 4}});
  EXPECT_EQ(line.points().size(), 3u);
  EXPECT_DOUBLE_EQ(line.length(), 7.0);
  EXPECT_EQ(line.arcLengths(), (std::vector<double>{0.0, 3.0, 7.0}));
}

TEST(Polyline, RejectsFewerThanTwoDistinctPoints) {
  EXPECT_THROW(Polyline({}), std::invalid_argument);
  EXPECT_THROW(Polyline({{1, 2}}), std::invalid_argument);
  EXPECT_THROW(Polyline({{1, 2}, {1, 2}}), std::invalid_argument);
  EXPECT_THROW(Polyline({{1, 2}, {NAN, 2}, {5, 6}}), std::invalid_argument);
  EXPECT_THROW(Polyline({{1, 2}, {5, std::numeric_limits<double>::infinity()}}),
               std::invalid_argument);
}

TEST(Polyline, YawTurnsLinearlyBetweenSegmentMiddles) {
  const Polyline line({{0, 0}, {4, 0}, {4, 8}});
  EXPECT_DOUBLE_EQ(line.poseAt(0.0).yaw, 0.0);
  EXPECT_DOUBLE_EQ(line.poseAt(2.0).yaw, 0.0);
  EXPECT_NEAR(line.poseAt(4.0).yaw, M_PI_2 / 3.0, 1e-12);  // 2 m of the 6 m between the middles
  EXPECT_NEAR(line.poseAt(5.0).yaw, M_PI_2 / 2.0, 1e-12);
  EXPECT_NEAR(line.poseAt(8.0).yaw, M_PI_2, 1e-12);
  EXPECT_NEAR(line.poseAt(12.0).yaw, M_PI_2, 1e-12);
  EXPECT_NEAR((line.poseAt(5.0).position() - Vector2(4.0, 1.0)).norm(), 0.0, 1e-12);
}

TEST(Polyline, ContinuesStraightBeyondItsEnds) {
  const Polyline line({{0, 0}, {4, 0}, {4, 8}});
  const Pose2 before = line.poseAt(-3.0);
  EXPECT_NEAR((before.position() - Vector2(-3.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(before.yaw, 0.0);
  const Pose2 after = line.poseAt(15.0);
  EXPECT_NEAR((after.position() - Vector2(4.0, 11.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(after.yaw, M_PI_2, 1e-12);
}

TEST(Polyline, PoseIsContinuousAndOnTheLine) {
  reference::Random random(9);
  for (int i = 0; i < 200; ++i) {
    const Polyline line(randomPoints(random));
    Pose2 last = line.poseAt(0.0);
    for (double s = 0.0; s <= line.length(); s += 1e-3) {
      const Pose2 pose = line.poseAt(s);
      EXPECT_LE((pose.position() - last.position()).norm(), 1e-3 + 1e-9);
      EXPECT_LE(std::abs(angleBetween(last.yaw, pose.yaw)), 2.0 / 0.5 * 1e-3 + 1e-9);
      last = pose;
    }
    EXPECT_NEAR((last.position() - line.points().back()).norm(), 0.0, 2e-3);
  }
}

TEST(Polyline, ProjectionAgreesWithBruteForce) {
  reference::Random random(10);
  for (int i = 0; i < 2000; ++i) {
    const Points points = randomPoints(random);
    const Polyline line(points);
    const Vector2 query = points[0] + Vector2(random.between(-20, 20), random.between(-20, 20));
    double expected = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      expected = std::min(expected, reference::pointToSegment(query, points[k], points[k + 1]));
    }
    const PolylineProjection found = line.project(query);
    EXPECT_NEAR(found.distance, expected, 1e-9);
    EXPECT_NEAR((found.pose.position() - query).norm(), expected, 1e-9);
    EXPECT_GE(found.arc_length, 0.0);
    EXPECT_LE(found.arc_length, line.length());
    const Pose2 there = line.poseAt(found.arc_length);
    EXPECT_NEAR((there.position() - found.pose.position()).norm(), 0.0, 1e-12);
    EXPECT_DOUBLE_EQ(there.yaw, found.pose.yaw);
    EXPECT_LE(std::abs(found.lateral), found.distance + 1e-9);
    if (found.arc_length > 0.0 && found.arc_length < line.length()) {
      EXPECT_NEAR(std::abs(found.lateral), expected, 1e-9);
    }
  }
}

TEST(Polyline, LateralIsPositiveOnTheLeft) {
  reference::Random random(11);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const Polyline line(randomPoints(random));
    const double offset = random.between(-1.0, 1.0);
    const double arc_length = random.between(0.0, line.length());
    // Off the middle of a chord, so that the side is unambiguous; skipped if another part is
    // nearer.
    const auto& s = line.arcLengths();
    std::size_t k = 0;
    while (s[k + 1] < arc_length) {
      ++k;
    }
    const Vector2 along = (line.points()[k + 1] - line.points()[k]).normalized();
    const Vector2 foot = line.points()[k] + (arc_length - s[k]) * along;
    const PolylineProjection found = line.project(foot + offset * Vector2(-along.y(), along.x()));
    if (std::abs(found.arc_length - arc_length) < 1e-6) {
      EXPECT_NEAR(found.lateral, offset, 1e-6);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(Polyline, SideAtASharpVertexIsItsOuterSide) {
  // Turns left by 150 degrees at (4, 0): ahead of the tip is outside, to the right.
  const Vector2 back(-std::cos(M_PI / 6.0), std::sin(M_PI / 6.0));
  const Polyline line({{0, 0}, {4, 0}, Vector2(4, 0) + 5.0 * back});
  for (const Vector2& query : {Vector2(4.5, 0.05), Vector2(4.5, 0.7), Vector2(4.1, -0.5)}) {
    const PolylineProjection found = line.project(query);
    EXPECT_DOUBLE_EQ(found.arc_length, 4.0);
    EXPECT_NEAR(found.lateral, -(query - Vector2(4, 0)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace forge
