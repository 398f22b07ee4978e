#include "collision_forge/attack/forecast/speed_model_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <stdexcept>

#include "collision_forge/attack/forecast/speed_forecast_check.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

constexpr double kFastest = 100.0;  // m/s, faster than anyone

/// As shipped, but with fewer centers: the tests' drivers are simple.
SpeedModelFitOptions fewCenters() {
  SpeedModelFitOptions options =
      loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config").speed_model_fit;
  options.centers = 30;
  return options;
}

const SpeedModelFitOptions kOptions = fewCenters();

/// Normally distributed, as the standard library's distribution is not the same everywhere.
class Normal {
 public:
  explicit Normal(std::uint64_t seed) : engine_(seed) {}
  double operator()() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(engine_() >> 11) * 0x1.0p-53;
    return sum;
  }
  std::mt19937_64& engine() { return engine_; }

 private:
  std::mt19937_64 engine_;
};

/// Scenes of drivers that approach `wished` plus `by_turn` times the bend's turn, by a tenth of
/// what is missing each interval, with noise of `noise` m/s.
std::vector<SpeedProfileRow> linearDrivers(int scenes, int frames, double noise,
                                           std::uint64_t seed) {
  Normal normal(seed);
  std::vector<SpeedProfileRow> rows;
  for (int scene = 0; scene < scenes; ++scene) {
    const double turn = 0.2 * (scene % 5);
    double speed = 2.0 + static_cast<double>(normal.engine()() % 1000) / 80.0;
    for (int frame = 0; frame < frames; ++frame) {
      RoadAhead ahead;
      ahead.bend_turn = turn;
      rows.push_back({"scene-" + std::to_string(scene), frame, speed, ahead});
      speed += 0.1 * (10.0 - 5.0 * turn - speed) + noise * normal();
      speed = std::max(speed, 0.2);
    }
  }
  return rows;
}

double linearSpeedAfter(double speed, double turn, int intervals) {
  const double wished = 10.0 - 5.0 * turn;
  return wished + (speed - wished) * std::pow(0.9, intervals);
}

DrivingSituation linearSituation(double speed, double turn) {
  DrivingSituation situation;
  for (int i = 0; i < 5; ++i) {
    situation.past_speeds[static_cast<std::size_t>(i)] = linearSpeedAfter(speed, turn, -i);
  }
  situation.ahead.bend_turn = turn;
  return situation;
}

Eigen::RowVectorXd meanOf(const SpeedForecast& forecast) {
  return forecast.weights.transpose() * forecast.speeds;
}

TEST(FitSpeedModel, RecoversALinearDriver) {
  const SpeedSituations recorded(linearDrivers(60, 40, 0.0, 1));
  SpeedModelFitOptions options = kOptions;
  options.linear_ridge = 0.01;
  const SpeedModel model(fitSpeedModel(recorded, {}, options, 0));
  for (const double speed : {4.0, 8.0, 12.0}) {
    for (const double turn : {0.0, 0.4, 0.8}) {
      const SpeedForecast forecast = model.forecast(linearSituation(speed, turn), 18);
      ASSERT_EQ(forecast.speeds.cols(), 18);
      const Eigen::RowVectorXd mean = meanOf(forecast);
      for (int i = 0; i < 18; ++i) {
        EXPECT_NEAR(mean[i], linearSpeedAfter(speed, turn, i + 1), 0.15) << speed << " " << turn;
      }
    }
  }
}

TEST(FitSpeedModel, IsCalibratedOnHeldOutDrivers) {
  const SpeedSituations recorded(linearDrivers(120, 40, 0.3, 2));
  const SpeedModel model = fitSpeedModelWithFolds(recorded, 4, kOptions, 0);
  for (const ForecastErrors& errors :
       checkForecasts(recorded, model, 0.0, kFastest, {1.0, 2.0, 4.0, 6.0, 9.0})) {
    ASSERT_GT(errors.cases, 1000u);
    for (std::size_t i = 0; i < kForecastIntervals.size(); ++i) {
      EXPECT_NEAR(errors.covered[i], kForecastIntervals[i], 0.05) << errors.horizon << " s";
    }
  }
}

/// Drivers at 5 or 12 m/s; the fast ones differ from each other four times as much.
TEST(FitSpeedModel, SpreadDependsOnTheSituation) {
  std::vector<SpeedProfileRow> rows;
  Normal normal(4);
  for (int scene = 0; scene < 120; ++scene) {
    const double mean = scene % 2 == 0 ? 5.0 : 12.0;
    const double spread = scene % 2 == 0 ? 0.1 : 0.4;
    for (int frame = 0; frame < 25; ++frame) {
      rows.push_back({"scene-" + std::to_string(scene), frame, mean + spread * normal(), {}});
    }
  }
  SpeedModelFitOptions options = kOptions;
  options.spread_ridge = 1.0;
  options.linear_ridge = 0.1;
  const SpeedModel model(fitSpeedModel(SpeedSituations(rows), {}, options, 0));
  const auto spreadAt = [&](double speed) {
    DrivingSituation situation;
    situation.past_speeds.fill(speed);
    const SpeedForecast forecast = model.forecast(situation, 6);
    const Eigen::MatrixXd differences = forecast.speeds.rowwise() - meanOf(forecast);
    return std::sqrt(forecast.weights.dot(differences.col(3).cwiseAbs2()));
  };
  EXPECT_NEAR(spreadAt(5.0), 0.1, 0.03);
  EXPECT_NEAR(spreadAt(12.0), 0.4, 0.12);
}

