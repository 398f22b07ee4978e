#include "collision_forge/planner_test/trials/evasive_drives.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

EvasiveDrives drivesOf(const CrashScenario& scenario) {
  const Config& config = shippedConfig();
  return {scenario, config.planners.avoidability, config.planners.planning.route, config.attack};
}

const AgentState kStart{kNow, {0.0, 0.0, 0.0}, {10.0, 0.0}};

/// A car standing 40 m ahead.
CrashScenario carAhead() { return roadScenario(10.0, straightDrive({40.0, 0.0, 0.0}, 0.0, 7.0)); }

Future standing(const CrashScenario& scenario) {
  Future others;
  others.ego = attackerTrack(scenario);
  return others;
}

TEST(EvasiveDrives, GentlePlansComeFirst) {
  const CrashScenario scenario = carAhead();
  const EvasiveDrives drives = drivesOf(scenario);
  EXPECT_EQ(kindOf(drives.plans().front()), EvasiveManoeuvre::kKeeping);
  EXPECT_EQ(kindOf(drives.plans().back()), EvasiveManoeuvre::kBoth);
}

TEST(EvasiveDrives, BrakesAndSteersAsPlanned) {
  const CrashScenario scenario = carAhead();
  const EvasiveDrives drives = drivesOf(scenario);
  std::vector<TrajectoryPoint> points;
  drives.drive(kStart, {{-4.0, 0.0}, 2.0, {0.0, 0.0}}, points);
  EXPECT_NEAR(points.back().time, scenario.end(), 1e-9);
  EXPECT_NEAR(points.back().speed, 2.0, 0.5);
  drives.drive(kStart, {{0.0, 3.5}, 20.0, {0.0, 3.5}}, points);
  EXPECT_NEAR(points.back().pose.y, 3.5, 0.1);
  EXPECT_FALSE(drives.leavesRoad(points));
  drives.drive(kStart, {{0.0, -9.0}, 20.0, {0.0, -9.0}}, points);
  EXPECT_TRUE(drives.leavesRoad(points));
}

TEST(EvasiveDrives, AnEvasionHasNoContactAndKeepsEveryLimit) {
  const CrashScenario scenario = carAhead();
  const EvasiveDrives drives = drivesOf(scenario);
  const Future others = standing(scenario);
  std::vector<TrajectoryPoint> points;
  drives.drive(kStart, {{0.0, 0.0}, 20.0, {0.0, 0.0}}, points);
  EXPECT_FALSE(EvasiveDrives::isEvasion(drives.verify(points, others)));
  drives.drive(kStart, {{-4.0, 0.0}, 20.0, {0.0, 0.0}}, points);
  EXPECT_TRUE(EvasiveDrives::isEvasion(drives.verify(points, others)));
  for (TrajectoryPoint& point : points) point.speed *= 9.0;
  EXPECT_FALSE(EvasiveDrives::isEvasion(drives.verify(points, others)));
}

TEST(Obstacles, AreAtTheirTrackedPoses) {
  const CrashScenario scenario = carAhead();
  const EvasiveDrives drives = drivesOf(scenario);
  const double step = shippedConfig().planners.avoidability.step;
  const Obstacles obstacles(standing(scenario), kNow, scenario.end(), step);
  std::vector<TrajectoryPoint> points;
  drives.drive(kStart, {{0.0, 0.0}, 20.0, {0.0, 0.0}}, points);
  EXPECT_FALSE(obstacles.areClearOf(points, drives.wideBox()));
  points.resize(30);  // 3 s: 30 m, the bumpers are 5 m apart
  EXPECT_TRUE(obstacles.areClearOf(points, drives.wideBox()));
}

}  // namespace
}  // namespace forge
