#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/forecast/speed_forecast_check.h"
#include "collision_forge/attack/forecast/speed_model_fit.h"
#include "collision_forge/attack/forecast/speed_profile_collection.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/weights/speed_model_file.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

const std::vector<double> kHorizons = {2.0, 3.0, 4.0, 5.0, 6.0};  // s
constexpr double kDriving = 2.0;  // m/s; slower cases are reported separately

struct Arguments {
  LogSource logs;
  std::string out;
  ConfigFolder config;
  int folds = 5;
  std::uint64_t seed = 0;
};

void printErrors(const char* title, const SpeedSituations& recorded,
                 const SpeedForecaster& forecaster, double min_speed, double max_speed) {
  const auto begin = std::chrono::steady_clock::now();
  const auto errors = checkForecasts(recorded, forecaster, min_speed, max_speed, kHorizons);
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
  for (const ForecastErrors& entry : errors) {
    std::printf("| %s | %g | %zu | %.3f | %.3f | %.1f %% | %.1f %% | %.1f %% |\n", title,
                entry.horizon, entry.cases, entry.error, entry.ranked, 100.0 * entry.covered[0],
                100.0 * entry.covered[1], 100.0 * entry.covered[2]);
  }
  std::fprintf(stderr, "%s: %.1f s\n", title, duration.count());
}

/// Prints the errors and interval coverage of forecasts on held-out scenes.
void check(const SpeedSituations& recorded, const SpeedForecaster& model) {
  constexpr double kFastest = std::numeric_limits<double>::infinity();
  std::printf(
      "| held out | s | cases | mean error, m | CRPS, m | in central 50 %% | 80 %% | 90 %% |\n"
      "|---|---|---|---|---|---|---|---|\n");
  printErrors("driving", recorded, model, kDriving, kFastest);
  printErrors("slow", recorded, model, -kFastest, kDriving);
}

/// Rounds to thousandths, so that floating-point differences between machines do not change the
/// model.
void roundValues(SpeedProfileRow& row) {
  constexpr double kThousandths = 1e3;
  RoadAhead& ahead = row.ahead;
  for (double* const value : {&row.speed, &ahead.turn_rate, &ahead.bend_braking, &ahead.bend_turn,
                              &ahead.bend_curvature, &ahead.headway, &ahead.closing}) {
    *value = std::round(*value * kThousandths) / kThousandths + 0.0;
  }
}

/// Collects the speed profiles of the egos of all scenes. Sets `unreadable` to the problems of
/// SceneSource::forEach().
SpeedSituations collect(const LogSource& logs, const StudyConfig& config,
                        std::vector<std::string>& unreadable) {
  SceneSource scenes(logs, {}, config, 1, printWarnings, showReading());
  const std::size_t count = scenes.names().size();
  std::vector<SpeedProfileRow> rows;
  ProgressLine progress("scenes");
  std::size_t done = 0;
  const auto add = [&](const IndexedScene& indexed) {
    for (SpeedProfileRow& row : collectSpeedProfiles(indexed.scene, *indexed.lanes)) {
      roundValues(row);
      rows.push_back(std::move(row));
    }
    progress.show(++done, count);
  };
  unreadable = scenes.forEach(add);
  return SpeedSituations(std::move(rows));
}

/// Fits the model; adds the path of the logs and `unreadable` to error messages.
SpeedModel fitTo(const SpeedSituations& recorded, const std::vector<std::string>& unreadable,
                 const Arguments& arguments, const StudyConfig& config) {
  ProgressLine progress("models");
  try {
    return fitSpeedModelWithFolds(
        recorded, arguments.folds, config.speed_model_fit, arguments.seed,
        [&](std::size_t done, std::size_t all) { progress.show(done, all); });
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(arguments.logs.path + ": no model can be fitted: " + error.what() +
                             unreadableText(unreadable));
  }
}

int fit(const Arguments& arguments) {
  const StudyConfig config = loadStudyConfig(arguments.config);
  const OutputLock lock = OutputLock::ofFile(arguments.out);
  std::vector<std::string> unreadable;
  const SpeedSituations recorded = collect(arguments.logs, config, unreadable);
  const SpeedModel fitted = fitTo(recorded, unreadable, arguments, config);
  writeSpeedModel(fitted, arguments.out);
  std::printf("%d intervals of %zu scenes\n", static_cast<int>(fitted.weights().gains.cols()),
              recorded.scenes().size());
  if (arguments.folds > 0)
    check(recorded, readSpeedModel(arguments.out));  // as it is used, rounded
  return exitAfterUnreadable(unreadable);
}

}  // namespace

void addSpeedsFit(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kTraining, "study speeds fit", "Fits the speed model of drivers to recorded egos.",
               [arguments] { return fit(*arguments); });
  addSource(app, arguments->logs)->required();
  addOut(app, arguments->out, "output model file");
  app.add_option(
         "--folds", arguments->folds,
         "number of additional models for cross-validation, each leaves a part of the scenes out; "
         "0: none, else at least 2")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  addSeed(app, arguments->seed, "random seed of clustering and folds");
  addConfig(app, arguments->config);
}

}  // namespace forge
