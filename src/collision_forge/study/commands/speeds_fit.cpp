#include <chrono>
#include <iostream>
#include <limits>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/forecast/speed_forecast_check.h"
#include "collision_forge/attack/forecast/speed_model_fit.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/weights/speed_model_file.h"
#include "collision_forge/io/weights/speed_profiles_file.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

const std::vector<double> kHorizons = {2.0, 3.0, 4.0, 5.0, 6.0};  // s
constexpr double kDriving = 2.0;  // m/s; slower cases are told apart

struct Arguments {
  std::string profiles;
  std::string out;
  std::string config;
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

/// Of scenes that a forecast was made without: how far it was off, and how often within.
void compare(const SpeedSituations& recorded, const SpeedForecaster& model,
             const SpeedForecaster& profiles) {
  constexpr double kFastest = std::numeric_limits<double>::infinity();
  std::printf(
      "| held out | s | cases | mean error, m | CRPS, m | in central 50 %% | 80 %% | 90 %% |\n"
      "|---|---|---|---|---|---|---|---|\n");
  printErrors("model, driving", recorded, model, kDriving, kFastest);
  printErrors("profiles, driving", recorded, profiles, kDriving, kFastest);
  printErrors("model, slow", recorded, model, -kFastest, kDriving);
  printErrors("profiles, slow", recorded, profiles, -kFastest, kDriving);
}

/// Names the file in what is wrong.
SpeedModel fitTo(const SpeedSituations& recorded, const Arguments& arguments,
                 const StudyConfig& config) {
  ProgressLine progress("models");
  try {
    return fitSpeedModelWithFolds(
        recorded, arguments.folds, config.speed_model_fit, arguments.seed,
        [&](std::size_t done, std::size_t all) { progress.show(done, all); });
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(arguments.profiles + ": no model can be fitted: " + error.what());
  }
}

int fit(const Arguments& arguments) {
  const StudyConfig config = loadStudyConfig(arguments.config);
  const OutputLock lock = OutputLock::ofFile(arguments.out);
  const SpeedSituations recorded = readSpeedSituations(arguments.profiles);
  const SpeedModel fitted = fitTo(recorded, arguments, config);
  writeSpeedModel(fitted, arguments.out);
  std::printf("%d intervals of %zu scenes\n", static_cast<int>(fitted.weights().gains.cols()),
              recorded.scenes().size());
  if (arguments.folds == 0) return kExitOk;
  const SpeedModel model = readSpeedModel(arguments.out);  // as it is used, rounded
  compare(recorded, model, SpeedProfiles(recorded, config.recorded_speeds));
  return kExitOk;
}

}  // namespace

void addSpeedsFit(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kTraining, "study speeds fit",
                           "Fits a model of how drivers change their speed to these.",
                           [arguments] { return fit(*arguments); });
  app.add_option("--profiles", arguments->profiles, "CSV of forge study speeds collect")
      ->required();
  addOut(app, arguments->out, "file of the model to write");
  app.add_option(
         "--folds", arguments->folds,
         "further models that leave each scene out once, to measure on the scenes fitted to; "
         "0: none, else 2 at least")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  addSeed(app, arguments->seed, "of what is drawn");
  addConfig(app, arguments->config);
}

}  // namespace forge
