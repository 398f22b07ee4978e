#include "collision_forge/attack/verify/step_out.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// A road from y = -3.5 to 3.5 along x with a walkway of 2 m south of it.
LaneIndex road() {
  auto map = emptyMap();
  map->drivable_area = {rectangle(-50.0, -3.5, 50.0, 3.5)};
  map->walkways = {rectangle(-50.0, -5.5, 50.0, -3.5)};
  return LaneIndex(map);
}

/// Northwards at 1 m/s from y = `from` for 12 s.
std::vector<TrajectoryPoint> walkNorth(double from) {
  std::vector<TrajectoryPoint> points;
  for (int i = 0; i <= 120; ++i) {
    points.push_back({kNow + 0.1 * i, {0.0, from + 0.1 * i, M_PI / 2}, 1.0, 0.0, 0.0});
  }
  return points;
}

TEST(StepOut, BeginsAtTheEdgeOfTheRoad) {
  const StepOut step_out = stepOutOf(walkNorth(-5.0), kNow + 5.0, road());
  EXPECT_NEAR(step_out.time, kNow + 1.5, 0.3);
  EXPECT_EQ(step_out.among_people, 1.0);
  EXPECT_EQ(implausibleWalk(step_out), "");
}

TEST(StepOut, IsAtOnceForAPedestrianInTheRoad) {
  const StepOut step_out = stepOutOf(walkNorth(-2.0), kNow + 3.0, road());
  EXPECT_EQ(step_out.time, kNow);
  EXPECT_EQ(step_out.among_people, 1.0);
}

TEST(StepOut, FarFromTheRoadNobodyWalks) {
  const StepOut step_out = stepOutOf(walkNorth(-12.0), kNow + 10.0, road());
  EXPECT_LT(step_out.among_people, 0.7);
  EXPECT_NE(implausibleWalk(step_out), "");
}

TEST(StepOut, BesideTheRoadPeopleWalkWithoutAWalkway) {
  const LaneIndex lanes = road();
  EXPECT_TRUE(isWherePeopleWalk({0.0, -4.5}, lanes)) << "walkway";
  EXPECT_TRUE(isWherePeopleWalk({0.0, 5.5}, lanes)) << "2 m beside the road";
  EXPECT_FALSE(isWherePeopleWalk({0.0, 8.0}, lanes));
  EXPECT_FALSE(isWherePeopleWalk({0.0, 0.0}, lanes));
}

TEST(StepOut, ACrosswalkIsWherePeopleWalk) {
  auto map = emptyMap();
  map->drivable_area = {rectangle(-50.0, -3.5, 50.0, 3.5)};
  map->features = {{FeatureKind::kCrosswalk, {{-2, -3.5}, {2, -3.5}, {2, 3.5}, {-2, 3.5}}}};
  const LaneIndex lanes(map);
  EXPECT_TRUE(isWherePeopleWalk({0.0, 0.0}, lanes));
  EXPECT_FALSE(isWherePeopleWalk({5.0, 0.0}, lanes));
}

}  // namespace
}  // namespace forge
