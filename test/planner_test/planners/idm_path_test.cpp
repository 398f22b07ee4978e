#include "collision_forge/planner_test/planners/idm_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace forge {
namespace {

/// A path 20 m east, then 20 m north, with a node every 5 m; the corner is a duplicate node.
std::vector<Pose2> corner() {
  std::vector<Pose2> nodes;
  for (int x = 0; x <= 20; x += 5) nodes.push_back({1.0 * x, 0.0, 0.0});
  for (int y = 0; y <= 20; y += 5) nodes.push_back({20.0, 1.0 * y, M_PI_2});
  return nodes;
}

TEST(IdmPath, EndsAtTheLastNodeButOne) {
  const IdmPath path(corner());
  EXPECT_NEAR(path.end(), 35.0, 1e-9);
  EXPECT_NEAR(path.at(100.0).y, 15.0, 1e-9);
  EXPECT_NEAR(path.project({20.0, 19.0}), 39.0, 1e-9);
}

TEST(IdmPath, PositionAndHeadingAreLinearBetweenNodes) {
  const IdmPath path(corner());
  EXPECT_NEAR(path.at(7.0).x, 7.0, 1e-9);
  EXPECT_NEAR(path.at(17.5).yaw, M_PI_4, 1e-9);  // to the second of the nodes at the corner
  EXPECT_NEAR(path.at(22.0).yaw, M_PI_2, 1e-9);
  EXPECT_EQ(path.at(-3.0).x, 0.0);
}

TEST(IdmPath, NeedsTwoNodes) {
  EXPECT_THROW(IdmPath({{1.0, 2.0, 0.0}, {1.0, 2.0, 0.0}}), std::invalid_argument);
}

OrientedBox boxOf(double x, double y) { return {{x, y, 0.0}, {1.0, 1.0}}; }

bool touches(const OrientedBox& box, double from) {
  const IdmPath path(corner());
  return IdmCorridor(path, {box}, 2.0).touchedFrom(from).front();
}

TEST(IdmCorridor, HasTheGivenWidth) {
  EXPECT_TRUE(touches(boxOf(8.0, 1.45), 0.0));
  EXPECT_FALSE(touches(boxOf(8.0, 1.55), 0.0));
}

/// A spiral of three turns, so that a box near one turn is close to the next.
std::vector<Pose2> spiral() {
  std::vector<Pose2> nodes;
  for (int i = 0; i <= 600; ++i) {
    const double angle = M_PI * i / 100.0;
    const double radius = 20.0 + 2.0 * angle;
    nodes.push_back({radius * std::cos(angle), radius * std::sin(angle), angle + M_PI_2});
  }
  return nodes;
}

TEST(IdmCorridor, MatchesAnExhaustiveSearchOnALongSpiralPath) {
  constexpr unsigned kSeed = 5;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> place(-70.0, 70.0), yaw(-M_PI, M_PI), start(0.0, 1.0);
  const IdmPath path(spiral());
  constexpr double kWidth = 2.0, kStep = 0.1, kUnclear = 0.05;  // m
  int touched = 0, clear = 0;
  for (int i = 0; i < 300; ++i) {
    const OrientedBox box{{place(random), place(random), yaw(random)}, {4.0, 1.8}};
    const double from = start(random) * (path.end() - 10.0);
    double nearest = std::numeric_limits<double>::infinity();
    for (double at = from; at <= path.end(); at += kStep) {
      nearest = std::min(nearest, distance({path.at(at), {0.0, 0.0}}, box));
    }
    const bool is_near_an_end =  // which are square
        distance({path.at(from), {kWidth, kWidth}}, box) == 0.0 ||
        distance({path.at(path.end()), {kWidth, kWidth}}, box) == 0.0;
    if (is_near_an_end || std::abs(nearest - 0.5 * kWidth) < kUnclear) continue;
    const bool is_touched = nearest < 0.5 * kWidth;
    EXPECT_EQ(IdmCorridor(path, {box}, kWidth).touchedFrom(from).front(), is_touched) << i;
    ++(is_touched ? touched : clear);
  }
  EXPECT_GT(touched, 20);
  EXPECT_GT(clear, 50);
}

}  // namespace
}  // namespace forge
