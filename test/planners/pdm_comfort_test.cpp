#include "collision_forge/planners/pdm_comfort.h"

#include <gtest/gtest.h>

#include <functional>

#include "planners/planner_scenes.h"

namespace forge {
namespace {

const PdmComfortOptions& comfortOptions() { return shippedConfig().planners.pdm.scoring.comfort; }

/// 4 s of motion, the state at each time as `state_at` says; poses do not matter.
bool comfortable(const std::function<BicycleState(double)>& state_at,
                 const PdmComfortOptions& options = comfortOptions()) {
  PdmMotion motion;
  for (int i = 0; i <= 40; ++i) motion.states.push_back(state_at(0.1 * i));
  const KinematicBicycle bicycle(shippedConfig().planners.car);
  return isComfortable(motion, bicycle, 0.1, options);
}

double steeringFor(double curvature) {
  return std::atan(curvature * shippedConfig().planners.car.wheelbase);
}

TEST(Slopes, AreThoseOfALine) {
  const std::vector<double> found = slopes({1.0, 1.5, 2.0, 2.5, 3.0, 3.5}, 3, 0.1);
  for (const double slope : found) EXPECT_NEAR(slope, 5.0, 1e-9);
}

TEST(Slopes, AreFittedOverTheWindow) {
  // A lone 1 among zeros: at distance k, k / (2 (1 + 4 + 4 ...)).
  const std::vector<double> found = slopes({0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 5, 1.0);
  EXPECT_NEAR(found[3], 0.0, 1e-12);
  EXPECT_NEAR(found[2], 0.1, 1e-12);
  EXPECT_NEAR(found[4], -0.1, 1e-12);
}

TEST(PdmComfort, SteadyDrivingIsComfortable) {
  EXPECT_TRUE(comfortable([](double) { return BicycleState{{}, 10.0, 0.0, 0.0}; }));
}

TEST(PdmComfort, AccelerationAndBrakingHaveTheirLimits) {
  const auto with = [](double acceleration) {
    return comfortable([=](double) { return BicycleState{{}, 10.0, acceleration, 0.0}; });
  };
  EXPECT_TRUE(with(2.39));
  EXPECT_FALSE(with(2.41));
  EXPECT_TRUE(with(-4.04));
  EXPECT_FALSE(with(-4.06));
}

TEST(PdmComfort, LateralAccelerationHasItsLimit) {
  const auto with = [](double lateral) {
    return comfortable([=](double) {
      return BicycleState{{}, 8.0, 0.0, steeringFor(lateral / 64.0)};
    });
  };
  EXPECT_TRUE(with(4.88));
  EXPECT_FALSE(with(4.90));
  EXPECT_FALSE(with(-4.90));
}

TEST(PdmComfort, YawRateHasItsLimit) {
  const auto with = [](double yaw_rate) {
    return comfortable([=](double) {
      return BicycleState{{}, 2.0, 0.0, steeringFor(yaw_rate / 2.0)};
    });
  };
  EXPECT_TRUE(with(0.94));
  EXPECT_FALSE(with(-0.96));
}

TEST(PdmComfort, LongitudinalJerkHasItsLimit) {
  const auto with = [](double jerk) {
    return comfortable([=](double time) {
      return BicycleState{{}, 10.0, time < 1.0 ? jerk * (time - 0.5) : 0.5 * jerk, 0.0};
    });
  };
  EXPECT_TRUE(with(3.0));
  // 0.5 s of it before and after are within the acceleration's limits.
  PdmComfortOptions lax = comfortOptions();
  lax.max_longitudinal_jerk = 1.0;
  EXPECT_FALSE(comfortable(
      [](double time) {
        return BicycleState{{}, 10.0, time < 1.0 ? 3.0 * (time - 0.5) : 1.5, 0.0};
      },
      lax));
}

TEST(PdmComfort, JerkIsThatOfBothDirections) {
  // Lateral acceleration that rises by 2 m/s3, to 4 m/s2 in 2 s.
  const auto motion = [](double time) {
    return BicycleState{{}, 20.0, 0.0, steeringFor(2.0 * std::min(time, 2.0) / 400.0)};
  };
  PdmComfortOptions strict = comfortOptions();
  strict.max_jerk = 1.9;
  EXPECT_TRUE(comfortable(motion));
  EXPECT_FALSE(comfortable(motion, strict));
}

TEST(PdmComfort, YawAccelerationHasItsLimit) {
  // Yaw rate that rises by 0.4 rad/s2 to 0.8 rad/s.
  const auto motion = [](double time) {
    return BicycleState{{}, 3.0, 0.0, steeringFor(0.4 * std::min(time, 2.0) / 3.0)};
  };
  PdmComfortOptions strict = comfortOptions();
  strict.max_yaw_acceleration = 0.35;
  EXPECT_TRUE(comfortable(motion));
  EXPECT_FALSE(comfortable(motion, strict));
}

}  // namespace
}  // namespace forge
