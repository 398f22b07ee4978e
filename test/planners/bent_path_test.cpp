#include "collision_forge/planners/bent_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

TEST(BentPath, StartsAtTheVehicleAndEndsOnTheLine) {
  const Polyline line({{0.0, 0.0}, {100.0, 0.0}});
  const BentPath path(line, 20.0, {20.0, 1.5}, 3.5, 0.4);
  EXPECT_NEAR(path.at(0.0).x, 20.0, 1e-12);
  EXPECT_NEAR(path.at(0.0).y, 1.5, 1e-12);
  EXPECT_NEAR(path.at(3.5).y, 1.5 * std::exp(-1.0), 1e-12);
  EXPECT_NEAR(path.at(15.0).x, 35.0, 1e-12);
  EXPECT_NEAR(path.at(15.0).y, 0.0, 1e-6);
}

TEST(BentPath, HeadingsAreThoseOfThePath) {
  const Polyline line({{0.0, 0.0}, {100.0, 0.0}});
  const BentPath path(line, 0.0, {0.0, 1.5}, 3.5, 0.4);
  EXPECT_NEAR(path.at(0.0).yaw, 0.0, 0.06);
  // The slope of 1.5 exp(-s^2 / 12.25) in the middle of the 0.4 m.
  const double s = 2.7;
  const double slope = -1.5 * 2.0 * s / 12.25 * std::exp(-s * s / 12.25);
  EXPECT_NEAR(path.at(2.5).yaw, std::atan(slope), 1e-3);
}

TEST(BentPath, GoesStraightOnBeyondTheLine) {
  const Polyline line({{0.0, 0.0}, {3.0, 4.0}});
  const Pose2 pose = BentPath(line, 0.0, {0.0, 0.0}, 3.5, 0.4).at(20.0);
  EXPECT_NEAR(pose.x, 12.0, 1e-9);
  EXPECT_NEAR(pose.y, 16.0, 1e-9);
}

}  // namespace
}  // namespace forge
