#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/app/options.h"
#include "collision_forge/base/files/resumable_file.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/planner_cases.h"
#include "collision_forge/planner_test/trials/traffic.h"

/// Grid search over the parameters of a planner, independent of the source of the test cases.
namespace forge {

/// The command-line arguments of a tuning run.
struct TuningArguments {
  std::string planner = "pdm";  ///< one of plannerNames()
  OwnPlanners own_planners;     ///< files and commands of the user's planners
  std::string grid;  ///< YAML file with the values; empty: tuning.yaml of the configuration
  LogSource logs;    ///< recordings of the cases, for fingerprints and the HTML report
  BackgroundChoice background;  ///< motion of other agents; only the first background is used
  std::string out;              ///< output folder, must not be empty
  std::string report;           ///< folder of the HTML report; empty: none
  ConfigFolder config;
  int jobs = defaultJobs();  ///< threads
};

/// Training and test cases of a tuning run. No scene may be in both; the caller checks this
/// (checkHeldOut()). Neither pointer is null.
struct TuningCases {
  std::unique_ptr<PlannerCases> train;       ///< used to choose the best variant
  std::unique_ptr<PlannerCases> test;        ///< used to compare it with the default
  std::vector<std::string> test_files = {};  ///< scenario files of `test`, for the HTML report
  ResumableFile::Options fingerprints = {};  ///< inputs of the results besides these cases
};

/// Tunes a planner on the cases that `open` returns; resumes an interrupted run. Tests every
/// variant of the grid on the training cases, then the default and the best one on the test cases.
/// The best variant has the lowest share of collisions (isCollision()) in the avoidable training
/// cases; of equals the one with the greatest mean progress, then the first (bestVariant()): the
/// default may be the best.
/// Writes to `arguments.out`: planners.yaml with the best values; variants.csv, a row per variant
/// (scoresCsv()); table.md and table.csv, which compare the default and the best variant;
/// train.jsonl and test.jsonl, the results of the cases (docs/planners.md). Writes the HTML report
/// to `arguments.report` unless that is empty. Returns kExitOk.
///
/// `open` is called once, with the loaded configuration, after the folders are locked. Throws
/// ConfigError (also for a planner without a section in the grid), PlannerFileError, the exceptions
/// of lockFolders(), variantsOf(), testCases(), writeReport() and `open`, and std::runtime_error if
/// the training cases have no avoidable collision or a file cannot be written.
int tunePlanner(const TuningArguments& arguments,
                const std::function<TuningCases(const Config&)>& open);

/// Adds --planner, addOwnPlanners(), --grid, addSource(), --background, --out, --jobs, --report and
/// --config (addConfig()). addSource() and --out are required, the others optional. `arguments`
/// must live until the command has run.
void addTuningOptions(CLI::App& app, TuningArguments& arguments);

}  // namespace forge
