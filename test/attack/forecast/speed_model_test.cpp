#include "collision_forge/attack/forecast/speed_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "collision_forge/attack/forecast/speed_situations.h"
#include "collision_forge/attack/search/options.h"

namespace forge {
namespace {

constexpr int kIntervals = 4;

/// One center, at 2 m/s; drivers gain their acceleration (feature 1) each interval, 1 m/s more
/// or less. A standing driver stays, or sets off if the turn rate (feature 4) is positive.
SpeedModelWeights plainWeights() {
  SpeedModelWeights weights;
  weights.feature_weights = Eigen::RowVectorXd::Ones(kSpeedFeatures);
  weights.lowest = Eigen::RowVectorXd::Constant(kSpeedFeatures, -20.0);
  weights.highest = Eigen::RowVectorXd::Constant(kSpeedFeatures, 20.0);
  weights.centers = Eigen::MatrixXd::Zero(1, kSpeedFeatures);
  weights.centers(0, 0) = 2.0;
  weights.gains = Eigen::MatrixXd::Zero(2 + kSpeedFeatures, kIntervals);
  weights.gains.row(2) << 0.5, 1.0, 1.5, 2.0;
  weights.log_spreads = Eigen::MatrixXd::Zero(2 + kSpeedFeatures, kIntervals);
  weights.residuals.profiles.resize(2, kIntervals);
  weights.residuals.profiles << 1, 1, 1, 1, -1, -1, -1, -1;
  weights.residuals.weights = Eigen::Vector2d(0.25, 0.75);
  weights.standing_speed = 0.1;
  weights.standing.resize(2, kIntervals);
  weights.standing << 0, 0, 0, 0, 1, 2, 3, 4;
  weights.standing_shares = Eigen::MatrixXd::Zero(1 + kSpeedFeatures, 2);
  weights.standing_shares.row(0) << 1.0, 0.0;
  weights.standing_shares.row(5) << -1.0, 1.0;
  return weights;
}

DrivingSituation driving(double speed, double acceleration) {
  DrivingSituation situation;
  for (std::size_t i = 0; i < situation.past_speeds.size(); ++i) {
    situation.past_speeds[i] = speed - static_cast<double>(i) * acceleration * kProfileStep;
  }
  return situation;
}

TEST(SpeedModel, ExpectedGainsAndDifferencesAreAdded) {
  const SpeedForecast forecast = SpeedModel(plainWeights()).forecast(driving(8.0, 1.0), 4);
  Eigen::MatrixXd expected(2, 4);
  expected << 9.5, 10, 10.5, 11, 7.5, 8, 8.5, 9;
  EXPECT_TRUE(forecast.speeds.isApprox(expected, 1e-12)) << forecast.speeds;
  EXPECT_EQ(forecast.weights, Eigen::Vector2d(0.25, 0.75));
}

TEST(SpeedModel, SpreadsAreLogarithms) {
  SpeedModelWeights weights = plainWeights();
  weights.log_spreads.row(0).setConstant(std::log(3.0));
  const SpeedForecast forecast = SpeedModel(weights).forecast(driving(8.0, 0.0), 2);
  EXPECT_NEAR(forecast.speeds(0, 1), 11.0, 1e-12);
  EXPECT_NEAR(forecast.speeds(1, 1), 5.0, 1e-12);
}

TEST(SpeedModel, NearerCentersHaveMoreWeight) {
  SpeedModelWeights weights = plainWeights();
  weights.gains.bottomRows(1).setConstant(10.0);
  const auto gain = [&](double speed) {
    return SpeedModel(weights).forecast(driving(speed, 0.0), 1).speeds(1, 0) - speed + 1.0;
  };
  EXPECT_NEAR(gain(2.0), 10.0, 1e-12);
  EXPECT_NEAR(gain(2.0 + std::sqrt(3.0)), 5.0, 1e-12);
  EXPECT_NEAR(gain(10.0), 10.0 / std::sqrt(65.0), 1e-12);
}

TEST(SpeedModel, SituationsOutsideTheTrainingRangeAreClamped) {
  const SpeedModel model(plainWeights());
  EXPECT_NEAR(model.forecast(driving(50.0, 30.0), 1).speeds(0, 0), 50.0 + 10.0 + 1.0, 1e-12);
}

TEST(SpeedModel, AStandingEgoHasItsOwnProfiles) {
  const SpeedModel model(plainWeights());
  DrivingSituation situation = driving(0.0, 0.0);
  const SpeedForecast stays = model.forecast(situation, 4);
  EXPECT_EQ(stays.speeds.row(1), Eigen::RowVector4d(1, 2, 3, 4));
  EXPECT_NEAR(stays.weights[0], 1.0, 1e-5);
  situation.ahead.turn_rate = 0.25;
  const SpeedForecast sets_off = model.forecast(situation, 4);
  EXPECT_NEAR(sets_off.weights[1], 0.25, 1e-5);
  situation.ahead.turn_rate = 3.0;  // shares -2 and 3
  EXPECT_NEAR(model.forecast(situation, 4).weights[1], 1.0, 1e-5);
  EXPECT_NEAR(model.forecast(situation, 4).weights.sum(), 1.0, 1e-12);
  EXPECT_EQ(model.forecast(driving(0.2, 0.0), 4).speeds(0, 0), 1.2);
}

TEST(SpeedModel, AFoldForecastsTheScenesThatItLeftOut) {
  SpeedModelWeights fold = plainWeights();
  fold.left_out_scenes = {"a", "b"};
  fold.gains.row(0).setConstant(3.0);
  SpeedModelWeights other = plainWeights();
  other.left_out_scenes = {"c"};
  other.gains.row(0).setConstant(5.0);
  const SpeedModel model(plainWeights(), {fold, other});
  const auto gain = [&](const std::string& scene) {
    return model.withoutScene(scene)->forecast(driving(8.0, 0.0), 1).speeds(0, 0) - 9.0;
  };
  EXPECT_EQ(model.forecast(driving(8.0, 0.0), 1).speeds(0, 0), 9.0);
  EXPECT_EQ(model.withoutScene("unknown"), nullptr);
  EXPECT_EQ(gain("a"), 3.0);
  EXPECT_EQ(gain("b"), 3.0);
  EXPECT_EQ(gain("c"), 5.0);
  other.left_out_scenes = {"b"};
  EXPECT_THROW(SpeedModel(plainWeights(), {fold, other}), std::invalid_argument);
}

TEST(SpeedModel, SpeedsOutOfRangeAreErrors) {
  SpeedModelWeights weights = plainWeights();
  weights.log_spreads.row(0).setConstant(1e5);
  EXPECT_THROW(SpeedModel(weights).forecast(driving(8.0, 1.0), 4), std::runtime_error);
  weights = plainWeights();
  weights.gains.row(2).setConstant(9e5);
  EXPECT_THROW(SpeedModel(weights).forecast(driving(8.0, 1.0), 4), std::runtime_error);
}

TEST(CheckWeights, NamesTheField) {
  const auto expectRefused = [](const std::string& field,
                                const std::function<void(SpeedModelWeights&)>& spoil) {
    SpeedModelWeights weights = plainWeights();
    spoil(weights);
    try {
      checkWeights(weights);
      ADD_FAILURE() << field;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).find(field + " "), 0u) << error.what();
    }
  };
  EXPECT_NO_THROW(checkWeights(plainWeights()));
  const double none = std::numeric_limits<double>::quiet_NaN();
  expectRefused("feature_weights", [](auto& w) { w.feature_weights.resize(3); });
  expectRefused("lowest", [&](auto& w) { w.lowest[2] = none; });
  expectRefused("highest", [](auto& w) { w.highest.resize(11); });
  expectRefused("centers", [](auto& w) { w.centers.resize(1, 9); });
  expectRefused("gains", [](auto& w) { w.centers.setZero(2, kSpeedFeatures); });
  expectRefused("gains", [](auto& w) { w.gains.resize(12, 0); });
  expectRefused("log_spreads", [&](auto& w) { w.log_spreads(3, 1) = none; });
  expectRefused("residuals.weights", [](auto& w) { w.residuals.weights.setOnes(3); });
  expectRefused("residuals.weights", [](auto& w) { w.residuals.weights << -0.5, 1.5; });
  expectRefused("residuals.weights", [](auto& w) { w.residuals.weights << 0.5, 0.6; });
  expectRefused("residuals.profiles", [](auto& w) { w.residuals.profiles.setZero(2, 3); });
  expectRefused("standing_speed", [&](auto& w) { w.standing_speed = none; });
  expectRefused("standing", [](auto& w) { w.standing.setZero(2, 5); });
  expectRefused("standing_shares", [](auto& w) { w.standing_shares.setZero(11, 3); });
}

}  // namespace
}  // namespace forge
