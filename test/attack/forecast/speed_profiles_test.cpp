#include "collision_forge/attack/forecast/speed_profiles.h"

#include <gtest/gtest.h>

#include <utility>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

const SpeedProfileOptions kOptions = shippedSpeedProfileOptions();

SpeedProfiles profilesOf(std::vector<SpeedProfileRow> rows) {
  return {SpeedSituations(std::move(rows)), kOptions};
}

/// `frames` rows of a driver who gains `gain` m/s a row.
void addScene(std::vector<SpeedProfileRow>& rows, const std::string& name, int frames, double speed,
              double gain) {
  for (int i = 0; i < frames; ++i) rows.push_back({name, i, speed + i * gain, {}});
}

/// Drivers who keep what they do, at many speeds and accelerations.
SpeedProfiles steadyDrivers() {
  std::vector<SpeedProfileRow> rows;
  for (int i = 0; i < 30; ++i) {
    addScene(rows, "scene-" + std::to_string(i), 30, 5.0 + i % 6, 0.05 * (i % 5));
  }
  return profilesOf(rows);
}

DrivingSituation driving(double speed, double gain) {
  DrivingSituation situation;
  for (std::size_t i = 0; i < situation.past_speeds.size(); ++i) {
    situation.past_speeds[i] = speed - static_cast<double>(i) * gain;
  }
  return situation;
}

TEST(SpeedProfiles, WhatDriversKeptDoingIsExpected) {
  const SpeedForecast forecast = steadyDrivers().forecast(driving(8.0, 0.1), 10);
  ASSERT_EQ(forecast.speeds.cols(), 10);
  EXPECT_NEAR(forecast.weights.sum(), 1.0, 1e-12);
  EXPECT_GT(forecast.weights.minCoeff(), 0.0);
  const Eigen::RowVectorXd mean = forecast.weights.transpose() * forecast.speeds;
  for (int i = 0; i < 10; ++i) EXPECT_NEAR(mean[i], 8.0 + (i + 1) * 0.1, 0.15) << i;
}

TEST(SpeedProfiles, SpeedsNotRecordedAreExtrapolatedFromGains) {
  const SpeedForecast forecast = steadyDrivers().forecast(driving(14.0, 0.0), 6);
  const Eigen::RowVectorXd mean = forecast.weights.transpose() * forecast.speeds;
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(mean[i], 14.0, 1.0) << i;
}

TEST(SpeedProfiles, ALeftOutSceneHasNoSay) {
  std::vector<SpeedProfileRow> rows;
  addScene(rows, "stops", 60, 10.0, 0.0);
  for (std::size_t i = 1; i < rows.size(); ++i) rows[i].speed = 0.0;
  addScene(rows, "keeps", 60, 10.0, 0.0);
  addScene(rows, "also_keeps", 60, 10.0, 0.0);
  const SpeedProfiles profiles = profilesOf(rows);
  const DrivingSituation situation = driving(10.0, 0.0);
  const SpeedForecast with = profiles.forecast(situation, 5);
  const SpeedForecast without = profiles.withoutScene("stops")->forecast(situation, 5);
  EXPECT_LT(with.speeds.minCoeff(), 9.0);
  EXPECT_GT(without.speeds.minCoeff(), 9.99);
  EXPECT_EQ(profiles.withoutScene("elsewhere"), nullptr);
}

TEST(SpeedProfiles, OnlyProfilesThatLastAreUsed) {
  std::vector<SpeedProfileRow> rows;
  for (int i = 0; i < 20; ++i) addScene(rows, "short" + std::to_string(i), 5, 3.0, 0.0);
  for (int i = 0; i < 20; ++i) addScene(rows, "long" + std::to_string(i), 21, 9.0, 0.0);
  const SpeedProfiles profiles = profilesOf(rows);
  // 20 rows last 20 intervals, fewer than a quarter of the 520; those of 130 last 14.
  const SpeedForecast forecast = profiles.forecast(driving(9.0, 0.0), 20);
  EXPECT_EQ(forecast.speeds.cols(), 14);
  EXPECT_NEAR(forecast.speeds.minCoeff(), 9.0, 0.01);
}

}  // namespace
}  // namespace forge
