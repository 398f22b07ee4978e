#include "collision_forge/planner_test/planners/lane_paths.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

/// Edges of 1 m: 0 - 1 - 2, then 3 or 4; 5 leads to 1 as well.
LaneGraph fork() {
  return {{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {3.0, 0.0}, {2.0, 1.0}, {1.0, -1.0}},
          {{0, 1}, {1, 2}, {2, 3}, {2, 4}, {5, 1}}};
}

TEST(NodePaths, FollowEveryBranchInEdgeOrder) {
  EXPECT_EQ(nodePaths(fork(), 0, PathDirection::kAhead, 10.0, 9),
            (std::vector<NodePath>{{0, 1, 2, 3}, {0, 1, 2, 4}}));
}

TEST(NodePaths, EndWhenTheyAreLongEnough) {
  EXPECT_EQ(nodePaths(fork(), 0, PathDirection::kAhead, 1.5, 9),
            (std::vector<NodePath>{{0, 1, 2}}));
  EXPECT_EQ(nodePaths(fork(), 0, PathDirection::kAhead, 0.0, 9), (std::vector<NodePath>{{0}}));
}

TEST(NodePaths, GoRoundACircle) {
  const LaneGraph circle({{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, {{0, 1}, {1, 2}, {2, 0}});
  EXPECT_EQ(nodePaths(circle, 0, PathDirection::kAhead, 4.0, 9),
            (std::vector<NodePath>{{0, 1, 2, 0, 1}}));
}

}  // namespace
}  // namespace forge