TEST(FitSpeedModel, ShortProfilesAreUsed) {
  std::vector<SpeedProfileRow> rows;
  for (int scene = 0; scene < 80; ++scene) {
    // The long profiles are slow, the short ones fast: without these no profile reaches 15 m/s.
    const bool is_long = scene % 2 == 0;
    const double speed = (is_long ? 4.0 : 15.0) + 0.02 * scene;
    const double gain = is_long ? 0.0 : -0.2;
    for (int frame = 0; frame < (is_long ? 24 : 8); ++frame) {
      rows.push_back({"scene-" + std::to_string(scene), frame, speed + gain * frame, {}});
    }
  }
  const SpeedModel model(fitSpeedModel(SpeedSituations(rows), {}, kOptions, 0));
  DrivingSituation situation;
  situation.past_speeds = {14.4, 14.6, 14.8, 15.0, 15.2};
  const SpeedForecast forecast = model.forecast(situation, 18);
  ASSERT_EQ(forecast.speeds.cols(), 18);
  EXPECT_NEAR(meanOf(forecast)[3], 14.4 - 0.8, 0.15);
}

TEST(FitSpeedModel, LeftOutScenesHaveNoInfluence) {
  std::vector<SpeedProfileRow> kept = linearDrivers(40, 25, 0.2, 6);
  std::vector<SpeedProfileRow> all = kept;
  for (int frame = 0; frame < 40; ++frame) all.push_back({"odd", frame, 3.0 + frame, {}});
  const SpeedModelWeights without = fitSpeedModel(SpeedSituations(all), {"odd"}, kOptions, 3);
  const SpeedModelWeights never = fitSpeedModel(SpeedSituations(kept), {}, kOptions, 3);
  EXPECT_EQ(without.left_out_scenes, std::vector<std::string>{"odd"});
  EXPECT_EQ(without.gains, never.gains);
  EXPECT_EQ(without.log_spreads, never.log_spreads);
  EXPECT_EQ(without.residuals.profiles, never.residuals.profiles);
  EXPECT_NE(fitSpeedModel(SpeedSituations(all), {}, kOptions, 3).gains, never.gains);
}

TEST(FitSpeedModel, FoldsLeaveEachSceneOutOnce) {
  const SpeedSituations recorded(linearDrivers(43, 25, 0.2, 6));
  const SpeedModel model = fitSpeedModelWithFolds(recorded, 4, kOptions, 1);
  EXPECT_TRUE(model.weights().left_out_scenes.empty());
  ASSERT_EQ(model.folds().size(), 4u);
  std::set<std::string> left_out;
  for (const auto& model_fold : model.folds()) {
    const SpeedModelWeights& fold = model_fold->weights();
    EXPECT_GE(fold.left_out_scenes.size(), 10u);
    EXPECT_LE(fold.left_out_scenes.size(), 11u);
    left_out.insert(fold.left_out_scenes.begin(), fold.left_out_scenes.end());
    EXPECT_EQ(fold.gains, fitSpeedModel(recorded, fold.left_out_scenes, kOptions, 1).gains);
  }
  EXPECT_EQ(left_out.size(), 43u);
  std::vector<std::size_t> fitted;
  fitSpeedModelWithFolds(recorded, 4, kOptions, 1, [&](std::size_t done, std::size_t all) {
    fitted.push_back(done);
    EXPECT_EQ(all, 5u);
  });
  EXPECT_EQ(fitted, (std::vector<std::size_t>{1, 2, 3, 4, 5}));
  EXPECT_TRUE(fitSpeedModelWithFolds(recorded, 0, kOptions, 1).folds().empty());
}

TEST(FitSpeedModel, RejectsTooFewProfiles) {
  EXPECT_THROW(fitSpeedModel(SpeedSituations({}), {}, kOptions, 0), std::invalid_argument);
  EXPECT_THROW(fitSpeedModel(SpeedSituations(linearDrivers(5, 8, 0.1, 1)), {}, kOptions, 0),
               std::invalid_argument);
  EXPECT_THROW(fitSpeedModel(SpeedSituations(linearDrivers(1, 300, 0.1, 1)), {}, kOptions, 0),
               std::invalid_argument);
  const SpeedSituations three(linearDrivers(3, 100, 0.1, 1));
  for (const int folds : {-1, 1, 4}) {
    EXPECT_THROW(fitSpeedModelWithFolds(three, folds, kOptions, 0), std::invalid_argument) << folds;
  }
  EXPECT_EQ(fitSpeedModelWithFolds(three, 3, kOptions, 0).folds().size(), 3u);
}

}  // namespace
}  // namespace forge
