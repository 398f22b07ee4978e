#include "collision_forge/planner_test/trials/avoidability.h"

#include <gtest/gtest.h>

#include "collision_forge/attack/verify/drive_check.h"
#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/attack/verify/limits.h"
#include "collision_forge/attack/verify/verification.h"
#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

Avoidability avoidabilityOf(const CrashScenario& scenario) {
  const Config& config = shippedConfig();
  return findAvoidability(scenario, config.planners.avoidability, config.planners.planning.route,
                          config.attack);
}

/// Returns the smallest gap between the boxes, tested every 1 ms: a second, slower method than the
/// verification.
double clearance(const CrashScenario& scenario, const Avoidance& avoidance) {
  Track ego{kEgoId, AgentClass::kCar, kEgoSize, {}};
  for (const TrajectoryPoint& point : avoidance.motion) {
    ego.states.push_back({point.time, point.pose, Vector2::Zero()});
  }
  double least = 1e9;
  for (const Track& other : agentsFromT0(scenario)) {
    for (double time = avoidance.start; time < scenario.end(); time += 1e-3) {
      const auto here = stateAt(ego, time);
      const auto there = stateAt(other, time);
      if (!here || !there) continue;
      least = std::min(least, distance(boxAt(ego, here->pose), boxAt(other, there->pose)));
    }
  }
  return least;
}

void expectSound(const CrashScenario& scenario, const Avoidance& avoidance) {
  EXPECT_GT(clearance(scenario, avoidance), 0.0);
  EXPECT_NEAR(avoidance.motion.front().time, avoidance.start, 1e-9);
  EXPECT_NEAR(avoidance.motion.back().time, scenario.end(), 1e-6);
  const auto broken = findBrokenLimit(avoidance.motion, avoidance.motion.front().pose.yaw,
                                      scenario.end(), shippedConfig().attack.verification.limits);
  EXPECT_FALSE(broken) << describe(*broken);
}

TEST(Avoidability, AnEgoThatIsNotHitKeepsDriving) {
  const CrashScenario scenario = roadScenario(8.0, straightDrive({40.0, 3.5, M_PI}, 5.0, 5.0));
  const Avoidability found = avoidabilityOf(scenario);
  ASSERT_TRUE(found.isAvoidable());
  EXPECT_EQ(found.last->manoeuvre, EvasiveManoeuvre::kKeeping);
  EXPECT_EQ(found.from_now.size(), 1u);
}

TEST(Avoidability, ACarThatStandsInTheWayIsAvoidedByBrakingWhileThereIsRoom) {
  // At 10 m/s the ego stops within 100 / (2 * 7.9) = 6.4 m.
  const CrashScenario scenario = roadScenario(10.0, straightDrive({40.0, 0.0, 0.0}, 0.0, 7.0));
  const Avoidability found = avoidabilityOf(scenario);
  const Avoidance* braking = found.find(EvasiveManoeuvre::kBraking);
  ASSERT_NE(braking, nullptr);
  for (const Avoidance& avoidance : found.from_now) expectSound(scenario, avoidance);
  expectSound(scenario, *found.last);
  // Contact comes at (40 - 4.342) / 10 = 3.57 s; from 2.5 s on 10.7 m are left, enough to brake in.
  EXPECT_GE(found.last->start, kNow + 2.5 - 1e-6);
}

TEST(Avoidability, AnEgoAboveTheSpeedLimitMayKeepItsSpeedAndBrake) {
  // At 30 m/s the ego stops within 900 / (2 * 7.9) = 57 m.
  ASSERT_GT(30.0, shippedConfig().attack.verification.limits.max_speed);
  const CrashScenario scenario = roadScenario(30.0, straightDrive({150.0, 0.0, 0.0}, 0.0, 7.0));
  const Avoidability found = avoidabilityOf(scenario);
  EXPECT_NE(found.find(EvasiveManoeuvre::kBraking), nullptr);
  for (const Avoidance& avoidance : found.from_now) {
    EXPECT_GT(clearance(scenario, avoidance), 0.0);
    for (const TrajectoryPoint& point : avoidance.motion) EXPECT_LE(point.speed, 30.0 + 1e-9);
  }
}

TEST(Avoidability, TheEgoKeepsTheStrictLimitsWithoutAJerkLimit) {
  const CrashScenario scenario = roadScenario(10.0, straightDrive({40.0, 0.0, 0.0}, 0.0, 7.0));
  const Avoidability found = avoidabilityOf(scenario);
  const Avoidance* braking = found.find(EvasiveManoeuvre::kBraking);
  ASSERT_NE(braking, nullptr);
  const DriveLimits limits =
      driveLimitsOf(AgentClass::kCar, kEgoSize, shippedConfig().attack.verification.drivable);
  EXPECT_TRUE(findBrokenDrive(braking->motion, driveStateOf(braking->motion.front(), limits),
                              scenario.end(), limits));
}

