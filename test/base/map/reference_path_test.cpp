#include "collision_forge/base/map/reference_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace forge {
namespace {

/// A circle of `radius` around (0, radius) from the origin, to the left, a point every `spacing`.
std::vector<Vector2> leftBend(double radius, double length, double spacing) {
  std::vector<Vector2> points;
  for (int i = 0; i * spacing <= length + 1e-9; ++i) {
    const double angle = i * spacing / radius;
    points.emplace_back(radius * std::sin(angle), radius * (1.0 - std::cos(angle)));
  }
  return points;
}

std::vector<Vector2> mirrored(std::vector<Vector2> points) {
  for (Vector2& point : points) point.y() = -point.y();
  return points;
}

TEST(ReferencePath, ReturnsCurvatureEveryMetre) {
  const ReferencePath left(Polyline(leftBend(15.0, 30.4, 1.0)));
  const std::vector<double> bends = left.curvatures();
  ASSERT_EQ(bends.size(), static_cast<std::size_t>(left.length()) + 1);
  EXPECT_NEAR(bends[15], 1.0 / 15.0, 2e-3);
  const std::vector<double> right =
      ReferencePath(Polyline(mirrored(leftBend(15.0, 30.4, 1.0)))).curvatures();
  ASSERT_EQ(right.size(), bends.size());
  EXPECT_NEAR(right[15], bends[15], 1e-9) << "without a sign";
  for (const double bend : ReferencePath(Polyline({{0.0, 0.0}, {30.0, 0.0}})).curvatures()) {
    EXPECT_EQ(bend, 1e-3) << "straight";
  }
}

/// Projects as ReferencePath::project(), but compares all controls.
double projectSlowly(const ReferencePath& path, const Vector2& point) {
  const std::vector<Vector2>& controls = path.controls();
  std::size_t closest = 1;
  for (std::size_t i = 1; i + 1 < controls.size(); ++i) {
    if ((controls[i] - point).squaredNorm() < (controls[closest] - point).squaredNorm())
      closest = i;
  }
  const double along = path.spacing() * static_cast<double>(closest - 1);
  const ReferencePath::PathPoint place = path.at(along);
  return along + place.heading.dot(point - place.pose.position());
}

TEST(ReferencePath, ProjectsFromTheFirstOfTheClosestControls) {
  const ReferencePath circles(Polyline(leftBend(8.0, 150.0, 1.0)));  // three times the same way
  const ReferencePath uneven(1.0, {{0.0, 0.0},
                                   {1.0, 0.0},
                                   {2.0, 0.0},
                                   {40.0, 3.0},
                                   {41.0, 0.0},
                                   {42.0, 1.0},
                                   {43.0, 0.0},
                                   {44.0, 9.0},
                                   {80.0, 0.0},
                                   {81.0, 0.0},
                                   {82.0, 0.0},
                                   {83.0, 0.0}});
  for (const ReferencePath& path : {circles, uneven}) {
    for (double x = -60.0; x <= 120.0; x += 1.7) {
      for (double y = -60.0; y <= 60.0; y += 1.3) {
        EXPECT_EQ(path.project({x, y}), projectSlowly(path, {x, y})) << x << ", " << y;
      }
    }
  }
}

TEST(ReferencePath, HasAParallelPath) {
  const ReferencePath left(Polyline(leftBend(15.0, 30.0, 1.0)));
  const ReferencePath inside = left.beside(2.0);
  EXPECT_NEAR(inside.length(), left.length() * 13.0 / 15.0, 0.6) << "nearer to the middle";
  const Pose2 middle = left.at(0.5 * left.length()).pose;
  const PathPose seen = inside.frenetOf(compose(middle, {0.0, 2.0, 0.0}));
  EXPECT_NEAR(seen.across, 0.0, 0.05);
  EXPECT_NEAR(seen.lean, 0.0, 0.02);
  EXPECT_NEAR(left.beside(-2.0).length(), left.length() * 17.0 / 15.0, 0.6);
}

TEST(ReferencePath, ContinuesStraightBeyondItsEnds) {
  const ReferencePath path(Polyline(leftBend(20.0, 20.0, 1.0)));
  for (const double beyond : {0.5, 3.0, 50.0}) {
    const ReferencePath::PathPoint before = path.at(-beyond);
    const Pose2 back = relativeTo(path.at(0.0).pose, before.pose);
    EXPECT_NEAR(back.x, -beyond, 1e-9);
    EXPECT_NEAR(back.y, 0.0, 1e-9);
    EXPECT_NEAR(back.yaw, 0.0, 1e-12);
    EXPECT_EQ(before.curvature, 0.0);
    const ReferencePath::PathPoint after = path.at(path.length() + beyond);
    const Pose2 on = relativeTo(path.at(path.length()).pose, after.pose);
    EXPECT_NEAR(on.x, beyond, 1e-9);
    EXPECT_NEAR(on.y, 0.0, 1e-9);
    EXPECT_NEAR(on.yaw, 0.0, 1e-12);
    EXPECT_EQ(after.curvature, 0.0);
  }
}

TEST(ReferencePath, CurvatureAndHeadingMatchTheBend) {
  for (const double radius : {10.0, 20.0, 60.0}) {
    for (const double side : {1.0, -1.0}) {
      const std::vector<Vector2> left = leftBend(radius, 30.0, 0.5);
      const ReferencePath path(Polyline(side > 0.0 ? left : mirrored(left)));
      for (double s = 6.0; s <= 24.0; s += 0.5) {
        const ReferencePath::PathPoint place = path.at(s);
        EXPECT_NEAR(place.curvature, side / radius, 0.05 / radius) << radius << " at " << s;
        // Means over 5 m of a bend lie inside it by up to 2 / radius, chords by 0.125 / radius.
        const double inner = radius - 2.0 / radius;
        EXPECT_NEAR(place.pose.yaw, side * s / inner, 0.02) << radius << " at " << s;
        const double apart = (place.pose.position() - Vector2(0.0, side * radius)).norm();
        EXPECT_NEAR(apart, inner, 0.3 / radius) << radius << " at " << s;
      }
    }
  }
}

TEST(ReferencePath, SmoothsKinks) {
  // A corner of 0.6 rad within a line, as between two lanes that do not join smoothly.
  const Vector2 corner(15.0, 0.0);
  const Vector2 end = corner + 15.0 * Vector2(std::cos(0.6), std::sin(0.6));
  const ReferencePath path(Polyline({{0.0, 0.0}, corner, end}));
  double turned = 0.0;
  for (double s = 0.0; s < path.length(); s += 0.1) {
    EXPECT_LT(std::abs(path.at(s).curvature), 0.2) << "a car can drive it, at " << s;
    turned += 0.1 * path.at(s).curvature;
    EXPECT_LT(std::abs(angleBetween(path.at(s).pose.yaw, path.at(s + 0.1).pose.yaw)), 0.03);
  }
  EXPECT_NEAR(turned, 0.6, 0.02) << "the turn as a whole stays";
  EXPECT_NEAR(path.at(5.0).pose.y, 0.0, 1e-9) << "what is away from the kink stays";
  EXPECT_GT(path.at(15.0).pose.y, 0.1);
}

TEST(ReferencePath, ProjectsToTheClosestPoint) {
  const ReferencePath path(Polyline(leftBend(20.0, 40.0, 1.0)));
  for (double s = -5.0; s <= 45.0; s += 1.37) {
    for (const double lateral : {-3.0, 0.0, 3.0}) {
      const Pose2 pose = compose(path.at(s).pose, {0.0, lateral, 0.0});
      EXPECT_NEAR(path.project(pose.position()), s, 0.1 + 0.03 * std::abs(lateral))
          << s << " " << lateral;
    }
  }
}

TEST(ReferencePath, ContinuesAShortLine) {
  const ReferencePath path(Polyline({{0.0, 0.0}, {0.0, 0.3}}));
  EXPECT_NEAR(path.length(), 0.3, 1e-9);
  EXPECT_NEAR(path.at(5.0).pose.y, 5.0, 1e-9);
  EXPECT_NEAR(path.at(5.0).pose.yaw, M_PI_2, 1e-9);
}

TEST(ReferencePath, ReturnsFrenetCoordinates) {
  const ReferencePath path(Polyline(leftBend(40.0, 60.0, 1.0)));
  const Pose2 place = path.at(25.0).pose;
  const PathPose seen = path.frenetOf(compose(place, {0.0, -1.5, 0.3}));
  EXPECT_NEAR(seen.along, 25.0, 0.1);
  EXPECT_NEAR(seen.across, -1.5, 0.05);
  EXPECT_NEAR(seen.lean, 0.3, 0.01);
}

}  // namespace
}  // namespace forge
