#include "collision_forge/planners/circle_chain.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(CircleChain, TouchesTheEndsAndSidesOfTheBox) {
  const CircleChain chain = circlesOf({4.6, 1.8}, 5);
  EXPECT_DOUBLE_EQ(chain.radius, 0.9);
  EXPECT_DOUBLE_EQ(chain.reach + chain.radius, 2.3);
  const PlacedChain there = placed(chain, {10.0, 5.0, 0.5 * M_PI});
  ASSERT_EQ(there.centers.size(), 5U);
  EXPECT_NEAR(there.centers.front().y(), 5.0 - 1.4, 1e-12);
  EXPECT_NEAR(there.centers.back().y(), 5.0 + 1.4, 1e-12);
  EXPECT_NEAR(there.centers[2].x(), 10.0, 1e-12);
}

TEST(CircleChain, AWideBoxHasItsCirclesInTheMiddle) {
  const CircleChain chain = circlesOf({0.6, 0.8}, 5);
  EXPECT_DOUBLE_EQ(chain.radius, 0.3);
  EXPECT_NEAR(chain.reach, 0.0, 1e-12);
}

TEST(CircleChain, DistanceIsThatOfTheNearestMiddles) {
  const CircleChain chain = circlesOf({4.6, 1.8}, 5);
  const PlacedChain here = placed(chain, {0.0, 0.0, 0.0});
  EXPECT_NEAR(centerDistance(here, placed(chain, {0.0, 3.5, 0.0})), 3.5, 1e-12);
  EXPECT_NEAR(centerDistance(here, placed(chain, {10.0, 0.0, 0.0})), 10.0 - 2.8, 1e-12);
  EXPECT_NEAR(centerDistance(here, placed(chain, {5.4, 3.0, 0.5 * M_PI})),
              std::hypot(5.4 - 1.4, 3.0 - 1.4), 1e-12);
}

}  // namespace
}  // namespace forge
