#include "collision_forge/base/scene/traffic_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace forge {
namespace {

const TrafficLight kLight{"7", {0.0, 0.0}, {{1.0, LightColor::kRed}, {3.0, LightColor::kGreen}}};

TEST(TrafficLight, KeepsItsColourUntilTheNextState) {
  EXPECT_EQ(colorAt(kLight, 0.9), LightColor::kUnknown);
  EXPECT_EQ(colorAt(kLight, 1.0), LightColor::kRed);
  EXPECT_EQ(colorAt(kLight, 2.9), LightColor::kRed);
  EXPECT_EQ(colorAt(kLight, 9.0), LightColor::kGreen);
}

TEST(TrafficLight, ShiftsToAnotherClock) {
  EXPECT_EQ(colorAt(shifted({kLight}, -1.0).front(), 0.0), LightColor::kRed);
}

TEST(TrafficLight, RedLanesAreThoseOfRedLights) {
  EXPECT_THAT(redLanes({kLight, {"8", {}, {{0.0, LightColor::kRed}}}}, 4.0),
              testing::ElementsAre("8"));
}

}  // namespace
}  // namespace forge
