#include "collision_forge/attack/search/ground_use.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

double offRoad(const std::shared_ptr<LaneMap>& map, const Pose2& start, int stride = 1,
               double until = kNow + 2.0) {
  const LaneIndex lanes(map);
  return GroundUse(lanes, stride)
      .offRoadShare(straightDrive(start, 5.0, 2.0).points, until, kCarSize);
}

bool crosses(const std::shared_ptr<LaneMap>& map, const Pose2& start) {
  const LaneIndex lanes(map);
  return GroundUse(lanes, 1).crossesKerb(straightDrive(start, 5.0, 2.0).points, kCarSize);
}

TEST(GroundUse, CountsThePointsOffTheRoad) {
  const auto road = twoLaneRoad();  // drivable from y = -1.75 to 5.25
  EXPECT_EQ(offRoad(road, {0.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(offRoad(road, {0.0, 20.0, 0.0}), 1.0);
  EXPECT_NEAR(offRoad(road, {0.0, -1.5, 0.0}), 1.0 / 3.0, 1e-9) << "one row of three";
}

TEST(GroundUse, TestsEveryStridethPoint) {
  // Leaves the road at the end: only the first point is looked at.
  EXPECT_EQ(offRoad(twoLaneRoad(), {0.0, 0.0, -M_PI / 2.0}, 1000),
            offRoad(twoLaneRoad(), {0.0, 0.0, -M_PI / 2.0}, 21));
  EXPECT_GT(offRoad(twoLaneRoad(), {0.0, 0.0, -M_PI / 2.0}, 5),
            offRoad(twoLaneRoad(), {0.0, 0.0, -M_PI / 2.0}, 21));
}

TEST(GroundUse, DrivingOntoAWalkwayCrossesAKerb) {
  auto map = emptyMap();
  EXPECT_FALSE(crosses(map, {0.0, 0.0, 0.0})) << "no walkway is known";
  map->walkways = {rectangle(6.0, -3.0, 8.0, 3.0)};
  EXPECT_TRUE(crosses(map, {0.0, 0.0, 0.0}));
  EXPECT_FALSE(crosses(map, {0.0, 10.0, 0.0})) << "passes it";
  map->drivable_area = {rectangle(-50.0, -3.0, 50.0, 3.0)};
  EXPECT_FALSE(crosses(map, {0.0, 0.0, 0.0})) << "a road goes over it";
}

TEST(GroundUse, AVehicleOnAWalkwayMayLeaveIt) {
  auto map = emptyMap();
  map->walkways = {rectangle(-5.0, -3.0, 5.0, 3.0)};
  EXPECT_FALSE(crosses(map, {0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace forge
