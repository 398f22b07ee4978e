#include "collision_forge/ros/markers/label_places.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

const OrientedBox kCar{{0.0, 0.0, M_PI / 6}, {4.6, 1.9}};

TEST(LabelPlaces, LieBesideTheirBoxAndCoverNoOther) {
  const BoxSize text = textSize("012345", 1.0);
  std::vector<OrientedBox> boxes{kCar};
  for (LabelSide side = freestSide(kCar, text, boxes); side.covered == 0;
       side = freestSide(kCar, text, boxes)) {
    const Vector2 place = placeBeside(kCar, text, side);
    const OrientedBox label{{place.x(), place.y(), 0.0}, text};
    for (const OrientedBox& box : boxes) EXPECT_FALSE(overlaps(label, box));
    boxes.push_back(label);
    ASSERT_LT(boxes.size(), 30U);
  }
  EXPECT_GT(boxes.size(), 4U);
}

TEST(LabelPlaces, SweepABoxAlongItsVelocity) {
  const OrientedBox swept = sweptBox(kCar, {0.0, 3.0}, 2.0);
  EXPECT_TRUE(overlaps(swept, {{0.0, 7.5, 0.0}, {0.1, 0.1}}));
  EXPECT_FALSE(overlaps(swept, {{0.0, -3.0, 0.0}, {0.1, 0.1}}));
  EXPECT_NEAR(sweptBox(kCar, {0.0, 0.0}, 2.0).center.yaw, kCar.center.yaw, 1e-12);
}

TEST(LabelPlaces, CoverTheFewestObstaclesIfNoPlaceIsFree) {
  const BoxSize text = textSize("0", 1.0);
  // Everything is covered once, all but what lies above the car twice.
  const std::vector<OrientedBox> boxes{{{0.0, 0.0, 0.0}, {100.0, 100.0}},
                                       {{0.0, -48.0, 0.0}, {100.0, 100.0}}};
  const LabelSide side = freestSide(kCar, text, boxes);
  EXPECT_EQ(side.covered, 1U);
  EXPECT_GT(placeBeside(kCar, text, side).y(), 2.0);
}

}  // namespace
}  // namespace forge
