#include "collision_forge/planner_test/planners/pdm_comfort.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const PdmComfortOptions& comfortOptions() { return shippedConfig().planners.pdm.scoring.comfort; }

std::array<bool, 6> keptBy(
    const std::function<double(double)>& longitudinal, const std::function<double(double)>& yaw,
    const std::function<double(double)>& lateral = [](double) { return 0.0; }) {
  EgoSignals signals;
  for (int i = 0; i <= 40; ++i) {
    signals.longitudinal.push_back(longitudinal(0.1 * i));
    signals.yaw.push_back(yaw(0.1 * i));
    signals.lateral.push_back(lateral(0.1 * i));
  }
  const PdmComfort comfort(41, 0.1, comfortOptions());
  return comfort.keptLimits(comfort.ranges(signals));
}

double none(double) { return 0.0; }

constexpr std::size_t kLongitudinal = 0, kLateral = 1, kLongitudinalJerk = 3, kYawAcceleration = 4,
                      kYawRate = 5;

TEST(SavitzkyGolay, AnOddWindowLeavesAParabolaAsItIs) {
  const Eigen::MatrixXd filter = savitzkyGolay(12, 5, 2, 0, 0.1);
  Eigen::VectorXd values(12);
  for (int i = 0; i < 12; ++i) values(i) = 3.0 - 2.0 * i + 0.5 * i * i;
  EXPECT_NEAR((filter * values - values).norm(), 0.0, 1e-9);
}

TEST(SavitzkyGolay, TellsDerivativesOfPolynomials) {
  Eigen::VectorXd values(12);
  for (int i = 0; i < 12; ++i) values(i) = std::pow(0.1 * i, 3);
  const Eigen::VectorXd second = savitzkyGolay(12, 5, 3, 2, 0.1) * values;
  for (int i = 0; i < 12; ++i) EXPECT_NEAR(second(i), 6.0 * 0.1 * i, 1e-9);
}

TEST(SavitzkyGolay, AnEvenWindowIsAskedHalfAStepLater) {
  Eigen::VectorXd values(20);
  for (int i = 0; i < 20; ++i) values(i) = i;
  const Eigen::VectorXd smoothed = savitzkyGolay(20, 8, 2, 0, 0.1) * values;
  EXPECT_NEAR(smoothed(2), 2.0, 1e-9);
  EXPECT_NEAR(smoothed(10), 10.5, 1e-9);
  EXPECT_NEAR(smoothed(18), 18.0, 1e-9);
}

TEST(PdmComfort, AccelerationAndBrakingHaveTheirLimits) {
  const auto with = [](double acceleration) {
    return keptBy([=](double) { return acceleration; }, none)[kLongitudinal];
  };
  EXPECT_TRUE(with(2.39));
  EXPECT_FALSE(with(2.41));
  EXPECT_TRUE(with(-4.04));
  EXPECT_FALSE(with(-4.06));
}

TEST(PdmComfort, LateralAccelerationHasItsLimit) {
  const auto with = [](double lateral) {
    return keptBy(none, none, [=](double) { return lateral; })[kLateral];
  };
  EXPECT_TRUE(with(4.88));
  EXPECT_FALSE(with(-4.90));
}

TEST(PdmComfort, JerkIsThatOfTheWholeMotion) {
  const auto rising = [](double jerk) { return [=](double time) { return jerk * time; }; };
  // The shift of the even window steepens the line a little.
  EXPECT_TRUE(keptBy(rising(3.9), none)[kLongitudinalJerk]);
  EXPECT_FALSE(keptBy(rising(4.3), none)[kLongitudinalJerk]);
  // A short jolt is smoothed away.
  EXPECT_TRUE(keptBy([](double time) { return std::abs(time - 2.0) < 0.15 ? 2.0 : 0.0; },
                     none)[kLongitudinalJerk]);
}

TEST(PdmComfort, YawHasItsLimits) {
  const auto turning = [](double rate) {
    return [=](double time) { return wrapAngle(3.0 + rate * time); };
  };
  EXPECT_TRUE(keptBy(none, turning(0.94))[kYawRate]);
  EXPECT_FALSE(keptBy(none, turning(-0.96))[kYawRate]);
  const auto winding = [](double acceleration) {
    return [=](double time) { return 0.5 * acceleration * (time - 2.0) * (time - 2.0); };
  };
  EXPECT_TRUE(keptBy(none, winding(1.92))[kYawAcceleration]);
  EXPECT_FALSE(keptBy(none, winding(1.94))[kYawAcceleration]);
}

TEST(PdmComfort, ASimulatedMotionHasNoLateralAcceleration) {
  const std::vector<BicycleState> states(41, {{1.0, 2.0, 0.5}, 10.0, 1.0, 0.3});
  const EgoSignals signals = signalsOf(states);
  EXPECT_EQ(signals.lateral, std::vector<double>(41, 0.0));
  EXPECT_EQ(signals.longitudinal, std::vector<double>(41, 1.0));
  EXPECT_TRUE(PdmComfort(41, 0.1, comfortOptions()).isComfortable(states));
}

}  // namespace
}  // namespace forge
