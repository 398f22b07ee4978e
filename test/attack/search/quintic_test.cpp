#include "collision_forge/attack/search/quintic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace forge {
namespace {

void expectState(const AxisState& state, const AxisState& expected) {
  EXPECT_NEAR(state.position, expected.position, 1e-9 * (1.0 + std::abs(expected.position)));
  EXPECT_NEAR(state.velocity, expected.velocity, 1e-8);
  EXPECT_NEAR(state.acceleration, expected.acceleration, 1e-7);
}

TEST(Quintic, MeetsAllSixBoundaryValues) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-50.0, 50.0);
  for (const double duration : {0.5, 1.0, 2.37, 9.0}) {
    const AxisState start{value(random), value(random), value(random)};
    const AxisState end{value(random), value(random), value(random)};
    const Quintic quintic(start, end, duration);
    expectState(quintic.at(0.0), start);
    expectState(quintic.at(duration), end);
  }
}

TEST(Quintic, VelocityAndAccelerationAreTheDerivativesOfPosition) {
  const Quintic quintic({1.0, 5.0, -1.0}, {30.0, -2.0, 3.0}, 4.0);
  constexpr double kStep = 1e-4;
  for (double time = 0.1; time < 4.0; time += 0.3) {
    const AxisState before = quintic.at(time - kStep);
    const AxisState after = quintic.at(time + kStep);
    const AxisState state = quintic.at(time);
    EXPECT_NEAR(state.velocity, (after.position - before.position) / (2.0 * kStep), 1e-6);
    EXPECT_NEAR(state.acceleration, (after.velocity - before.velocity) / (2.0 * kStep), 1e-6);
  }
}

TEST(Quintic, ReproducesAParabola) {
  const auto parabola = [](double t) {
    return AxisState{2.0 + 3.0 * t + 2.0 * t * t, 3.0 + 4.0 * t, 4.0};
  };
  const Quintic quintic(parabola(0.0), parabola(3.0), 3.0);
  for (double time = 0.0; time <= 3.0; time += 0.25) expectState(quintic.at(time), parabola(time));
}

TEST(Quintic, IsHalfWayAtHalfTimeFromRestToRest) {
  const Quintic quintic({0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}, 2.0);
  expectState(quintic.at(1.0), {4.0, 1.875 * 8.0 / 2.0, 0.0});
}

TEST(Quintic, NeedsAPositiveDuration) {
  for (const double duration : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Quintic({}, {}, duration), std::invalid_argument) << duration;
  }
}

}  // namespace
}  // namespace forge
