#include "collision_forge/attack/search/track_driver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/verify/drive_check.h"

namespace forge {
namespace {

constexpr double kStep = 0.1;
constexpr std::size_t kSteps = 60;

DriveLimits limitsOf(AgentClass agent_class, const BoxSize& size) {
  return driveLimitsOf(agent_class, size, shippedOptions().verification.drivable);
}

TrackDriver driverOf(const DriveLimits& limits) { return {limits, kLimitShare, kPreview, kStep}; }

DriveState stateAt(const Pose2& middle, double speed, const DriveLimits& limits) {
  DriveState state;
  state.axle = compose(middle, {-limits.axle_to_middle, 0.0, 0.0});
  state.speed = speed;
  return state;
}

/// A plan along y(x) at constant speed along x.
template <typename Curve>
std::vector<PlannedStep> along(double speed, const Curve& y) {
  std::vector<PlannedStep> plan;
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double x = speed * kStep * static_cast<double>(i);
    const double slope = (y(x + 0.01) - y(x - 0.01)) / 0.02;
    plan.push_back({Pose2{x, y(x), std::atan(slope)}, speed * std::hypot(1.0, slope)});
  }
  return plan;
}

TEST(TrackDriver, FollowsALaneChange) {
  const DriveLimits limits = limitsOf(AgentClass::kCar, kCarSize);
  const auto plan =
      along(10.0, [](double x) { return 1.75 * (1.0 + std::tanh((x - 25.0) / 8.0)); });
  const DriveState start = stateAt({}, 10.0, limits);
  std::vector<TrajectoryPoint> points;
  driverOf(limits).drive(start, kNow, plan, points);
  ASSERT_EQ(points.size(), plan.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].time, kNow + kStep * static_cast<double>(i), 1e-9);
    EXPECT_LT((points[i].pose.position() - plan[i].middle).norm(), 0.45) << i;
  }
  EXPECT_NEAR(points.back().pose.y, 3.5, 0.1);
  EXPECT_FALSE(findBrokenDrive(points, start, 1e9, limits));
}

TEST(TrackDriver, StopsWithoutAJoltAndStandsStill) {
  const DriveLimits limits = limitsOf(AgentClass::kCar, kCarSize);
  std::vector<PlannedStep> plan;
  double x = 0.0;
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double speed = std::max(0.0, 8.0 - 4.0 * kStep * static_cast<double>(i));
    plan.push_back({Pose2{x, 0.0, 0.0}, speed});
    x += speed * kStep;
  }
  const DriveState start = stateAt({}, 8.0, limits);
  std::vector<TrajectoryPoint> points;
  driverOf(limits).drive(start, kNow, plan, points);
  const auto broken = findBrokenDrive(points, start, 1e9, limits);
  EXPECT_FALSE(broken) << describe(*broken);
  EXPECT_LT(points.back().speed, 0.2);
  EXPECT_NEAR(points.back().pose.x, plan.back().middle.x(), 0.7);
}

TEST(TrackDriver, AcceleratesAsFastAsAllowedAtTheSpeedReached) {
  const std::pair<AgentClass, BoxSize> agents[] = {
      {AgentClass::kCar, {4.6, 1.9}},        {AgentClass::kMotorcycle, {2.1, 0.8}},
      {AgentClass::kBicycle, {1.8, 0.6}},    {AgentClass::kScooter, {1.28, 0.6}},
      {AgentClass::kPedestrian, {0.7, 0.7}}, {AgentClass::kChild, {0.5, 0.5}},
      {AgentClass::kRunner, {0.7, 0.7}}};
  for (const auto& [agent_class, size] : agents) {
    const TrackDriver driver = driverOf(limitsOf(agent_class, size));
    const DriveLimits& limits = driver.limits();
    // Starts at different speeds, because the steps pass the switching speed at different places.
    for (double start = 0.0; start < limits.switching_speed; start += 0.1) {
      const auto plan = along(100.0, [](double) { return 0.0; });
      std::vector<TrajectoryPoint> points;
      driver.drive(stateAt({}, start, limits), kNow, plan, points);
      double largest_share = 0.0;  // of the allowed acceleration, above the switching speed
      for (const TrajectoryPoint& point : points) {
        const double share = point.acceleration / limits.forwardAt(point.speed);
        EXPECT_LE(share, 1.0 + 1e-9) << toString(agent_class) << ", " << point.speed << " m/s";
        if (point.speed > limits.switching_speed) largest_share = std::max(largest_share, share);
      }
      EXPECT_NEAR(largest_share, 1.0, 1e-9) << toString(agent_class) << ", start " << start;
    }
  }
}

TEST(TrackDriver, KeepsTheLimitsOfEveryClassWhateverThePlan) {
  const std::pair<AgentClass, BoxSize> vehicles[] = {{AgentClass::kCar, {4.6, 1.9}},
                                                     {AgentClass::kTruck, {10.0, 2.6}},
                                                     {AgentClass::kBus, {12.0, 2.9}},
                                                     {AgentClass::kMotorcycle, {2.1, 0.8}}};
  for (const auto& [agent_class, size] : vehicles) {
    const DriveLimits limits = limitsOf(agent_class, size);
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      Random random(seed);
      const double speed = seed % 5 == 0 ? 0.0 : random.uniform(0.0, 14.0);
      const double swerve = random.uniform(0.5, 5.0);
      const double sway = random.uniform(0.5, 3.0);
      const double leap = random.uniform(0.0, 8.0);
      const double beat = random.uniform(0.5, 4.0);
      // Swerves and leaps beyond every limit.
      std::vector<PlannedStep> plan;
      for (std::size_t i = 0; i < kSteps; ++i) {
        const double time = kStep * static_cast<double>(i);
        const double wanted = speed + leap * std::sin(beat * time);
        plan.push_back({{speed * time, swerve * std::sin(sway * time), std::cos(sway * time)},
                        std::max(0.0, wanted)});
      }
      const DriveState start = stateAt({}, speed, limits);
      std::vector<TrajectoryPoint> points;
      driverOf(limits).drive(start, kNow, plan, points);
      const auto broken = findBrokenDrive(points, start, 1e9, limits);
      EXPECT_FALSE(broken) << toString(agent_class) << ", seed " << seed << ": "
                           << describe(*broken);
      for (const TrajectoryPoint& point : points) {
        const double lateral = point.speed * point.speed * std::abs(point.curvature);
        EXPECT_LE(lateral, limits.max_lateral_acceleration)
            << toString(agent_class) << ", seed " << seed << ", " << point.time - kNow << " s";
        EXPECT_LE(std::hypot(point.acceleration, lateral), limits.max_braking)
            << toString(agent_class) << ", seed " << seed << ", " << point.time - kNow << " s";
      }
    }
  }
}

}  // namespace
}  // namespace forge
