#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/files/resumable_file.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/planner_cases.h"
#include "collision_forge/planner_test/trials/traffic.h"

/// The tuning of a planner, whatever the cases are.
namespace forge {

struct TuningArguments {
  std::string planner = "pdm";
  std::string planner_file;
  std::string grid;  ///< empty: tuning.yaml of the configuration
  LogSource logs;
  Background background = Background::kReplay;
  std::string out;
  std::string report;
  ConfigFolder config;
  int jobs = defaultJobs();
};

/// The cases that a planner is tuned on and those that it is compared on; no scene is in both.
struct TuningCases {
  std::unique_ptr<PlannerCases> train;
  std::unique_ptr<PlannerCases> test;
  /// Scenario files of `test` for the page of --report.
  std::vector<std::string> test_files = {};
  ResumableFile::Options fingerprints = {};  ///< what else the results depend on
};

/// Tunes a planner on the cases that `open` returns, or goes on where a run stopped; writes
/// planners.yaml, tables and the page to the folders of `arguments`. Returns an exit code. Throws
/// ConfigError, PlannerFileError and what lockFolders() and `open` throw.
int tunePlanner(const TuningArguments& arguments,
                const std::function<TuningCases(const Config&)>& open);

/// --planner, --planner-file, --grid, --source, --background, --out, --jobs, --report and --config.
void addTuningOptions(CLI::App& app, TuningArguments& arguments);

}  // namespace forge
