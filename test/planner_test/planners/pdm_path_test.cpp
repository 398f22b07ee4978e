#include "collision_forge/planner_test/planners/pdm_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace forge {
namespace {

/// East for 10 m, then north for 10 m; the corner appears twice.
PdmPath corner() {
  return PdmPath({{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {10.0, 0.0, 1.57}, {10.0, 10.0, 1.57}});
}

TEST(PdmPath, InterpolatesPlaceAndHeading) {
  const PdmPath path({{0.0, 0.0, 3.0}, {-4.0, 0.0, -3.0}});
  const Pose2 pose = path.at(1.0);
  EXPECT_NEAR(pose.x, -1.0, 1e-12);
  EXPECT_NEAR(pose.yaw, 3.0 + 0.25 * (2.0 * M_PI - 6.0), 1e-12);
  EXPECT_NEAR(path.at(99.0).x, -4.0, 1e-12);
  EXPECT_NEAR(path.at(-1.0).x, 0.0, 1e-12);
}

TEST(PdmPath, ProjectsOntoTheNearestPlace) {
  const PdmPath path = corner();
  EXPECT_NEAR(path.length(), 20.0, 1e-12);
  EXPECT_NEAR(path.project({4.0, 1.0}), 4.0, 1e-12);
  EXPECT_NEAR(path.project({9.0, 6.0}), 16.0, 1e-12);
  EXPECT_NEAR(path.project({30.0, -5.0}), 10.0, 1e-12);
  EXPECT_NEAR(path.project({-3.0, 1.0}), 0.0, 1e-12);
}

TEST(PdmPath, LongPathsAreSearchedWhole) {
  std::vector<Pose2> nodes;
  for (int i = 0; i <= 400; ++i) {
    const double angle = 0.02 * i;
    nodes.push_back({50.0 * std::cos(angle), 50.0 * std::sin(angle) + 0.1 * i, angle + M_PI / 2});
  }
  const PdmPath path(nodes);
  for (const std::size_t i : {0U, 17U, 133U, 388U}) {
    const Pose2 there = path.at(path.project(nodes[i].position()));
    EXPECT_NEAR((there.position() - nodes[i].position()).norm(), 0.0, 1e-9) << i;
  }
}

TEST(PdmPath, ShiftedNodesAreToTheLeft) {
  const Pose2 pose = corner().shifted(1.0).at(0.0);
  EXPECT_NEAR(pose.y, 1.0, 1e-12);
  EXPECT_NEAR(corner().shifted(-1.0).at(0.0).y, -1.0, 1e-12);
}

TEST(PdmPath, AheadBeginsAtTheNextNode) {
  EXPECT_NEAR(corner().ahead(3.0).length(), 10.0, 1e-12);
  EXPECT_NEAR(corner().ahead(-1.0).length(), 20.0, 1e-12);
  EXPECT_NEAR(corner().ahead(15.0).length(), 10.0, 1e-12);  // the last piece at least
}

TEST(PdmPath, TheCorridorHasItsWidthAndSquareEnds) {
  const PdmPath path({{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}});
  const auto touches = [&](const Pose2& pose) {
    return path.corridorTouches({pose, {2.0, 1.0}}, 1.0);
  };
  EXPECT_TRUE(touches({5.0, 1.49, 0.0}));
  EXPECT_FALSE(touches({5.0, 1.51, 0.0}));
  EXPECT_TRUE(touches({5.0, 1.99, 0.5 * M_PI}));
  EXPECT_TRUE(touches({-1.9, 0.0, 0.0}));
  EXPECT_FALSE(touches({-2.1, 0.0, 0.0}));
  EXPECT_TRUE(touches({11.9, 1.4, 0.0}));  // a round end would miss it
  EXPECT_FALSE(touches({12.1, 0.0, 0.0}));
}

TEST(PdmPath, NeedsTwoDistinctPlaces) {
  EXPECT_THROW(PdmPath({}), std::invalid_argument);
  EXPECT_THROW(PdmPath({{1.0, 1.0, 0.0}, {1.0, 1.0, 0.3}}), std::invalid_argument);
}

}  // namespace
}  // namespace forge
