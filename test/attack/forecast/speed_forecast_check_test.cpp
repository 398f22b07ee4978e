#include "collision_forge/attack/forecast/speed_forecast_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace forge {
namespace {

constexpr double kFastest = std::numeric_limits<double>::infinity();

/// Forecasts the same gains everywhere; records the scenes passed to withoutScene().
class SameGains : public SpeedForecaster {
 public:
  SameGains(Eigen::VectorXd gains, Eigen::VectorXd weights, int known = 100)
      : gains_(std::move(gains)), weights_(std::move(weights)), known_(known) {}

  SpeedForecast forecast(const DrivingSituation& situation, int intervals) const override {
    const Eigen::VectorXd speeds = gains_.array() + situation.past_speeds[0];
    return {speeds.replicate(1, std::min(intervals, known_)), weights_};
  }

  std::shared_ptr<const SpeedForecaster> withoutScene(const std::string& scene) const override {
    left_out_.push_back(scene);
    return nullptr;
  }

  const std::vector<std::string>& leftOut() const { return left_out_; }

 private:
  Eigen::VectorXd gains_;
  Eigen::VectorXd weights_;
  int known_;
  mutable std::vector<std::string> left_out_;
};

/// Two rows in each scene: 10 m/s, then 10 m/s and a gain.
SpeedSituations oneStep(const std::vector<double>& gains) {
  std::vector<SpeedProfileRow> rows;
  for (const double gain : gains) {
    const std::string scene = std::to_string(rows.size());
    rows.push_back({scene, 0, 10.0, {}});
    rows.push_back({scene, 1, 10.0 + gain, {}});
  }
  return SpeedSituations(rows);
}

TEST(CheckForecasts, ErrorIsTheErrorOfTheMeanDistance) {
  const SameGains forecaster(Eigen::Vector2d(2.0, 6.0), Eigen::Vector2d(0.75, 0.25));
  const auto errors = checkForecasts(oneStep({1.0, 7.0}), forecaster, 0.0, kFastest, {0.5});
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].horizon, 0.5);
  EXPECT_EQ(errors[0].cases, 2u);
  EXPECT_NEAR(errors[0].error, 0.5 * (2.0 + 4.0) / 2.0, 1e-12);
  EXPECT_EQ(forecaster.leftOut(), (std::vector<std::string>{"0", "0", "2", "2"}));
}

TEST(CheckForecasts, RankedScoreMatchesItsDefinition) {
  Eigen::VectorXd gains(3);
  gains << 4.0, -1.0, 2.5;
  Eigen::VectorXd weights(3);
  weights << 0.2, 0.5, 0.3;
  double expected = 0.0;
  for (int i = 0; i < 3; ++i) {
    expected += weights[i] * std::abs(gains[i] - 1.0);
    for (int j = 0; j < 3; ++j) {
      expected -= 0.5 * weights[i] * weights[j] * std::abs(gains[i] - gains[j]);
    }
  }
  const auto errors =
      checkForecasts(oneStep({1.0}), SameGains(gains, weights), 0.0, kFastest, {0.5});
  EXPECT_NEAR(errors[0].ranked, 0.5 * expected, 1e-12);
}

TEST(CheckForecasts, CoverageIsTheShareOfCentralRanks) {
  const Eigen::VectorXd gains = Eigen::VectorXd::LinSpaced(1001, -5.0, 5.0);
  const Eigen::VectorXd weights = Eigen::VectorXd::Constant(1001, 1.0 / 1001);
  // Ranks 0.5, 0.7, 0.85, 0.93 and beyond.
  const auto errors = checkForecasts(oneStep({0.0, 2.0, 3.5, 4.3, 6.0}), SameGains(gains, weights),
                                     0.0, kFastest, {0.5});
  EXPECT_NEAR(errors[0].covered[0], 0.4, 1e-3);
  EXPECT_NEAR(errors[0].covered[1], 0.6, 1e-3);
  EXPECT_NEAR(errors[0].covered[2], 0.8, 1e-3);
}

TEST(CheckForecasts, UsesRowsInTheSpeedRangeThatAreLongEnough) {
  std::vector<SpeedProfileRow> rows;
  for (int i = 0; i < 10; ++i) rows.push_back({"a", i, 1.0 * i, {}});
  const SpeedSituations recorded(rows);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  const auto errors = checkForecasts(recorded, SameGains(one, one), 2.0, 6.0, {1.0, 2.0, 3.0});
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_EQ(errors[0].cases, 4u);  // 2, 3, 4 and 5 m/s
  EXPECT_EQ(errors[1].cases, 4u);
  EXPECT_EQ(errors[2].cases, 2u);  // 4 m/s and more last five intervals
  EXPECT_EQ(checkForecasts(recorded, SameGains(one, one, 3), 2.0, 6.0, {2.0})[0].cases, 0u);
}

}  // namespace
}  // namespace forge
