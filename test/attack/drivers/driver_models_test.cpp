#include "collision_forge/attack/drivers/driver_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace forge {
namespace {

constexpr double kKmh = 1.0 / 3.6;  // m/s

TEST(FuzzyMetrics, AgreeWithPublishedValues) {
  const double cases[][5] = {{20, 60, 40, 1, 0},
                             {30, 60, 40, .914, 0},
                             {40, 60, 40, .177, 0},
                             {20, 60, 20, 1, .732},
                             {60, 90, 60, .750, 0}};
  for (const auto& [gap, ego, leader, proactive, critical] : cases) {
    EXPECT_NEAR(proactiveFuzzy(gap, ego * kKmh, leader * kKmh, {}), proactive, 1e-3) << gap;
    EXPECT_NEAR(criticalFuzzy(gap, ego * kKmh, leader * kKmh, 0.0, {}), critical, 1e-3) << gap;
  }
}

/// Cut-in of JRC-FSM: 10 Hz, boxes of 4.3 x 1.9 m, 1.6 m beside the ego, which keeps its speed
/// until the driver reacts. The other agent moves to the side with 1.5 m/s2 up to a speed.
struct CutIn {
  static constexpr double kStep = 0.1;
  static constexpr double kLength = 4.3;
  static constexpr double kLateralGap = 1.6;
  static constexpr int kSteps = 350;
  double ego_speed, other_speed, lateral_speed;  // m/s
  double gap;                                    // m, when the lateral speed is reached

  /// Returns the other's lateral gaps (m) step by step, with an end of `kSteps`, and in
  /// `accelerating` the number of steps before `gap` counts.
  std::vector<double> lateralGaps(std::size_t& accelerating) const {
    std::vector<double> speeds;
    for (int i = 0; i * 0.15 < lateral_speed - 1e-9; ++i) speeds.push_back(i * 0.15);
    accelerating = speeds.size();
    double before = 0.0;
    for (const double speed : speeds) before += speed * kStep;
    const double whole = kLateralGap + 1.9;  // m between the middles
    const int moving = static_cast<int>(std::floor(10.0 * whole / lateral_speed)) + 1;
    std::vector<double> gaps;
    double lateral = kLateralGap + before;
    for (const double speed : speeds) {
      gaps.push_back(lateral);
      lateral -= speed * kStep;
    }
    gaps.push_back(kLateralGap);
    for (int i = 0; i < kSteps; ++i) {
      const double middle = whole - std::min(i + 1, moving) * lateral_speed * kStep;
      gaps.push_back(std::abs(middle) - 1.9);
    }
    return gaps;
  }

