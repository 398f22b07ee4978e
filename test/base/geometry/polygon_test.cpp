#include "collision_forge/base/geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/geometry/reference_geometry.h"

namespace forge {
namespace {

using Ring = std::vector<Vector2>;

// Winding number of the ring around the point, from the angles of its edges.
int windings(const Ring& ring, const Vector2& point) {
  double total = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i] - point;
    const Vector2 b = ring[(i + 1) % ring.size()] - point;
    total += std::atan2(reference::cross(a, b), a.dot(b));
  }
  return static_cast<int>(std::lround(total / (2.0 * M_PI)));
}

// A star-shaped ring, so that it never crosses itself.
Ring randomRing(reference::Random& random, const Vector2& center, double low, double high) {
  Ring ring;
  const int count = static_cast<int>(random.between(3.0, 40.0));
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count;
    ring.push_back(center + random.between(low, high) * Vector2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

TEST(Polygon, HoleIsOutside) {
  const Polygon square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}};
  EXPECT_TRUE(contains(square, {1.0, 5.0}));
  EXPECT_TRUE(contains(square, {7.0, 5.0}));
  EXPECT_FALSE(contains(square, {5.0, 5.0}));
  EXPECT_FALSE(contains(square, {-1.0, 5.0}));
  EXPECT_FALSE(contains(square, {11.0, 5.0}));
}

TEST(Polygon, VertexLevelWithThePointCountsOnce) {
  const Polygon diamond{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, {}};
  EXPECT_TRUE(contains(diamond, {0.0, 0.0}));
  EXPECT_FALSE(contains(diamond, {-2.0, 0.0}));
  EXPECT_FALSE(contains(diamond, {-2.0, 1.0}));
  EXPECT_FALSE(contains(diamond, {-2.0, -1.0}));
}

TEST(Polygon, RingsOfFewerThanThreePointsHoldNothing) {
  EXPECT_FALSE(contains({}, {0.0, 0.0}));
  EXPECT_FALSE(contains({{{0, 0}}, {}}, {0.0, 0.0}));
  EXPECT_FALSE(contains({{{0, 0}, {1, 1}}, {}}, {0.4, 0.5}));
}

TEST(Polygon, AgreesWithWindingNumbers) {
  reference::Random random(8);
  int inside = 0;
  for (int i = 0; i < 500; ++i) {
    Polygon polygon{
        randomRing(random, {0.0, 0.0}, 5.0, 10.0),
        {randomRing(random, {1.5, 0.0}, 0.3, 1.4), randomRing(random, {-1.5, 0.0}, 0.3, 1.4)}};
    if (i % 2 == 1) {
      std::reverse(polygon.exterior.begin(), polygon.exterior.end());
      std::reverse(polygon.holes[0].begin(), polygon.holes[0].end());
    }
    for (int k = 0; k < 100; ++k) {
      const Vector2 point(random.between(-10.0, 10.0), random.between(-10.0, 10.0));
      const bool expected = windings(polygon.exterior, point) != 0 &&
                            windings(polygon.holes[0], point) == 0 &&
                            windings(polygon.holes[1], point) == 0;
      EXPECT_EQ(contains(polygon, point), expected);
      inside += expected;
    }
  }
  EXPECT_GT(inside, 10000);
  EXPECT_LT(inside, 40000);
}

}  // namespace
}  // namespace forge
