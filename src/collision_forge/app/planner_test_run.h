#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/report/write_report.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/kept_drives.h"
#include "collision_forge/planner_test/trials/planner_cases.h"
#include "collision_forge/planner_test/trials/planner_run.h"

/// A test of planners in closed loop, whatever the cases are.
namespace forge {

struct PlannerTestArguments {
  LogSource logs;
  std::vector<std::string> planners = {"idm", "rule_based", "pdm"};
  std::string planner_file;
  std::vector<std::string> policies = {"fixed"};
  Background background = Background::kReplay;
  std::size_t worst = 3;
  std::string out;
  std::string report;
  ConfigFolder config;
  int jobs = defaultJobs();
};

/// --planners, --planner-file, --background, --worst, --out, --jobs, --report and --config.
void addPlannerTestOptions(CLI::App& app, PlannerTestArguments& arguments);

/// Reads the configuration and holds the locks of the output folders.
class PlannerTestRun {
 public:
  /// Throws ConfigError, PlannerFileError, and what lockFolders() throws.
  explicit PlannerTestRun(PlannerTestArguments arguments);

  const Config& config() const { return config_; }
  const TestPlan& plan() const { return plan_; }
  const std::string& resultsPath() const { return results_path_; }

  /// Drives the planners through the cases, or goes on where a run stopped. `fingerprints`: what
  /// the results depend on beside the configuration, the logs, the cases and the planners. The
  /// master writes tables and pictures to OUT, prints the summary and returns the results; other
  /// ranks return none. Throws std::runtime_error where no case could be tested.
  std::vector<PlannerTestResult> run(const PlannerCases& cases,
                                     const ResumableFile::Options& fingerprints = {}) const;

  /// Writes the page of --report, where it is asked for, of `attacks` and of the results.
  void writePage(const std::vector<std::string>& attacks, const LogSource& logs) const;

 private:
  ResumableFile::Options runOptions(const PlannerCases& cases) const;
  void writeTables(const std::vector<PlannerTestResult>& results) const;
  void drawWorst(const PlannerCases& cases, const std::vector<PlannerTestResult>& results,
                 const KeptDrives& drives) const;

  const PlannerTestArguments arguments_;
  Config config_;
  const OutputLocks locks_;
  const TestPlan plan_;
  const std::string results_path_;
};

}  // namespace forge
