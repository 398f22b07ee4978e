#include "collision_forge/attack/forecast/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

TEST(Random, TheSameSeedDrawsTheSame) {
  Random a(7);
  Random b(7);
  Random other(8);
  EXPECT_EQ(a.bell(1.0), b.bell(1.0));
  EXPECT_EQ(a.uniform(0.0, 1.0), b.uniform(0.0, 1.0));
  EXPECT_NE(a.uniform(0.0, 1.0), other.uniform(0.0, 1.0));
}

TEST(Random, UniformDrawsFillTheirRange) {
  Random random(1);
  double sum = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double draw = random.uniform(-2.0, 6.0);
    ASSERT_GE(draw, -2.0);
    ASSERT_LT(draw, 6.0);
    sum += draw;
  }
  EXPECT_NEAR(sum / 10000, 2.0, 0.1);
}

TEST(Random, BellsHaveTheRequestedDeviationAndNoTails) {
  Random random(2);
  constexpr int kDraws = 40000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double draw = random.bell(3.0);
    ASSERT_LE(std::abs(draw), 3.0 * 2.0 * std::sqrt(3.0));
    sum += draw;
    squares += draw * draw;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.06);
  EXPECT_NEAR(std::sqrt(squares / kDraws), 3.0, 0.06);
}

}  // namespace
}  // namespace forge
