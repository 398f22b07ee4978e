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
  LogSource logs;
  BackgroundChoice background;  ///< motion of other agents, one
  std::string out;              ///< output folder
  std::string report;           ///< folder of the HTML report; empty: none
  ConfigFolder config;
  int jobs = defaultJobs();  ///< threads
};

/// Training and test cases of a tuning run. No scene may be in both.
struct TuningCases {
  std::unique_ptr<PlannerCases> train;       ///< used to choose the best variant
  std::unique_ptr<PlannerCases> test;        ///< used to compare it with the default
  std::vector<std::string> test_files = {};  ///< scenario files of `test`, for the HTML report
  ResumableFile::Options fingerprints = {};  ///< further inputs of the results
};

/// Tunes a planner on the cases that `open` returns; resumes an interrupted run. Writes the tuned
/// planners.yaml, tables and the HTML report to the folders of `arguments`. Returns an ExitCode.
/// Throws ConfigError, PlannerFileError and the exceptions of lockFolders() and `open`.
int tunePlanner(const TuningArguments& arguments,
                const std::function<TuningCases(const Config&)>& open);

/// Adds --planner, addOwnPlanners(), --grid, --source, --background, --out, --jobs, --report,
/// --config.
void addTuningOptions(CLI::App& app, TuningArguments& arguments);

}  // namespace forge
