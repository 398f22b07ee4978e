#include "collision_forge/attack/search/speed_variation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

TEST(SpeedVariation, DistanceIntegratesItsAcceleration) {
  const SpeedVariation variation{0.7, 5.0, 0.8};
  const auto acceleration = [](double time) {
    return 0.7 * std::sin(2.0 * M_PI / 5.0 * time + 0.8);
  };
  // Integrated twice, from now on at no difference in speed.
  constexpr double kStep = 1e-4;
  for (const double end : {3.0, -4.0}) {
    const double step = std::copysign(kStep, end);
    double speed = 0.0;
    double distance = 0.0;
    for (int i = 0; i < static_cast<int>(std::abs(end) / kStep + 0.5); ++i) {
      const double middle = speed + 0.5 * step * acceleration(step * (i + 0.25));
      speed += step * acceleration(step * (i + 0.5));
      distance += step * middle;
    }
    EXPECT_NEAR(variation.distanceGained(end), distance, 1e-3) << end;
  }
  EXPECT_EQ(variation.distanceGained(0.0), 0.0);
}

TEST(SpeedVariation, IsZeroByDefault) { EXPECT_EQ(SpeedVariation().distanceGained(-3.0), 0.0); }

TEST(SpeedVariation, DependsOnIdAndSeedOnly) {
  const SpeedVariation first = variationOf("a", 1);
  EXPECT_EQ(variationOf("a", 1).phase, first.phase);
  EXPECT_NE(variationOf("b", 1).phase, first.phase);
  EXPECT_NE(variationOf("a", 2).phase, first.phase);
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const SpeedVariation variation = variationOf("a", seed);
    EXPECT_GE(variation.amplitude, 0.0);
    EXPECT_LE(variation.amplitude, kMaxVariation);
    EXPECT_GE(variation.period, kShortestPeriod);
    EXPECT_LE(variation.period, kLongestPeriod);
  }
}

}  // namespace
}  // namespace forge
