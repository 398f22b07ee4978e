#include "collision_forge/ros/markers/shown_area.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

const BoxSize kCar{4.6, 1.9};

TEST(ShownArea, AroundOneBoxIsCentredAndHasTheLeastWidth) {
  const ShownArea area = areaAround({{{7.0, -3.0, 1.0}, kCar}}, kUsualWidth);
  EXPECT_DOUBLE_EQ(area.size().x(), kUsualWidth);
  EXPECT_LT(area.size().y(), kUsualWidth);
  EXPECT_NEAR(area.middle().x(), 7.0, 1e-9);
  EXPECT_NEAR(area.middle().y(), -3.0, 1e-9);
}

TEST(ShownArea, ContainsAllBoxesWithAMargin) {
  const ShownArea area =
      areaAround({{{0.0, 0.0, 0.0}, kCar}, {{100.0, 150.0, M_PI / 2}, kCar}}, kCrashWidth);
  EXPECT_LT(area.lowest.x(), -2.3 - 5.0);
  EXPECT_GT(area.highest.x(), 100.95 + 5.0);
  EXPECT_LT(area.lowest.y(), -0.95 - 5.0);
  EXPECT_GT(area.highest.y(), 152.3 + 5.0);
}

TEST(ShownArea, ScalesLettersToAConstantSizeOnTheScreen) {
  const auto letters = [](double width) {
    return letterScale(areaAround({{{0.0, 0.0, 0.0}, kCar}}, width)) / width;
  };
  EXPECT_DOUBLE_EQ(letters(kUsualWidth) * kUsualWidth, 1.0);
  EXPECT_DOUBLE_EQ(letters(120.0), letters(kUsualWidth));
}

}  // namespace
}  // namespace forge
