#include "collision_forge/planners/idm_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace forge {
namespace {

/// East for 20 m, then north for 20 m, a node every 5 m; the corner is there twice.
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

TEST(IdmPath, IsNotCutShortByAPieceOfAWholeRoad) {
  const IdmPath path({{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}});
  EXPECT_NEAR(path.end(), 80.0, 1e-9);
}

TEST(IdmPath, NeedsTwoNodes) {
  EXPECT_THROW(IdmPath({{1.0, 2.0, 0.0}, {1.0, 2.0, 0.0}}), std::invalid_argument);
}

OrientedBox boxOf(double x, double y) { return {{x, y, 0.0}, {1.0, 1.0}}; }

bool touches(const OrientedBox& box, double from) {
  const IdmPath path(corner());
  return IdmCorridor(path, {box}, 2.0).touchedFrom(from).front();
}

TEST(IdmCorridor, IsAsWideAsAskedFor) {
  EXPECT_TRUE(touches(boxOf(8.0, 1.45), 0.0));
  EXPECT_FALSE(touches(boxOf(8.0, 1.55), 0.0));
}

TEST(IdmCorridor, BeginsHalfAWidthBehindTheStart) {
  EXPECT_TRUE(touches(boxOf(8.0, 0.0), 9.4));
  EXPECT_FALSE(touches(boxOf(8.0, 0.0), 9.6));
  EXPECT_FALSE(touches(boxOf(8.0, 0.0), 16.0));
}

TEST(IdmCorridor, EndsHalfAWidthBehindThePathsEnd) {
  EXPECT_TRUE(touches(boxOf(20.0, 16.4), 0.0));
  EXPECT_FALSE(touches(boxOf(20.0, 16.6), 0.0));
}

TEST(IdmCorridor, IsRoundOutsideACorner) {
  EXPECT_TRUE(touches(boxOf(21.4, 0.0), 0.0));
  EXPECT_FALSE(touches(boxOf(21.3, -1.3), 0.0));  // 0.8 m off either way: 1.13 m
}

}  // namespace
}  // namespace forge
