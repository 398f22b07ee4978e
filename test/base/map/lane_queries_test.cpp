#include "collision_forge/base/map/lane_queries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/map/winding_lanes.h"

namespace forge {
namespace {

LaneIndex makeIndex(const LaneMap& map) { return LaneIndex(std::make_shared<LaneMap>(map)); }

// A lane along +x that forks at (20, 0) to the left, straight on and to the right.
LaneMap fork() {
  LaneMap map;
  map.lanes = {makeLane("in", {{0, 0}, {10, 0}, {20, 0}}, {"left", "straight", "right", "bare"}),
               makeLane("left", arc({20, 0, 0}, 15, M_PI_2)),
               makeLane("straight", {{20, 0}, {30, 0.1}, {40, 0}}, {"after"}),
               makeLane("right", arc({20, 0, 0}, 15, -M_PI_2)),
               makeLane("bare", {}),
               makeLane("after", {{40, 0}, {60, 0}}),
               makeLane("oncoming", {{20, 3}, {0, 3}})};
  return map;
}

std::vector<std::string> idsOf(const LaneIndex& index, const std::vector<LaneMatch>& matches) {
  std::vector<std::string> ids;
  for (const LaneMatch& match : matches) {
    ids.push_back(index.map().lanes[match.lane].id);
  }
  return ids;
}

TEST(LaneIndex, RefusesBadMaps) {
  EXPECT_THROW(LaneIndex(nullptr), std::invalid_argument);
  LaneMap map = fork();
  map.lanes[0].centerline[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(makeIndex(map), std::invalid_argument);
}

TEST(LaneIndex, ResolvesSuccessorsAndIgnoresUnknownIds) {
  LaneMap map = fork();
  map.lanes[5].outgoing = {"nowhere", "in"};
  const LaneIndex index = makeIndex(map);
  EXPECT_EQ(index.successors(0), (std::vector<std::size_t>{1, 2, 3, 4}));
  EXPECT_EQ(index.successors(5), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(index.centerline(0).has_value());
  EXPECT_FALSE(index.centerline(4).has_value());
}

TEST(LaneIndex, ReversedIsDrivenTheOtherWay) {
  LaneMap map = fork();
  for (Lane& lane : map.lanes) {
    for (const std::string& id : lane.outgoing) {
      for (Lane& next : map.lanes) {
        if (next.id == id) next.incoming.push_back(lane.id);
      }
    }
  }
  const LaneIndex index = makeIndex(map);
  const LaneIndex& reversed = index.reversed();
  EXPECT_EQ(&reversed, &index.reversed()) << "made once";
  EXPECT_NE(reversed.map().driving_side, map.driving_side);
  EXPECT_TRUE(reversed.successors(0).empty());
  EXPECT_EQ(reversed.successors(1), (std::vector<std::size_t>{0}));
  const Pose2 end = reversed.pathAhead(5, 0.0, 60.0).poseAt(60.0);
  EXPECT_NEAR(end.x, 0.0, 0.1) << "from the end of the last lane to the beginning of the first";
  EXPECT_NEAR(std::abs(end.yaw), M_PI, 1e-6);
  const Pose2 against{10.0, 0.0, M_PI};
  EXPECT_FALSE(index.grid().isOnLane(against, 2.0, 0.5));
  EXPECT_TRUE(reversed.grid().isOnLane(against, 2.0, 0.5));
}

TEST(LanesNear, KeepsToDistanceAndHeading) {
  const LaneIndex index = makeIndex(fork());
  const auto matches = index.lanesNear({10.0, 1.0, 0.2}, 4.0, 0.5);
  ASSERT_EQ(idsOf(index, matches), (std::vector<std::string>{"in"}));
  EXPECT_NEAR(matches[0].projection.arc_length, 10.0, 1e-9);
  EXPECT_NEAR(matches[0].projection.lateral, 1.0, 1e-9);
  EXPECT_NEAR(matches[0].heading_error, 0.2, 1e-9);
  EXPECT_TRUE(index.lanesNear({10.0, 1.0, 0.2}, 0.99, 0.5).empty());
  EXPECT_TRUE(index.lanesNear({10.0, 1.0, 0.2}, 4.0, 0.19).empty());
  // Both directions if any heading is allowed, nearest first.
  EXPECT_EQ(idsOf(index, index.lanesNear({10.0, 1.0, 0.2}, 4.0, M_PI)),
            (std::vector<std::string>{"in", "oncoming"}));
  EXPECT_EQ(idsOf(index, index.lanesNear({10.0, 1.0, M_PI - 0.1}, 4.0, 0.5)),
            (std::vector<std::string>{"oncoming"}));
}

TEST(LanesNear, AgreesWithTryingEveryLane) {
  LaneRandom random(1);
  const LaneMap map = randomMap(random, 300);
  const LaneIndex index = makeIndex(map);
  std::size_t found = 0;
  for (int i = 0; i < 1500; ++i) {
    const Pose2 pose{random.between(-120, 120), random.between(-120, 120),
                     random.between(-M_PI, M_PI)};
    const double max_distance = random.between(0.0, 15.0);
    std::vector<std::size_t> expected;
    for (std::size_t k = 0; k < map.lanes.size(); ++k) {
      if (k < 1 || k > 3) {
        std::vector<Vector2> points;
        for (const Pose2& p : map.lanes[k].centerline) {
          points.push_back(p.position());
        }
        const auto projection = Polyline(points).project(pose.position());
        if (projection.distance <= max_distance &&
            std::cos(projection.pose.yaw - pose.yaw) >= std::cos(0.7)) {
          expected.push_back(k);
        }
      }
    }
    const auto matches = index.lanesNear(pose, max_distance, 0.7);
    std::vector<std::size_t> lanes;
    for (std::size_t k = 0; k < matches.size(); ++k) {
      lanes.push_back(matches[k].lane);
      EXPECT_TRUE(k == 0 ||
                  matches[k - 1].projection.distance <= matches[k].projection.distance + 1e-3);
    }
    std::sort(lanes.begin(), lanes.end());
    EXPECT_EQ(lanes, expected);
    found += expected.size();
  }
  EXPECT_GT(found, 500u);
}

TEST(LanesWithin, AgreesWithDenseSampling) {
  LaneRandom random(2);
  const LaneMap map = randomMap(random, 200);
  const LaneIndex index = makeIndex(map);
  for (int i = 0; i < 50; ++i) {
    const Vector2 center(random.between(-120, 120), random.between(-120, 120));
    const double radius = random.between(5.0, 80.0);
    std::vector<double> distances(map.lanes.size(), std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < map.lanes.size(); ++k) {
      const auto& line = index.centerline(k);
      for (double s = 0.0; line && s <= line->length(); s += 0.05) {
        distances[k] = std::min(distances[k], (line->poseAt(s).position() - center).norm());
      }
    }
    const auto lanes = index.lanesWithin(center, radius);
    for (std::size_t k = 0; k < map.lanes.size(); ++k) {
      const bool found = std::count(lanes.begin(), lanes.end(), k) == 1;
      if (distances[k] <= radius) {
        EXPECT_TRUE(found);
      } else if (distances[k] > radius + 0.05) {
        EXPECT_FALSE(found);
      }
    }
    for (std::size_t k = 1; k < lanes.size(); ++k) {
      EXPECT_LE(distances[lanes[k - 1]], distances[lanes[k]] + 0.05);
    }
  }
}

TEST(PathAhead, FollowsTheStraightestSuccessor) {
  const LaneIndex index = makeIndex(fork());
  EXPECT_EQ(index.straightestSuccessor(0), 2u);
  EXPECT_EQ(index.straightestSuccessor(2), 5u);
  EXPECT_FALSE(index.straightestSuccessor(5));
  const Polyline path = index.pathAhead(0, 5.0, 30.0);
  EXPECT_NEAR(path.length(), 30.0, 0.01);
  EXPECT_NEAR((path.poseAt(0.0).position() - Vector2(5, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((path.poseAt(25.0).position() - Vector2(30, 0.1)).norm(), 0.0, 0.01);
}

TEST(PathAhead, ALaneThatSwervesTurnsMoreThanOneThatDoesNot) {
  // Both successors end with the heading they started with.
  LaneMap map;
  map.lanes = {makeLane("in", {{0, 0}, {20, 0}}, {"shift", "on"}),
               makeLane("shift", {{20, 0}, {30, 0}, {40, 3}, {50, 3}}),
               makeLane("on", {{20, 0}, {50, 0}})};
  EXPECT_EQ(makeIndex(map).straightestSuccessor(0), 2u);
  map.lanes[2].centerline = map.lanes[1].centerline;
  EXPECT_EQ(makeIndex(map).straightestSuccessor(0), 1u) << "the first of equals";
}

TEST(PathAhead, EndsWithTheLanesAndContinuesStraight) {
  const LaneIndex index = makeIndex(fork());
  const Polyline path = index.pathAhead(2, 0.0, 500.0);
  EXPECT_NEAR(path.length(), 40.0, 0.01);
  EXPECT_NEAR((path.poseAt(100.0).position() - Vector2(120, 0)).norm(), 0.0, 0.01);
  const Polyline left = index.pathAhead(1, 0.0, 500.0);
  EXPECT_NEAR(left.poseAt(100.0).yaw, 0.95 * M_PI_2, 1e-9);
}

TEST(PathAhead, JointsThatDoNotMeetExactlyBendNothing) {
  for (const Vector2& gap : {Vector2(0.0, 0.02), Vector2(-0.1, 0.05), Vector2(1e-5, -1e-5)}) {
    LaneMap map;
    const Vector2 joint = Vector2(20, 0) + gap;
    map.lanes = {makeLane("in", {{0, 0}, {10, 0}, {20, 0}}, {"on"}),
                 makeLane("on", {joint, joint + Vector2(1, 0), joint + Vector2(20, 0)})};
    const LaneIndex index = makeIndex(map);
    for (const double distance : {20.0, 20.001, 20.15, 20.5, 30.0}) {
      const Polyline path = index.pathAhead(0, 0.0, distance);
      EXPECT_NEAR(path.length(), distance, 0.21);
      for (double s = 0.0; s < 50.0; s += 0.01) {
        ASSERT_LT(std::abs(path.poseAt(s).yaw), 0.25) << "at " << s << " of " << distance;
      }
    }
  }
}

TEST(PathAhead, FollowsALoopAndEndsOnATinyOne) {
  LaneMap map;
  map.lanes = {makeLane("a", arc({10, 0, M_PI_2}, 10 * M_PI, M_PI), {"b"}),
               makeLane("b", arc({-10, 0, -M_PI_2}, 10 * M_PI, M_PI), {"a"}),
               makeLane("tiny", {{0, 0}, {0.01, 0}}, {"tiny"})};
  const LaneIndex index = makeIndex(map);
  EXPECT_NEAR(index.pathAhead(0, 0.0, 200.0).length(), 200.0, 1.0);
  EXPECT_GE(index.pathAhead(2, 0.0, 1e9).length(), 1.0);
  EXPECT_GE(index.pathAhead(2, 0.0, std::numeric_limits<double>::infinity()).length(), 1.0);
}

/// in -> (left, on -> (far_left, far_on)).
LaneMap twoForks() {
  LaneMap map;
  map.lanes = {makeLane("in", {{0, 0}, {20, 0}}, {"left", "on"}),
               makeLane("left", {{20, 0}, {30, 5}, {30, 40}}),
               makeLane("on", {{20, 0}, {40, 0}}, {"far_left", "far_on"}),
               makeLane("far_left", {{40, 0}, {50, 5}, {50, 40}}),
               makeLane("far_on", {{40, 0}, {90, 0}})};
  return map;
}

std::vector<std::vector<std::size_t>> lanesOf(const std::vector<LanePath>& paths) {
  std::vector<std::vector<std::size_t>> lanes;
  for (const LanePath& path : paths) lanes.push_back(path.lanes);
  return lanes;
}

TEST(PathsAhead, TakesEveryBranchNearestFirst) {
  const LaneIndex index = makeIndex(twoForks());
  const auto paths = index.pathsAhead(0, 5.0, 60.0, 10);
  EXPECT_EQ(lanesOf(paths), (std::vector<std::vector<std::size_t>>{{0, 2, 4}, {0, 1}, {0, 2, 3}}));
  EXPECT_NEAR(paths[0].length, 60.0, 1e-9);
  EXPECT_NEAR((paths[0].end.position() - Vector2(65, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((paths[0].points.front() - Vector2(5, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((paths[2].points.back() - paths[2].end.position()).norm(), 0.0, 1e-9);
  EXPECT_LT(paths[1].length, 61.0);
}

TEST(PathsAhead, BranchesBeyondTheDistanceAreNotTaken) {
  EXPECT_EQ(makeIndex(twoForks()).pathsAhead(0, 5.0, 30.0, 10).size(), 2u);
  EXPECT_EQ(makeIndex(twoForks()).pathsAhead(0, 5.0, 10.0, 10).size(), 1u);
}

TEST(PathsAhead, AreAtMostMaxPathsOverBranches) {
  const LaneIndex index = makeIndex(twoForks());
  EXPECT_EQ(lanesOf(index.pathsAhead(0, 5.0, 60.0, 2)),
            (std::vector<std::vector<std::size_t>>{{0, 2, 4}, {0, 1}}));
  EXPECT_EQ(lanesOf(index.pathsAhead(0, 5.0, 60.0, 1)),
            (std::vector<std::vector<std::size_t>>{{0, 2, 4}}));
}

LaneMap squareWithHole() {
  LaneMap map;
  map.drivable_area = {
      {{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{{40, 40}, {60, 40}, {60, 60}, {40, 60}}}}};
  return map;
}

TEST(OffRoadShare, KnownCases) {
  const LaneIndex index = makeIndex(squareWithHole());
  EXPECT_EQ(index.offRoadShare({{20, 20, 0.3}, {4, 2}}), 0.0);
  EXPECT_EQ(index.offRoadShare({{50, 50, 0.3}, {4, 2}}), 1.0);
  EXPECT_EQ(index.offRoadShare({{-50, 50, 0.3}, {4, 2}}), 1.0);
  EXPECT_EQ(index.offRoadShare({{0, 50, 0.0}, {4, 2}}), 0.5);
  EXPECT_EQ(index.offRoadShare({{50, 39, M_PI_2}, {4, 2}}), 0.25);
  EXPECT_EQ(index.offRoadShare({{20, 20, 0.0}, {0, 0}}), 0.0);
  EXPECT_EQ(index.offRoadShare({{50, 50, 0.0}, {0, 0}}), 1.0);
  EXPECT_EQ(index.offRoadShare({{50, 39, M_PI_2}, {4, 0}}), 0.25);
}

TEST(OffRoadShare, AgreesWithRandomPoints) {
  LaneRandom random(3);
  LaneMap map;
  for (int i = 0; i < 40; ++i) {
    const Vector2 center(random.between(-30, 30), random.between(-30, 30));
    Polygon polygon;
    std::vector<Vector2> hole;
    for (int k = 0; k < 12; ++k) {
      const Vector2 way(std::cos(k * M_PI / 6), std::sin(k * M_PI / 6));
      polygon.exterior.push_back(center + random.between(2.0, 8.0) * way);
      hole.push_back(center + random.between(0.2, 1.5) * way);
    }
    polygon.holes.push_back(hole);
    map.drivable_area.push_back(polygon);
  }
  const LaneIndex index = makeIndex(map);
  constexpr int kPoints = 5000;
  for (int i = 0; i < 200; ++i) {
    const OrientedBox box{{random.between(-35, 35), random.between(-35, 35), random.between(-4, 4)},
                          {random.between(1.0, 12.0), random.between(0.5, 3.0)}};
    int off = 0;
    for (int k = 0; k < kPoints; ++k) {
      const Pose2 local{random.between(-0.5, 0.5) * box.size.length,
                        random.between(-0.5, 0.5) * box.size.width, 0.0};
      const Vector2 point = compose(box.center, local).position();
      off += std::none_of(map.drivable_area.begin(), map.drivable_area.end(),
                          [&](const Polygon& polygon) { return contains(polygon, point); });
    }
    EXPECT_NEAR(*index.offRoadShare(box), static_cast<double>(off) / kPoints, 0.06);
  }
}

}  // namespace
}  // namespace forge
