#include "collision_forge/base/geometry/simplified_line.h"

#include <gtest/gtest.h>

#include <limits>

namespace forge {
namespace {

TEST(Simplified, DropsPointsOnStraightParts) {
  EXPECT_EQ(simplified({{0, 0}, {1, 0.05}, {2, 0}, {3, 0}}, 0.1),
            (std::vector<Vector2>{{0, 0}, {3, 0}}));
}

TEST(Simplified, KeepsCornersBeyondTheTolerance) {
  const std::vector<Vector2> corner = {{0, 0}, {5, 0}, {5, 5}};
  EXPECT_EQ(simplified(corner, 0.1), corner);
}

TEST(Simplified, KeepsLinesWithNonFinitePoints) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(simplified({{0, 0}, {1, infinity}, {2, 0}}, 1.0).size(), 3u);
}

}  // namespace
}  // namespace forge
