#include "collision_forge/io/drawing/viewport.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace forge {
namespace {

const PixelRect kArea{100, 50, 400, 200};

TEST(Viewport, PutsTheCenterInTheMiddleAndNorthUp) {
  const Viewport viewport(kArea, {1000, -500}, 4.0);
  EXPECT_TRUE(viewport.toPixel({1000, -500}).isApprox(Vector2(300, 150)));
  EXPECT_TRUE(viewport.toPixel({1010, -500}).isApprox(Vector2(340, 150)));
  EXPECT_TRUE(viewport.toPixel({1000, -490}).isApprox(Vector2(300, 110)));
}

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

TEST(FitViewport, FitsTheTurnedPoints) {
  const Viewport wide = fitViewport(kArea, {{5, 0}, {5, 70}, {-5, 35}}, 5.0, 1.0, M_PI_2);
  EXPECT_DOUBLE_EQ(wide.pixelsPerMetre(), 5.0);
  EXPECT_TRUE(wide.toPixel({0, 35}).isApprox(kArea.center()));
  EXPECT_TRUE(wide.toPixel({0, 70}).isApprox(Vector2(475, 150)));
}

TEST(FitViewport, KeepsTheMarginAlongTheTighterAxis) {
  const Viewport wide = fitViewport(kArea, {{0, 0}, {70, 10}}, 5.0, 1.0);
  EXPECT_DOUBLE_EQ(wide.pixelsPerMetre(), 5.0);
  EXPECT_TRUE(wide.toPixel({0, 5}).isApprox(Vector2(125, 150)));
  EXPECT_TRUE(wide.toPixel({70, 5}).isApprox(Vector2(475, 150)));
  const Viewport tall = fitViewport(kArea, {{0, 0}, {10, 90}}, 5.0, 1.0);
  EXPECT_DOUBLE_EQ(tall.pixelsPerMetre(), 2.0);
}

TEST(FitViewport, ShowsAtLeastTheLeastExtent) {
  const Viewport viewport = fitViewport(kArea, {{3, 4}}, 0.5, 40.0);
  EXPECT_DOUBLE_EQ(viewport.pixelsPerMetre(), 5.0);
  EXPECT_TRUE(viewport.toPixel({3, 4}).isApprox(kArea.center()));
}

TEST(FitViewport, RefusesNoPoints) {
  EXPECT_THROW(fitViewport(kArea, {}, 1.0, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace forge