  /// Returns whether the ego touches the other. The loop ends without a crash if the boxes come
  /// before each other at a larger time to collision than the CC driver's critical one.
  bool crashes(DriverModel model) const {
    DriverOptions options;
    options.wandering_zone = 1e9;  // the reference driver has none
    CarefulDriver driver(model, options);
    std::size_t accelerating = 0;
    const std::vector<double> lateral = lateralGaps(accelerating);
    double speed = ego_speed;
    double ahead = gap + kLength + accelerating * kStep * (ego_speed - other_speed);
    for (std::size_t i = 0; i + 1 < lateral.size(); ++i) {
      if (i > 0) ahead += (other_speed - speed) * kStep;
      Approach approach;
      approach.gap = std::abs(ahead) - kLength;
      approach.lengths = 2.0 * kLength;
      approach.is_ahead = ahead >= 0.0;
      approach.lateral_gap = lateral[i];
      approach.lateral_speed =
          i < accelerating
              ? i * 0.15
              : (i > accelerating + 1 && lateral[i] == lateral[i - 1] ? 0.0 : lateral_speed);
      approach.speed = other_speed;
      if (approach.lateral_gap < 0.0 && approach.gap < 0.0) return true;
      if (model == DriverModel::kCcDriver && approach.is_ahead && approach.lateral_gap <= 0.0 &&
          std::abs(approach.gap / (speed - other_speed)) > options.critical_ttc) {
        return false;
      }
      speed =
          std::max(speed - driver.decelerate(approach, speed, kStep).value_or(0.0) * kStep, 0.0);
    }
    return false;
  }
};

struct Gaps {
  int first = 0;  // m; 0: none
  int last = 0;
};

Gaps gapsWithCrashes(DriverModel model, double ego, double other, double lateral) {
  Gaps found;
  for (int gap = 1; gap <= 120; ++gap) {
    if (!CutIn{ego * kKmh, other * kKmh, lateral, static_cast<double>(gap)}.crashes(model))
      continue;
    if (found.first == 0) found.first = gap;
    found.last = gap;
  }
  return found;
}

TEST(CarefulDriver, CrashesInTheSameCutInsAsTheReference) {
  struct Row {
    double ego, other, lateral;  // km/h, km/h, m/s
    Gaps cc, system, rss, fsm;
  };
  const Row rows[] = {
      {60, 40, 0.5, {10, 24}, {10, 16}, {3, 3}, {}},
      {60, 40, 1.0, {1, 15}, {1, 10}, {1, 5}, {1, 6}},
      {60, 40, 1.5, {1, 13}, {1, 8}, {1, 4}, {1, 4}},
      {60, 20, 0.5, {29, 53}, {27, 38}, {15, 16}, {}},
      {60, 20, 1.0, {11, 35}, {11, 26}, {8, 15}, {10, 18}},
      {60, 20, 1.5, {4, 30}, {4, 23}, {3, 13}, {4, 16}},
      {90, 40, 1.0, {16, 47}, {16, 36}, {12, 22}, {14, 26}},
      {130, 70, 0.5, {47, 86}, {46, 65}, {29, 34}, {}},
      {130, 70, 1.0, {20, 60}, {20, 47}, {17, 29}, {19, 35}},
  };
  for (const Row& row : rows) {
    const std::pair<DriverModel, Gaps> models[] = {{DriverModel::kCcDriver, row.cc},
                                                   {DriverModel::kR157System, row.system},
                                                   {DriverModel::kRss, row.rss},
                                                   {DriverModel::kFsm, row.fsm}};
    for (const auto& [model, expected] : models) {
      const Gaps found = gapsWithCrashes(model, row.ego, row.other, row.lateral);
      const std::string name = std::string(toString(model)) + " " + std::to_string(row.ego) + " " +
                               std::to_string(row.other) + " " + std::to_string(row.lateral);
      EXPECT_NEAR(found.first, expected.first, 1) << name;
      EXPECT_NEAR(found.last, expected.last, 1) << name;
    }
  }
}

/// esmini's alks_r157_quick_stop_test: 15 m/s from x = 20 m, steps of 50 ms, the vehicle ahead
/// brakes from 1.35 s on; its driver brakes with 3 m/s2, reached in 0.6 s, after 0.4 + 0.75 s.
TEST(CarefulDriver, BrakesForAHardBrakingVehicleAsInEsmini) {
  DriverOptions options;
  options.full_braking = 3.0;
  options.jerk = 3.0 / 0.6;
  options.release = 0.0;
  options.critical_headway = 1e9;  // esmini's test asks for a reaction in any case
  CarefulDriver driver(DriverModel::kCcDriver, options);
  constexpr double kStep = 0.05;
  double x = 20.0;
  double speed = 15.0;
  std::vector<double> places = {x};
  for (int i = 0; i < 100; ++i) {
    Approach leader;
    leader.gap = 30.0;
    leader.lateral_gap = -1.8;
    leader.speed = 20.0;
    leader.braking = i * kStep >= 1.35 - 1e-9 ? 8.0 : 0.0;
    speed -= driver.decelerate(leader, speed, kStep).value_or(0.0) * kStep;
    x += speed * kStep;
    places.push_back(x);
  }
  EXPECT_NEAR(places[39], 49.250, 0.001);  // esmini's position lags its clock by a step
  EXPECT_NEAR(places[68], 70.322, 0.001);
  EXPECT_NEAR(places[100], 87.362, 0.001);
}

TEST(CarefulDriver, OfR157SeesACutInWhenItLeavesTheWanderingZone) {
  CarefulDriver driver(DriverModel::kCcDriver);
  Approach approach;
  approach.gap = 15.0;
  approach.lateral_gap = 1.0;
  approach.speed = 5.0;
  const double step = 0.1;
  approach.deviation = 0.3;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(driver.decelerate(approach, 15.0, step));
  approach.deviation = 0.5;
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(driver.decelerate(approach, 15.0, step)) << "0.4 s";
  for (int i = 0; i < 8; ++i) EXPECT_EQ(driver.decelerate(approach, 15.0, step), 0.4) << "0.75 s";
  EXPECT_FALSE(driver.isBraking());
  EXPECT_NEAR(*driver.decelerate(approach, 15.0, step), 0.4 + 1.265, 1e-9);
  EXPECT_TRUE(driver.isBraking());
  EXPECT_TRUE(driver.decelerate({}, 14.0, step)) << "brakes to a stop";
}

TEST(CarefulDriver, AllModelsReactToAConflictWithAnotherDirection) {
  for (const DriverModel model : kDriverModels) {
    CarefulDriver driver(model);
    Approach approach;
    approach.is_same_direction = false;
    EXPECT_FALSE(driver.decelerate(approach, 10.0, 0.1));
    approach.is_conflict = true;
    for (int i = 0; i < 12; ++i) driver.decelerate(approach, 10.0, 0.1);
    EXPECT_GT(*driver.decelerate(approach, 10.0, 0.1), 0.4) << toString(model);
    EXPECT_EQ(driverModelFromString(toString(model)), model);
  }
}

}  // namespace
}  // namespace forge