TEST(Avoidability, BrakingWorksAsLongAsTheStoppingDistanceIsLeft) {
  // A wall across the road, 28 m ahead of the front bumper, at 10 m/s: 6.3 m are needed to stop, so
  // that braking works from 2.0 s on (8 m left) and not from 2.5 s on (3 m left).
  AttackerTrajectory wall = straightDrive({29.0 + 0.5 * kEgoSize.length, 0.0, 0.0}, 0.0, 6.0);
  wall.size = {2.0, 60.0};
  const CrashScenario scenario = roadScenario(10.0, wall);
  const Avoidability found = avoidabilityOf(scenario);
  ASSERT_TRUE(found.isAvoidable());
  EXPECT_NEAR(found.last->start, kNow + 2.0, 1e-6);
  EXPECT_EQ(found.last->manoeuvre, EvasiveManoeuvre::kBraking);
  expectSound(scenario, *found.last);
}

TEST(Avoidability, ACrashIntoANearWallIsUnavoidable) {
  // 8 m/s with 2 m to a wall across the road: stopping takes 4 m, steering 5 m at the least.
  AttackerTrajectory wall =
      straightDrive({2.0 + 0.5 * (kEgoSize.length + 2.0), 0.0, 0.0}, 0.0, 4.0);
  wall.size = {2.0, 60.0};
  const CrashScenario scenario = roadScenario(8.0, wall);
  const Avoidability found = avoidabilityOf(scenario);
  EXPECT_FALSE(found.isAvoidable());
  EXPECT_TRUE(found.from_now.empty());
}

TEST(Avoidability, AFasterCarFromBehindIsEvadedByAcceleratingOrSteering) {
  const CrashScenario scenario = roadScenario(6.0, straightDrive({-20.0, 0.0, 0.0}, 10.0, 7.0));
  const Avoidability found = avoidabilityOf(scenario);
  ASSERT_TRUE(found.isAvoidable());
  EXPECT_EQ(found.find(EvasiveManoeuvre::kBraking), nullptr);
  EXPECT_NE(found.find(EvasiveManoeuvre::kAccelerating), nullptr);
  for (const Avoidance& avoidance : found.from_now) expectSound(scenario, avoidance);
}

TEST(Avoidability, WitnessesTouchNoOtherAgent) {
  // A braking ego is hit from behind, and the parallel lane is occupied.
  const CrashScenario scenario = roadScenario(10.0, straightDrive({25.0, 0.0, M_PI}, 5.0, 4.0),
                                              {straightCar("behind", {-7.0, 0.0, 0.0}, 10.0)});
  const Avoidability found = avoidabilityOf(scenario);
  EXPECT_EQ(found.find(EvasiveManoeuvre::kBraking), nullptr);
  for (const Avoidance& avoidance : found.from_now) expectSound(scenario, avoidance);
}

TEST(Avoidability, MotionsOnTheRoadArePreferred) {
  const CrashScenario scenario = roadScenario(8.0, straightDrive({40.0, 0.0, M_PI}, 5.0, 6.0));
  const Avoidability found = avoidabilityOf(scenario);
  const Avoidance* steering = found.find(EvasiveManoeuvre::kSteering);
  ASSERT_NE(steering, nullptr);
  EXPECT_NEAR(steering->off_road_share, 0.0, 1e-9);
  EXPECT_GT(steering->motion.back().pose.y, 1.5);  // to the left; to the right the road ends
}

TEST(Avoidability, ContactsBetweenThePointsOfAMotionAreFound) {
  // The crossing attacker drives 10 m between two points, 0.5 s apart.
  const Config& config = shippedConfig();
  AvoidabilityOptions coarse = config.planners.avoidability;
  coarse.step = 0.5;
  std::size_t avoidances = 0;
  for (const double x : {14.0, 16.0, 18.0, 20.0, 22.0}) {
    const CrashScenario scenario =
        roadScenario(8.0, straightDrive({x, -45.0, M_PI_2}, 20.0, 5.0, 0.5));
    const Avoidability found =
        findAvoidability(scenario, coarse, config.planners.planning.route, config.attack);
    for (const Avoidance& avoidance : found.from_now) {
      EXPECT_GT(clearance(scenario, avoidance), 0.0) << x;
    }
    avoidances += found.from_now.size();
  }
  EXPECT_GT(avoidances, 0u);
}

}  // namespace
}  // namespace forge
