#include "collision_forge/planner_test/report/map_lines.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

const Eigen::AlignedBox2d kBox(Vector2(0.0, 0.0), Vector2(10.0, 10.0));

/// Returns the area of an open ring by the shoelace formula.
double areaOf(const std::vector<Vector2>& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2& next = ring[(i + 1) % ring.size()];
    twice += ring[i].x() * next.y() - next.x() * ring[i].y();
  }
  return std::abs(twice) / 2.0;
}

TEST(ClippedRing, KeepsTheInside) {
  const std::vector<Vector2> ring = {{1, 1}, {3, 1}, {3, 3}};
  EXPECT_EQ(clippedRing(ring, kBox), ring);
}

TEST(ClippedRing, ClipsAtEveryBorder) {
  // A square of 12 m around a corner of the box: a quarter of it is inside.
  EXPECT_DOUBLE_EQ(areaOf(clippedRing({{-6, -6}, {6, -6}, {6, 6}, {-6, 6}}, kBox)), 36.0);
  EXPECT_DOUBLE_EQ(areaOf(clippedRing({{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, kBox)), 100.0);
}

}  // namespace
}  // namespace forge
