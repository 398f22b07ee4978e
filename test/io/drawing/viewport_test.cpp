#include "collision_forge/io/drawing/viewport.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

const PixelRect kArea{100, 50, 400, 200};

TEST(Viewport, ToWorldUndoesToPixel) {
  const Viewport viewport(kArea, {1000, -500}, 3.7);
  EXPECT_TRUE(viewport.toWorld(viewport.toPixel({987.6, -512.3})).isApprox(Vector2(987.6, -512.3)));
}

TEST(Viewport, TurnsItsDirectionToTheRight) {
  const Viewport north_right(kArea, {1000, -500}, 4.0, M_PI_2);
  EXPECT_TRUE(north_right.toPixel({1000, -490}).isApprox(Vector2(340, 150)));
  EXPECT_TRUE(north_right.toPixel({990, -500}).isApprox(Vector2(300, 110)));
  EXPECT_TRUE(north_right.toWorld(Vector2(340, 150)).isApprox(Vector2(1000, -490)));
}

TEST(FitViewport, FitsTheRotatedPoints) {
  const Viewport wide = fitViewport(kArea, {{5, 0}, {5, 70}, {-5, 35}}, 5.0, 1.0, M_PI_2);
  EXPECT_DOUBLE_EQ(wide.pixelsPerMetre(), 5.0);
  EXPECT_TRUE(wide.toPixel({0, 35}).isApprox(kArea.center()));
  EXPECT_TRUE(wide.toPixel({0, 70}).isApprox(Vector2(475, 150)));
}

}  // namespace
}  // namespace forge
