#include "collision_forge/planner_test/planners/dormand_prince.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

using State = Eigen::Vector2d;

constexpr IntegrationTolerance kTight{1e-10, 1e-10};

/// Turns by one radian a second.
State turning(const State& state) { return {-state[1], state[0]}; }

TEST(DormandPrince, FollowsACircle) {
  const Integral integral = integrateDormandPrince(turning, {1.0, 0.0}, 2.0, kTight);
  EXPECT_TRUE(integral.is_complete);
  EXPECT_NEAR(integral.state[0], std::cos(2.0), 1e-8);
  EXPECT_NEAR(integral.state[1], std::sin(2.0), 1e-8);
}

TEST(DormandPrince, ErrorsShrinkWithTheTolerance) {
  const auto error = [](double tolerance) {
    const State state =
        integrateDormandPrince(turning, {1.0, 0.0}, 10.0, {tolerance, tolerance}).state;
    return (state - State(std::cos(10.0), std::sin(10.0))).norm();
  };
  EXPECT_LT(error(1e-3), 0.1);
  EXPECT_LT(error(1e-6), 0.01 * error(1e-3));
}

TEST(DormandPrince, WhatDoesNotChangeStays) {
  const auto standing = [](const State&) { return State(0.0, 0.0); };
  EXPECT_EQ(integrateDormandPrince(standing, {3.0, 0.0}, 1.0, kTight).state, State(3.0, 0.0));
}

TEST(DormandPrince, KeepsTheLastGoodStateWhereNoStepIsSmallEnough) {
  // 1 / (1 - t) at t = 1.
  const auto exploding = [](const State& state) { return State(1.0, state[1] * state[1]); };
  const Integral integral = integrateDormandPrince(exploding, {0.0, 1.0}, 2.0, kTight);
  EXPECT_FALSE(integral.is_complete);
  EXPECT_NEAR(integral.state[0], 1.0, 1e-6);
}

TEST(DormandPrince, ARateThatIsNoNumberIsNoStep) {
  const auto nowhere = [](const State&) { return State(std::nan(""), 0.0); };
  const Integral integral = integrateDormandPrince(nowhere, {3.0, 4.0}, 1.0, kTight);
  EXPECT_FALSE(integral.is_complete);
  EXPECT_EQ(integral.state, State(3.0, 4.0));
}

}  // namespace
}  // namespace forge
