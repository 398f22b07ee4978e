#include "collision_forge/base/scene/attack.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

TEST(MissBetween, IsTheDistanceOfTheCentresAndTheShorterTurn) {
  const PatternMiss miss = missBetween({-4.0, 1.0, M_PI - 0.1}, {-1.0, 5.0, -M_PI + 0.2});
  EXPECT_NEAR(miss.distance, 5.0, 1e-12);
  EXPECT_NEAR(miss.heading, 0.3, 1e-12);
  EXPECT_EQ(missBetween({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}).distance, 0.0);
}

TEST(CornerMiss, BoundsTheDisplacementOfEveryCorner) {
  const BoxSize size{4.6, 1.9};
  for (const Pose2& found : {Pose2{0.5, -0.2, 0.3}, {0.0, 0.0, -0.4}, {2.0, 1.0, 0.0}}) {
    const double bound = cornerMiss(missBetween({}, found), size);
    const auto from = corners({{}, size});
    const auto to = corners({found, size});
    double farthest = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      farthest = std::max(farthest, (to[i] - from[i]).norm());
    }
    EXPECT_GE(bound, farthest);
    EXPECT_LE(bound, 2.0 * farthest) << "and of its order";
  }
}

}  // namespace
}  // namespace forge
