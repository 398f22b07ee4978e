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
  std::string out;              ///< output folder
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
/// Writes to `arguments.out`: planners.yaml with the best values; variants.csv, a row per variant;
/// table.md and table.csv, which compare the default and the best variant; train.jsonl and
/// test.jsonl, the results of the cases. Writes the HTML report to `arguments.report` unless that
/// is empty. Returns kExitOk.
///
/// `open` is called once, with the loaded configuration, after the folders are locked. Throws
/// ConfigError, PlannerFileError, the exceptions of lockFolders(), testCases() and `open`, and
/// std::runtime_error if the training cases have no avoidable collision.
int tunePlanner(const TuningArguments& arguments,
                const std::function<TuningCases(const Config&)>& open);

/// Adds --planner, addOwnPlanners(), --grid, addSource() (required), --background, --out, --jobs,
/// --report and --config; `arguments` must live until the command has run.
void addTuningOptions(CLI::App& app, TuningArguments& arguments);

}  // namespace forge
