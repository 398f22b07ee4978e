#include "collision_forge/base/geometry/touch_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

TEST(TouchPoint, IsTheMiddleOfTheSharedSide) {
  const OrientedBox front{{10, 0, 0}, {4, 2}};
  EXPECT_TRUE(touchPoint(front, {{5.5, 0, 0}, {5, 2}}).isApprox(Vector2(8, 0)));
  EXPECT_TRUE(touchPoint(front, {{5.5, 1, 0}, {5, 2}}).isApprox(Vector2(8, 0.5)));
}

TEST(TouchPoint, IsTheCornerThatTouchesASide) {
  const double half_diagonal = std::sqrt(2.0);
  const OrientedBox diamond{{-half_diagonal, 0.3, std::atan(1.0)}, {2, 2}};
  EXPECT_TRUE(touchPoint({{2, 0, 0}, {4, 2}}, diamond).isApprox(Vector2(0, 0.3), 1e-9));
}

}  // namespace
}  // namespace forge
